//! A certificate as it is written.

use std::collections::BTreeMap;

use giveway_model::{check, format::native};

use super::{Bundle, Entry, INSTANCE, MANIFEST, Manifest, PLAN, README, fingerprint, proof_files};
use crate::confirm::check_shown;
use crate::show::show;
use crate::solved::objective;
use crate::{Budget, Report, Solved};

/// Makes a certificate of everything that the solver claims. What cannot be
/// certified within the budget is part of it, too, and said not to be.
pub fn export(solved: &Solved<'_>, budget: &Budget<'_>) -> Bundle {
    let (entries, proofs) = shown(solved, budget);
    written(solved, entries, proofs)
}

/// Makes a certificate and checks it before it is written: the report is that of
/// [`verify`](crate::verify()), without the code that reads files.
pub fn export_checked(
    solved: &Solved<'_>,
    making: &Budget<'_>,
    checking: &Budget<'_>,
) -> (Bundle, Report) {
    let (entries, proofs) = shown(solved, making);
    let report = check_shown(solved, &entries, checking, &|name| {
        let [_, drat, _] = proof_files(name);
        proofs.get(&drat)
    });
    (written(solved, entries, proofs), report)
}

/// The entries that show the claims, with the files of proofs.
fn shown(solved: &Solved<'_>, budget: &Budget<'_>) -> (Vec<Entry>, Bundle) {
    let mut proofs = Bundle::new();
    let entries = show(solved, budget, &mut |name, instance, formula, proof| {
        let [cnf, drat, names] = proof_files(name);
        proofs.insert(cnf, formula.text().into_bytes());
        proofs.insert(drat, proof);
        proofs.insert(names, formula.names_text(instance).into_bytes());
    });
    (entries, proofs)
}

/// All files, with those of proofs.
fn written(solved: &Solved<'_>, entries: Vec<Entry>, proofs: Bundle) -> Bundle {
    let Solved { instance, plan, .. } = *solved;
    let mut bundle = proofs;
    let scene = native::write_scene(&instance.to_scene());
    bundle.insert(INSTANCE.to_owned(), scene.into_bytes());
    if let Some(plan) = plan {
        let plan = native::write_plan(plan);
        bundle.insert(PLAN.to_owned(), plan.into_bytes());
    }
    let mut manifest = Manifest {
        version: 1,
        objective: objective(instance),
        costs: plan.and_then(|plan| check::costs(instance, plan)),
        claims: entries,
        files: BTreeMap::new(),
    };
    let text = manifest.readme(instance);
    bundle.insert(README.to_owned(), text.into_bytes());
    for (name, bytes) in &bundle {
        manifest.files.insert(name.clone(), fingerprint(bytes));
    }
    bundle.insert(MANIFEST.to_owned(), manifest.text().into_bytes());
    bundle
}
