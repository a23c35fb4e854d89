//! The joint conclusion of plan and claims, and whether they agree at all. It follows from the instance, the
//! plan and the claims alone: nothing that stands beside them in a certificate has a part in it.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Condition, Cost, Costs, Instance, Objective, Plan, check, words::lower};
use serde::{Deserialize, Serialize};

use crate::bundle::{Entry, MANIFEST, PLAN};
use crate::report::Fault;
use crate::{Claim, condition};

/// The contents of a certificate.
#[derive(Clone, Copy)]
pub(crate) struct Whole<'a> {
    pub(crate) instance: &'a Instance,
    pub(crate) plan: Option<&'a Plan>,
    pub(crate) entries: &'a [Entry],
}

/// The joint conclusion of plan and claims.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Conclusion {
    /// No plan costs less than the plan.
    Best {
        /// By these costs, one after the other.
        objective: Objective,
        /// Of what kind the plans are; `null` where all are meant.
        condition: Option<Condition>,
        /// The makespan up to which they are meant; `null` where all are.
        within: Option<u32>,
    },
    /// No plan costs less, if what nothing shows is believed.
    Believed,
    /// The plan is one, and there are bounds.
    Bounds,
    /// There is no plan; or of this kind there is none that is as good by all costs of
    /// the objective.
    NoPlan {
        /// As this claim says.
        claim: Claim,
    },
}

impl Conclusion {
    /// The conclusion as a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::Best {
                condition: None,
                within: None,
                ..
            } => "Together: the plan is optimal, its costs compared in the order of the objective."
                .into(),
            Self::Best {
                condition: None,
                within: Some(last),
                ..
            } => format!(
                "Together: no plan of makespan at most {last} is better, costs compared in the \
                 order of the objective. Nothing is shown about longer plans."
            ),
            Self::Best {
                condition: Some(_),
                within: None,
                ..
            } => "Together: no plan of this kind costs less than this plan.".into(),
            Self::Best {
                condition: Some(_),
                within: Some(last),
                ..
            } => format!(
                "Together: no plan of this kind, of makespan at most {last}, costs less than this \
                 plan. Nothing is shown about longer plans."
            ),
            Self::Believed => "Together they would show that the plan is optimal if all of them \
                               were certified."
                .into(),
            Self::Bounds => {
                "Together they give lower bounds; they do not show that the plan is optimal.".into()
            }
            Self::NoPlan { claim } => format!("Together: {}", lower(&claim.sentence())),
        }
    }
}

/// Whether the claims can be said of this instance and this plan together.
pub(crate) fn check_together(whole: &Whole<'_>) -> Result<(), Fault> {
    let reject = |what: &str| Err(Fault::of(MANIFEST, what));
    let claims = || whole.entries.iter().map(Entry::claim);
    let first = claims().next();
    for claim in claims() {
        if let Some(condition) = &claim.condition
            && !condition::fits(condition, whole.instance)
        {
            return reject(
                "a claim is about a robot that does not exist, or about nothing that robots do",
            );
        }
        let limits = Claim {
            within: None,
            ..claim.clone()
        };
        let far = limits.horizon(whole.instance);
        let makespan = claim.most.contains_key(&Cost::Makespan);
        if claim
            .within
            .zip(far)
            .is_some_and(|(last, far)| makespan || far <= last)
        {
            return reject(
                "a claim has \"within\" beside a limit that already bounds the makespan",
            );
        }
    }
    if claims().any(|claim| Some(&claim.condition) != first.map(|first| &first.condition)) {
        return reject("its claims are about plans of several kinds");
    }
    let mut horizons = claims().filter_map(|claim| claim.within);
    let horizon = horizons.next();
    if horizons.any(|other| Some(other) != horizon) {
        return reject("its claims hold up to different makespans");
    }
    let Some((plan, costs)) = whole.plan.zip(costs(whole)) else {
        return Ok(());
    };
    if horizon.is_some_and(|last| costs.makespan > last) {
        return reject("its plan takes longer than the makespan up to which its claims hold");
    }
    if let Some(Some(condition)) = first.map(|first| &first.condition)
        && condition.holds(whole.instance, plan) != Some(true)
    {
        return Err(Fault::of(
            PLAN,
            "it is not of the kind that the claims are about",
        ));
    }
    let excluded = |claim: &Claim| {
        let keeps = |(&cost, &most): (&Cost, &u32)| costs.get(cost) <= most;
        claim.most.iter().all(keeps)
    };
    if claims().any(excluded) {
        return Err(Fault::of(PLAN, "a claim says that no such plan exists"));
    }
    Ok(())
}

/// The joint conclusion; none where each claim stands for itself. A contradiction is found before.
pub(crate) fn conclude(
    objective: &Objective,
    costs: Option<Costs>,
    entries: &[Entry],
) -> Option<Conclusion> {
    let certified = |entry: &&Entry| !matches!(entry, Entry::None { .. });
    // All claims have the same.
    let condition = entries.first().and_then(|e| e.claim().condition.clone());
    let Some(costs) = costs else {
        let mut whole = entries.iter().filter(certified).map(Entry::claim);
        let none = whole.find(|claim| claim.most.is_empty() || is_none_as_good(objective, claim));
        return none.map(|claim| Conclusion::NoPlan {
            claim: claim.clone(),
        });
    };
    let certain: Vec<&Claim> = entries.iter().filter(certified).map(Entry::claim).collect();
    if let Some(Reach { within }) = reach(objective, costs, &certain) {
        return Some(Conclusion::Best {
            objective: objective.clone(),
            condition,
            within,
        });
    }
    let all: Vec<&Claim> = entries.iter().map(Entry::claim).collect();
    if condition.is_some() {
        None
    } else if reach(objective, costs, &all).is_some() {
        Some(Conclusion::Believed)
    } else {
        Some(Conclusion::Bounds)
    }
}

/// Whether it says that of some kind no plan is as good as another, by all costs of the
/// objective.
fn is_none_as_good(objective: &Objective, claim: &Claim) -> bool {
    let mut costs = objective.costs().iter();
    claim.condition.is_some() && costs.all(|cost| claim.most.contains_key(cost))
}

/// How far claims reach together.
struct Reach {
    /// Up to this makespan; `None` for any.
    within: Option<u32>,
}

/// How far claims say that nothing costs less, cost
/// after cost; nothing where they do not. A claim about one cost excludes all
/// that costs less of it and no more of those before; it says nothing of the
/// kind where it limits anything else.
fn reach(objective: &Objective, costs: Costs, claims: &[&Claim]) -> Option<Reach> {
    let mut within: Option<u32> = None;
    let order = objective.costs();
    for (i, &cost) in order.iter().enumerate() {
        let Some(below) = costs.get(cost).checked_sub(1) else {
            continue; // nothing costs less than nothing
        };
        let says = |claim: &&&Claim| {
            let mut limits = claim.most.iter();
            claim.most.get(&cost).is_some_and(|&most| most >= below)
                && limits.all(|(other, &most)| {
                    *other == cost || (order[..i].contains(other) && most >= costs.get(*other))
                })
        };
        // Of those that say so the one that reaches furthest.
        let reaches = claims.iter().filter(says).map(|claim| claim.within);
        let furthest = reaches.max_by_key(|within| within.map_or((1, 0), |last| (0, last)))?;
        within = match (within, furthest) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (one, other) => one.or(other),
        };
    }
    Some(Reach { within })
}

fn costs(whole: &Whole<'_>) -> Option<Costs> {
    check::costs(whole.instance, whole.plan?)
}
