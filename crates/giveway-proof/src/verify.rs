//! Accepts or rejects a certificate.

use std::collections::BTreeSet;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::format::native;
use giveway_model::{Instance, Version, check};
use serde::{Deserialize, Serialize};

use crate::bundle::manifest::fingerprint;
use crate::bundle::{
    Bundle, Entry, INSTANCE, MANIFEST, Manifest, Method, PLAN, README, proof_files, readme,
};
use crate::drat::{self, Refused};
use crate::{Budget, Claim, plain};

/// What came of checking a certificate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Report {
    /// The format's version.
    pub giveway: Version,
    /// Whether every file is as it was written and every claim was shown again,
    /// but for those that are said to have nothing to be shown by.
    pub accepted: bool,
    /// Why it was not accepted: a sentence; `null` where it was.
    pub reason: Option<String>,
    /// Whether the check ended before it came to a result.
    pub stopped: bool,
    /// The claims that were checked, in their order.
    pub claims: Vec<Checked>,
}

/// A claim that was checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Checked {
    /// Its proof was checked.
    Proof {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// The variables of its formula.
        variables: usize,
        /// The clauses of its formula.
        clauses: usize,
        /// The steps of the proof that were needed.
        steps: usize,
    },
    /// It rests on a search, which was repeated.
    Search {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// What was searched.
        method: Method,
    },
    /// Nothing shows it.
    None {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// Why: a sentence.
        why: String,
    },
}

/// Why a certificate was not accepted.
enum Fault {
    Rejected(String),
    Stopped(String),
}

impl Fault {
    fn of(file: &str, what: &str) -> Self {
        Self::Rejected(format!("{file}: {what}."))
    }
}

/// Checks a certificate: that its files belong together, that each formula is
/// the one of its claim, that each proof holds, that each search ends the same.
pub fn verify(bundle: &Bundle, budget: &Budget<'_>) -> Report {
    let mut claims = Vec::new();
    let fault = check_all(bundle, budget, &mut claims).err();
    let (reason, stopped) = match fault {
        None => (None, false),
        Some(Fault::Rejected(reason)) => (Some(reason), false),
        Some(Fault::Stopped(reason)) => (Some(reason), true),
    };
    Report {
        giveway: Version,
        accepted: reason.is_none(),
        reason,
        stopped,
        claims,
    }
}

fn check_all(bundle: &Bundle, budget: &Budget<'_>, claims: &mut Vec<Checked>) -> Result<(), Fault> {
    let manifest = read_manifest(bundle)?;
    check_files(bundle, &manifest)?;
    let instance = native::read_instance(text(bundle, INSTANCE)?)
        .map_err(|_| Fault::of(INSTANCE, "it is no instance"))?;
    if text(bundle, README)? != readme::text(&manifest, &instance) {
        return Err(Fault::of(README, "it does not say what the manifest says"));
    }
    check_plan(bundle, &manifest, &instance)?;
    for entry in &manifest.claims {
        (budget.tell)(entry.claim());
        claims.push(check_entry(bundle, &instance, entry, budget)?);
    }
    Ok(())
}

fn text<'a>(bundle: &'a Bundle, file: &str) -> Result<&'a str, Fault> {
    let bytes = bundle
        .get(file)
        .ok_or_else(|| Fault::of(file, "it is missing"))?;
    std::str::from_utf8(bytes).map_err(|_| Fault::of(file, "it is no text"))
}

/// The manifest, which has one text only.
fn read_manifest(bundle: &Bundle) -> Result<Manifest, Fault> {
    let text = text(bundle, MANIFEST)?;
    let manifest: Manifest = native::read_object(text)
        .map_err(|fault| Fault::Rejected(format!("{MANIFEST}: {fault}.")))?;
    if manifest.version != 1 {
        return Err(Fault::of(MANIFEST, "it is of another version than 1"));
    }
    if manifest.text() != text {
        return Err(Fault::of(MANIFEST, "it is not laid out as it was written"));
    }
    Ok(manifest)
}

/// The files are those that the claims need, no more and no less, each as it
/// was written.
fn check_files(bundle: &Bundle, manifest: &Manifest) -> Result<(), Fault> {
    let mut expected = BTreeSet::from([README.to_owned(), INSTANCE.to_owned()]);
    if manifest.costs.is_some() {
        expected.insert(PLAN.to_owned());
    }
    for entry in &manifest.claims {
        if let Entry::Proof { name, .. } = entry {
            for file in proof_files(name) {
                if !expected.insert(file) {
                    return Err(Fault::of(MANIFEST, "two proofs have one name"));
                }
            }
        }
    }
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

/// The plan keeps the rules and costs what is said.
fn check_plan(bundle: &Bundle, manifest: &Manifest, instance: &Instance) -> Result<(), Fault> {
    let Some(costs) = manifest.costs else {
        return Ok(());
    };
    let plan =
        native::read_plan(text(bundle, PLAN)?).map_err(|_| Fault::of(PLAN, "it is no plan"))?;
    let report = check::check(instance, &plan);
    if let Some(violation) = report.violations.first() {
        return Err(Fault::Rejected(format!("{PLAN}: {}", violation.message)));
    }
    if report.costs != Some(costs) {
        return Err(Fault::of(PLAN, "it does not cost what the manifest says"));
    }
    Ok(())
}

fn check_entry(
    bundle: &Bundle,
    instance: &Instance,
    entry: &Entry,
    budget: &Budget<'_>,
) -> Result<Checked, Fault> {
    let claim = entry.claim().clone();
    let text = claim.sentence();
    match entry {
        Entry::Proof {
            name,
            variables,
            clauses,
            ..
        } => {
            let steps = check_proof(
                bundle,
                instance,
                &claim,
                name,
                (*variables, *clauses),
                budget,
            )?;
            Ok(Checked::Proof {
                text,
                claim,
                variables: *variables,
                clauses: *clauses,
                steps,
            })
        }
        Entry::Search { method, .. } => {
            // A search knows no horizon: it must be about plans of any makespan.
            let shown = match claim.within {
                Some(_) => Some(false),
                None => method.shows(instance, &claim, budget),
            };
            match shown {
                Some(true) => Ok(Checked::Search {
                    text,
                    claim,
                    method: *method,
                }),
                Some(false) => Err(Fault::Rejected(format!("The search does not show: {text}"))),
                None => Err(Fault::Stopped(format!(
                    "The search ended too early to show: {text}"
                ))),
            }
        }
        Entry::None { why, .. } => Ok(Checked::None {
            text,
            claim,
            why: why.clone(),
        }),
    }
}

/// Writes the formula again, compares, and checks the proof.
fn check_proof(
    bundle: &Bundle,
    instance: &Instance,
    claim: &Claim,
    name: &str,
    size: (usize, usize),
    budget: &Budget<'_>,
) -> Result<usize, Fault> {
    let [cnf, drat, names] = proof_files(name);
    let formula = plain::formula(instance, claim, budget).map_err(|error| match error {
        plain::NoFormula::NoHorizon => Fault::of(MANIFEST, "a claim with a proof has no horizon"),
        plain::NoFormula::NoAgent => Fault::of(MANIFEST, "a claim is about no agent"),
        plain::NoFormula::TooLarge => Fault::Stopped(format!("{cnf}: it is too large to check.")),
    })?;
    if size != (formula.variables(), formula.clauses()) {
        return Err(Fault::of(MANIFEST, "the size of a formula differs"));
    }
    let written = text(bundle, &cnf)?;
    if written != formula.text() {
        return Err(Fault::of(&cnf, "it is not the formula of its claim"));
    }
    if text(bundle, &names)? != formula.names_text(instance) {
        return Err(Fault::of(
            &names,
            "it does not name the variables as they are",
        ));
    }
    drop(formula);
    match drat::check(written, text(bundle, &drat)?, budget.go_on) {
        Ok(proved) => Ok(proved.steps),
        Err(Refused::Stopped) => Err(Fault::Stopped(format!("{drat}: the check was stopped."))),
        Err(refused) => Err(Fault::of(&drat, &refused.to_string())),
    }
}
