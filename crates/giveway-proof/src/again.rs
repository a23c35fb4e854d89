//! Plans judged and claims shown a second time, wherever their proofs lie.

use giveway_model::{Costs, Instance, Plan, check, tr};

use crate::bundle::{Entry, MANIFEST, PLAN, proof_files};
use crate::drat::{self, Refused};
use crate::plain::{self, Cnf, NoFormula};
use crate::report::Fault;
use crate::{Budget, Checked, Claim};

/// The record of a proof.
pub(crate) struct Proof<'a> {
    pub(crate) claim: &'a Claim,
    /// The name of its files, without their endings.
    pub(crate) name: &'a str,
    variables: usize,
    clauses: usize,
}

/// The plan keeps the rules and costs what is said.
pub(crate) fn check_plan(
    instance: &Instance,
    plan: &Plan,
    costs: Option<Costs>,
) -> Result<(), Fault> {
    let report = check::check(instance, plan);
    if let Some(violation) = report.violations.first() {
        return Err(Fault::Rejected(format!("{PLAN}: {}", violation.message)));
    }
    if report.costs != costs {
        return Err(Fault::of(PLAN, "it does not cost what the manifest says"));
    }
    Ok(())
}

/// Checks each claim and puts it on the list; `steps` checks a proof and counts
/// the steps that were needed.
pub(crate) fn check_claims(
    instance: &Instance,
    entries: &[Entry],
    budget: &Budget<'_>,
    claims: &mut Vec<Checked>,
    steps: &dyn Fn(&Proof<'_>) -> Result<usize, Fault>,
) -> Result<(), Fault> {
    for entry in entries {
        (budget.tell)(entry.claim());
        claims.push(check_entry(instance, entry, budget, steps)?);
    }
    Ok(())
}

fn check_entry(
    instance: &Instance,
    entry: &Entry,
    budget: &Budget<'_>,
    steps: &dyn Fn(&Proof<'_>) -> Result<usize, Fault>,
) -> Result<Checked, Fault> {
    let claim = entry.claim().clone();
    let text = claim.sentence();
    match entry {
        Entry::Proof {
            claim: of,
            name,
            variables,
            clauses,
        } => {
            let (variables, clauses) = (*variables, *clauses);
            let steps = steps(&Proof {
                claim: of,
                name,
                variables,
                clauses,
            })?;
            Ok(Checked::Proof {
                text,
                claim,
                variables,
                clauses,
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
                Some(false) => Err(Fault::Rejected(tr!(
                    "The search does not show: {text}",
                    text
                ))),
                None => Err(Fault::Stopped(tr!(
                    "The search ended too early to show: {text}",
                    text
                ))),
            }
        }
        Entry::None { why, .. } => Ok(Checked::None {
            text,
            claim,
            why: why.sentence().to_owned(),
        }),
    }
}

/// The formula of a claim, written again; its size must be the one that is said.
pub(crate) fn formula(
    instance: &Instance,
    proof: &Proof<'_>,
    budget: &Budget<'_>,
) -> Result<Cnf, Fault> {
    let formula = plain::formula(instance, proof.claim, budget).map_err(|error| match error {
        NoFormula::NoHorizon => Fault::of(
            MANIFEST,
            "a claim with a proof is about plans of any makespan",
        ),
        NoFormula::NoAgent => Fault::of(MANIFEST, "a claim is about a robot that does not exist"),
        NoFormula::TooLarge => {
            let [cnf, ..] = proof_files(proof.name);
            Fault::Stopped(tr!("{file}: it is too large to check.", file = cnf))
        }
    })?;
    if (proof.variables, proof.clauses) != (formula.variables(), formula.clauses()) {
        return Err(Fault::of(MANIFEST, "the size of a formula differs"));
    }
    Ok(formula)
}

/// Checks a proof of a formula, which is called `file`.
pub(crate) fn check_proof(
    formula: &str,
    proof: &str,
    file: &str,
    budget: &Budget<'_>,
) -> Result<usize, Fault> {
    match drat::check(formula, proof, budget.go_on) {
        Ok(proved) => Ok(proved.steps),
        Err(Refused::Stopped) => Err(Fault::Stopped(tr!("{file}: the check was stopped.", file))),
        Err(refused) => Err(Fault::of(file, &refused.to_string())),
    }
}
