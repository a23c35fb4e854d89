//! Shows what a solver claims and checks that at once: what a page needs, which
//! need not carry the code for folders.

use std::collections::BTreeMap;

use giveway_model::{Instance, check};

use crate::again::{Proof, check_claims, check_plan, check_proof, formula};
use crate::bundle::proof_files;
use crate::conclude::{Whole, check_together, conclude};
use crate::report::Fault;
use crate::{Budget, Report, Solved, show::show};

/// The texts of proofs by their names.
type Proofs = BTreeMap<String, Vec<u8>>;

/// Proves everything that the solver claims within one budget, and checks it
/// within another. Where the plan keeps the rules, the report is the one that
/// [`verify`](crate::verify()) gives of the files that [`export`](crate::export) makes.
///
/// ```
/// use std::collections::BTreeMap;
/// use giveway_model::{Cost, format::native};
/// use giveway_proof::{Budget, Claim, Solved, confirm};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
///     "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let solved = Solved {
///     instance: &instance,
///     about: Claim::default(),
///     bounds: &BTreeMap::from([(Cost::Makespan, 2)]),
///     impossible: false,
///     complete: true,
///     within: None,
///     plan: None,
/// };
/// assert!(confirm(&solved, &Budget::default(), &Budget::default()).accepted);
/// ```
pub fn confirm(solved: &Solved<'_>, proving: &Budget<'_>, checking: &Budget<'_>) -> Report {
    let Solved { instance, plan, .. } = *solved;
    let mut proofs = Proofs::new();
    let entries = show(solved, proving, &mut |name, _, proof| {
        proofs.insert(name.to_owned(), proof);
    });
    Report::of(|claims| {
        let costs = plan.and_then(|plan| check::costs(instance, plan));
        if let Some(plan) = plan {
            check_plan(instance, plan, costs)?;
        }
        check_together(&Whole {
            instance,
            plan,
            entries: &entries,
        })?;
        check_claims(instance, &entries, checking, claims, &|proof| {
            check_kept(&proofs, instance, proof, checking)
        })?;
        Ok(conclude(instance.objective(), costs, &entries))
    })
}

fn check_kept(
    proofs: &Proofs,
    instance: &Instance,
    proof: &Proof<'_>,
    budget: &Budget<'_>,
) -> Result<usize, Fault> {
    let [_, drat, _] = proof_files(proof.name);
    let text = proofs.get(proof.name).map_or(Ok(""), |proof| {
        std::str::from_utf8(proof).map_err(|_| Fault::of(&drat, "it is not text"))
    })?;
    let formula = formula(instance, proof, budget)?.text();
    check_proof(&formula, text, &drat, budget)
}
