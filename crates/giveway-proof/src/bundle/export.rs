//! A certificate as it is written.

use std::collections::BTreeMap;

use giveway_model::{check, format::native};

use super::{Bundle, INSTANCE, MANIFEST, Manifest, PLAN, README, fingerprint, proof_files};
use crate::{Budget, Solved, show::show};

/// Makes a certificate of everything that the solver claims. What cannot be
/// certified within the budget is part of it, too, and said not to be.
pub fn export(solved: &Solved<'_>, budget: &Budget<'_>) -> Bundle {
    let Solved { instance, plan, .. } = *solved;
    let mut bundle = Bundle::new();
    let claims = show(solved, budget, &mut |name, formula, proof| {
        let [cnf, drat, names] = proof_files(name);
        bundle.insert(cnf, formula.text().into_bytes());
        bundle.insert(drat, proof);
        bundle.insert(names, formula.names_text(instance).into_bytes());
    });
    let scene = native::write_scene(&instance.to_scene());
    bundle.insert(INSTANCE.to_owned(), scene.into_bytes());
    if let Some(plan) = plan {
        let plan = native::write_plan(plan);
        bundle.insert(PLAN.to_owned(), plan.into_bytes());
    }
    let mut manifest = Manifest {
        version: 1,
        objective: instance.objective().clone(),
        costs: plan.and_then(|plan| check::costs(instance, plan)),
        claims,
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
