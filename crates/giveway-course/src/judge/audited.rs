//! Statements about the plan on the board, by its audit.

use giveway_model::check::Violation;
use giveway_solve::Response;
use giveway_solve::audit::{AuditAnswer, AuditStatus};

use super::statement::{Outcome, first_better};
use super::{Why, proved};
use crate::port::Evidence;

/// The audit of a plan that breaks no rule, else what it breaks.
fn audit(response: Option<&Response>) -> Result<Result<&AuditAnswer, Outcome>, Why> {
    let Some(Response::Audited(audit)) = response else {
        return Err(proved::unexpected(response));
    };
    Ok(match audit.violations.first() {
        None => Ok(audit),
        Some(violation) => {
            let evidence = Evidence {
                time: Some(violation.time),
                violations: audit.violations.clone(),
                ..Evidence::default()
            };
            Err(Outcome::of(false, Why::Broken(violation.clone()), evidence))
        }
    })
}

pub(super) fn legal(response: Option<&Response>) -> Result<Outcome, Why> {
    Ok(match audit(response)? {
        Ok(audit) => Outcome::of(audit.legal, Why::Legal, Evidence::default()),
        Err(broken) => broken,
    })
}

/// Whether a plan breaks a rule of the scene's own.
pub(super) fn broken(rule: u32, response: Option<&Response>) -> Result<Outcome, Why> {
    let Some(Response::Audited(audit)) = response else {
        return Err(proved::unexpected(response));
    };
    let is_it = |violation: &&Violation| {
        let broken = violation.broken.as_ref();
        broken.is_some_and(|broken| broken.index == rule)
    };
    Ok(match audit.violations.iter().find(is_it) {
        None => Outcome::of(false, Why::Keeps { rule }, Evidence::default()),
        Some(violation) => {
            let evidence = Evidence {
                time: Some(violation.time),
                violations: vec![violation.clone()],
                ..Evidence::default()
            };
            Outcome::of(true, Why::Broken(violation.clone()), evidence)
        }
    })
}

/// Whether a plan is proved best, or (not `best`) a better one is known.
pub(super) fn best_of_all(response: Option<&Response>, best: bool) -> Result<Outcome, Why> {
    let audit = match audit(response)? {
        Ok(audit) => audit,
        Err(broken) => return Ok(broken),
    };
    let (Some(costs), Some(first)) = (audit.costs, audit.first_cost()) else {
        return Err(Why::Unknown(audit.reason.clone()));
    };
    if audit.status == AuditStatus::Optimal && audit.reach.is_complete() {
        let value = costs.get(first);
        let why = Why::Best { cost: first, value };
        return Ok(Outcome::of(best, why, Evidence::default()));
    }
    let (Some(better), Some(plan)) = (audit.better_costs, &audit.better) else {
        return Err(Why::Unknown(audit.reason.clone()));
    };
    let cost = first_better(audit.objective.costs(), &costs, &better).unwrap_or(first);
    let why = Why::NotBest {
        cost,
        value: costs.get(cost),
        best: better.get(cost),
    };
    let evidence = Evidence {
        plan: Some(plan.clone()),
        ..Evidence::default()
    };
    Ok(Outcome::of(!best, why, evidence))
}
