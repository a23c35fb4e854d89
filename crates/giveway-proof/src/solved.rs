//! What a solver answered, and the claims that it makes.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, Objective, Plan, check};

use crate::{Claim, Hint};

/// The answer of a solver.
#[derive(Clone, Debug)]
pub struct Solved<'a> {
    /// The instance, with the objective by which plans were compared.
    pub instance: &'a Instance,
    /// The scope of all of its claims: for the answer to a question the contrasting plans
    /// ([`Claim::contrast`]), else all plans.
    pub about: Claim,
    /// The lower bounds that it proved, each given those of the costs before.
    pub bounds: &'a BTreeMap<Cost, u32>,
    /// Whether it proved that there is no plan.
    pub impossible: bool,
    /// Whether its claims hold for every horizon.
    pub complete: bool,
    /// Where they do not: the makespan up to which they hold, if it is known.
    pub within: Option<u32>,
    /// Its plan.
    pub plan: Option<&'a Plan>,
    /// The cores by which it raised its bounds, as guesses for [lemmas](crate::Lemma).
    pub hints: &'a [Hint],
}

/// The objective of an instance, with the penalty where rules of the scene's own make one.
pub(crate) fn objective(instance: &Instance) -> Objective {
    instance.in_force(instance.objective().clone())
}

/// The claims to certify, each with the cost that it bounds; none where there is no plan.
pub(crate) fn claims(solved: &Solved<'_>) -> Vec<(Option<Cost>, Claim)> {
    if solved.impossible {
        return vec![(None, solved.about.clone())];
    }
    let costs = solved
        .plan
        .and_then(|plan| check::costs(solved.instance, plan));
    let mut claims = Vec::new();
    let mut most = solved.about.most.clone();
    for &cost in objective(solved.instance).costs() {
        let Some(&bound) = solved.bounds.get(&cost) else {
            break;
        };
        if let Some(below) = bound.checked_sub(1) {
            let mut claim = solved.about.clone();
            claim.most.clone_from(&most);
            let before = claim.most.entry(cost).or_insert(below);
            *before = below.min(*before);
            claims.push((Some(cost), claim));
        }
        // Later claims are about plans that meet this bound.
        if costs.is_some_and(|costs| costs.get(cost) != bound) {
            break;
        }
        most.insert(cost, bound);
    }
    claims
}
