//! Compares the lower bounds that a file claims with the bounds here.

use std::collections::BTreeMap;

use serde::Serialize;

use super::ClaimedBounds;
use super::claimed::away_from_goal;
use crate::check::{check, costs};
use crate::words::name;
use crate::{Cost, Instance, Plan, tr};

/// The cost that is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bounded {
    /// The largest arrival.
    Makespan,
    /// The sum of arrivals.
    SumOfCosts,
    /// The steps that do not begin and end at the goal.
    SumOfLoss,
}

impl Bounded {
    /// The cost that it is here.
    const fn cost(self) -> Option<Cost> {
        match self {
            Self::Makespan => Some(Cost::Makespan),
            Self::SumOfCosts => Some(Cost::SumOfCosts),
            Self::SumOfLoss => None,
        }
    }

    /// Its name in a sentence.
    fn name(self) -> &'static str {
        self.cost().map_or_else(|| tr!("sum of loss"), name)
    }
}

/// A lower bound that a file claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ClaimedBound {
    /// The cost that is bounded.
    pub of: Bounded,
    /// The bound that the file claims.
    pub claimed: u64,
    /// The bound that is proved here.
    pub proved: Option<u32>,
    /// The least that a legal plan is known to have.
    pub legal: Option<u64>,
    /// Whether a legal plan has less than the file says, so that the bound is wrong.
    pub is_wrong: bool,
}

impl ClaimedBound {
    /// The claim and what is known of it, as a sentence.
    pub fn sentence(&self) -> String {
        let (called, claimed) = (self.of.name(), self.claimed);
        match (self.legal, self.proved) {
            (Some(legal), _) if self.is_wrong => tr!(
                "The file says that every plan has a {called} of at least {claimed}. That is wrong as it is counted here: a legal plan has {legal}.",
                called,
                claimed,
                legal
            ),
            (_, Some(proved)) => tr!(
                "The file says that every plan has a {called} of at least {claimed}; at least {proved} is proved here.",
                called,
                claimed,
                proved
            ),
            (_, None) => tr!(
                "The file says that every plan has a {called} of at least {claimed}; that is not proved here.",
                called,
                claimed
            ),
        }
    }
}

/// The bounds that a file claims. `plans` are those that are known, legal or not; `proved` are
/// bounds that hold for all plans.
pub fn claimed_bounds(
    instance: &Instance,
    plans: &[&Plan],
    claimed: ClaimedBounds,
    proved: &BTreeMap<Cost, u32>,
) -> Vec<ClaimedBound> {
    if claimed == ClaimedBounds::default() {
        return Vec::new();
    }
    let legal = plans.iter().filter(|plan| check(instance, plan).is_valid());
    let legal: Vec<&Plan> = legal.copied().collect();
    let least = |of: Bounded| {
        let all = legal.iter().filter_map(|plan| match of.cost() {
            Some(cost) => Some(u64::from(costs(instance, plan)?.get(cost))),
            None => Some(away_from_goal(instance, plan)),
        });
        all.min()
    };
    let all = [
        (Bounded::SumOfCosts, claimed.sum_of_costs),
        (Bounded::Makespan, claimed.makespan),
        (Bounded::SumOfLoss, claimed.sum_of_loss),
    ];
    let all = all.into_iter().filter_map(|(of, claimed)| {
        let (claimed, legal) = (claimed?, least(of));
        Some(ClaimedBound {
            of,
            claimed,
            proved: of.cost().and_then(|cost| proved.get(&cost).copied()),
            legal,
            is_wrong: legal.is_some_and(|legal| legal < claimed),
        })
    });
    all.collect()
}

/// The sentence that a legal plan has another sum of loss than its file claims, where that is so.
pub fn claimed_loss(instance: &Instance, plan: &Plan, claimed: ClaimedBounds) -> Option<String> {
    let claimed = claimed.loss?;
    let counted = away_from_goal(instance, plan);
    (counted != claimed && check(instance, plan).is_valid()).then(|| {
        tr!(
            "The file says that its sum of loss is {claimed}; it is {counted} here.",
            claimed,
            counted
        )
    })
}
