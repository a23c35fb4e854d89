//! Accepts or rejects a certificate.

use giveway_model::format::native;

use crate::again::{Named, check_claims, check_plan, check_proof};
use crate::bundle::{Bundle, INSTANCE, MANIFEST, Manifest, PLAN, README, fingerprint, proof_files};
use crate::conclude::{Conclusion, Whole, check_together, conclude};
use crate::report::Fault;
use crate::solved::objective;
use crate::{Budget, Checked, Report};

/// Checks a certificate: that its files belong together, that each formula is
/// the one of its claim, that each proof holds, that each search ends the same.
pub fn verify(bundle: &Bundle, budget: &Budget<'_>) -> Report {
    Report::of(|claims| check_all(bundle, budget, claims))
}

fn check_all(
    bundle: &Bundle,
    budget: &Budget<'_>,
    claims: &mut Vec<Checked>,
) -> Result<Option<Conclusion>, Fault> {
    let manifest = read_manifest(bundle)?;
    check_files(bundle, &manifest)?;
    let instance = native::read_instance(text(bundle, INSTANCE)?)
        .map_err(|_| Fault::of(INSTANCE, "it is not an instance"))?;
    let mut plan = None;
    if manifest.costs.is_some() {
        let read = native::read_plan(text(bundle, PLAN)?);
        let read = read.map_err(|_| Fault::of(PLAN, "it is not a plan"))?;
        check_plan(&instance, &read, manifest.costs)?;
        plan = Some(read);
    }
    check_together(&Whole {
        instance: &instance,
        plan: plan.as_ref(),
        entries: &manifest.claims,
    })?;
    if text(bundle, README)? != manifest.readme(&instance) {
        return Err(Fault::of(README, "it does not say what the manifest says"));
    }
    check_claims(&instance, &manifest.claims, budget, claims, &|named| {
        check_files_of(bundle, named, budget)
    })?;
    if manifest.objective != objective(&instance) {
        return Err(Fault::of(
            MANIFEST,
            "its objective is not that of the instance",
        ));
    }
    Ok(conclude(
        &manifest.objective,
        manifest.costs,
        &manifest.claims,
    ))
}

fn text<'a>(bundle: &'a Bundle, file: &str) -> Result<&'a str, Fault> {
    let bytes = bundle
        .get(file)
        .ok_or_else(|| Fault::of(file, "it is missing"))?;
    std::str::from_utf8(bytes).map_err(|_| Fault::of(file, "it is not text"))
}

/// The manifest, which has one text only.
fn read_manifest(bundle: &Bundle) -> Result<Manifest, Fault> {
    let text = text(bundle, MANIFEST)?;
    let manifest: Manifest = native::read_object(text)
        .map_err(|fault| Fault::Rejected(format!("{MANIFEST}: {fault}.")))?;
    if manifest.version != 1 {
        return Err(Fault::of(MANIFEST, "its version is not 1"));
    }
    if manifest.text() != text {
        return Err(Fault::of(MANIFEST, "it is not laid out as it was written"));
    }
    Ok(manifest)
}

/// The files are those that the claims need, no more and no less, each as it
/// was written.
fn check_files(bundle: &Bundle, manifest: &Manifest) -> Result<(), Fault> {
    let expected = manifest.expected();
    let expected = expected.ok_or_else(|| Fault::of(MANIFEST, "its proofs have other names"))?;
    if !manifest.files.keys().eq(&expected) {
        return Err(Fault::of(MANIFEST, "its files are not those of its claims"));
    }
    for (file, recorded) in &manifest.files {
        let bytes = bundle
            .get(file)
            .ok_or_else(|| Fault::of(file, "it is missing"))?;
        if fingerprint(bytes) != *recorded {
            return Err(Fault::of(file, "it was changed: its fingerprint differs"));
        }
    }
    for file in bundle.keys() {
        if file != MANIFEST && !expected.contains(file) {
            return Err(Fault::of(file, "it does not belong to the certificate"));
        }
    }
    Ok(())
}

/// Writes the formula again, compares, and checks the proof.
fn check_files_of(bundle: &Bundle, named: &Named<'_>, budget: &Budget<'_>) -> Result<usize, Fault> {
    let [cnf, drat, names] = proof_files(named.name);
    let formula = named.formula(budget)?;
    let written = text(bundle, &cnf)?;
    if written != formula.text() {
        return Err(Fault::of(&cnf, "it is not the formula of its claim"));
    }
    if text(bundle, &names)? != formula.names_text(named.instance) {
        return Err(Fault::of(
            &names,
            "it does not name the variables as they are",
        ));
    }
    drop(formula);
    check_proof(written, text(bundle, &drat)?, &drat, budget)
}
