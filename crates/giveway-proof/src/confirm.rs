//! Shows what a solver claims and checks that at once: what a page needs, which
//! need not carry the code for folders.

use std::collections::BTreeMap;

use giveway_model::check;

use crate::again::{Named, check_claims, check_plan, check_proof};
use crate::bundle::{Entry, proof_files};
use crate::conclude::{Whole, check_together, conclude};
use crate::report::Fault;
use crate::show::show;
use crate::solved::objective;
use crate::{Budget, Report, Solved};

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
///     hints: &[],
/// };
/// assert!(confirm(&solved, &Budget::default(), &Budget::default()).accepted);
/// ```
pub fn confirm(solved: &Solved<'_>, proving: &Budget<'_>, checking: &Budget<'_>) -> Report {
    let mut proofs = BTreeMap::new();
    let entries = show(solved, proving, &mut |name, _, _, proof| {
        proofs.insert(name.to_owned(), proof);
    });
    check_shown(solved, &entries, checking, &|name| proofs.get(name))
}

/// Checks what shows the claims, as it was made: entries, and proofs by their names.
pub(crate) fn check_shown<'a>(
    solved: &Solved<'_>,
    entries: &[Entry],
    budget: &Budget<'_>,
    proofs: &dyn Fn(&str) -> Option<&'a Vec<u8>>,
) -> Report {
    let Solved { instance, plan, .. } = *solved;
    Report::of(|claims| {
        let costs = plan.and_then(|plan| check::costs(instance, plan));
        if let Some(plan) = plan {
            check_plan(instance, plan, costs)?;
        }
        check_together(&Whole {
            instance,
            plan,
            entries,
        })?;
        check_claims(instance, entries, budget, claims, &|named| {
            check_kept(proofs(named.name), named, budget)
        })?;
        Ok(conclude(&objective(instance), costs, entries))
    })
}

fn check_kept(
    kept: Option<&Vec<u8>>,
    named: &Named<'_>,
    budget: &Budget<'_>,
) -> Result<usize, Fault> {
    let [_, drat, _] = proof_files(named.name);
    let text = kept.map_or(Ok(""), |proof| {
        std::str::from_utf8(proof).map_err(|_| Fault::of(&drat, "it is not text"))
    })?;
    let formula = named.formula(budget)?.text();
    check_proof(&formula, text, &drat, budget)
}
