//! Compares the costs that a file claims for its plan with the costs here, and names the other definition by
//! which its makers may have counted.

use std::cell::OnceCell;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::Claimed;
use crate::check::{arrivals, check, costs};
use crate::{Cost, Instance, Plan, tr};

/// How else a cost may be counted.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Definition {
    /// Every step that the file writes, waits at the goal after the arrival too.
    WrittenSteps,
    /// The makespan for every agent: all of them count until the last has arrived.
    MakespanForAll,
    /// The cells of each path, its first one too: one more than its steps.
    Cells,
    /// The moves alone; waits are free.
    Moves,
    /// No step that an agent begins and ends at its goal, also where it leaves it again.
    AwayFromGoal,
    /// The number of steps for the makespan, the time 0 counted too.
    Times,
}

impl Definition {
    /// How it may have been counted, as a sentence: equal numbers prove nothing.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::WrittenSteps => tr!(
                "It would be the number of all steps that the file writes, waits at the goal after the arrival too."
            ),
            Self::MakespanForAll => tr!("It would be the makespan times the number of robots."),
            Self::Cells => {
                tr!("It would be the number of cells of all paths, starts too.")
            }
            Self::Moves => tr!("It would be the number of moves, without waits."),
            Self::AwayFromGoal => {
                tr!(
                    "It would be the number of steps that robots do not rest at their goals, even if they leave them again."
                )
            }
            Self::Times => tr!("It would be the number of times, time 0 too."),
        }
    }
}

/// A cost that a file claims, beside ours.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct ClaimedCost {
    /// The cost.
    pub cost: Cost,
    /// The value that the file claims.
    pub claimed: u64,
    /// By this project's definition; `null` where an agent has no path.
    pub counted: Option<u32>,
    /// A definition that gives what the file says, by which it may have been counted; `null`
    /// where both agree, where none is known, and for a plan that is not legal.
    pub definition: Option<Definition>,
}

impl ClaimedCost {
    /// Whether the file and this project agree.
    pub fn agrees(&self) -> bool {
        self.counted.map(u64::from) == Some(self.claimed)
    }
}

/// Compares what a file claims with what its plan costs. `written` is what the
/// plan would cost if every step in the file counted.
pub fn claims(
    instance: &Instance,
    plan: &Plan,
    claimed: Claimed,
    written: Claimed,
) -> Vec<ClaimedCost> {
    let ours = costs(instance, plan);
    let is_legal = OnceCell::new();
    let both = [
        (Cost::SumOfCosts, claimed.sum_of_costs),
        (Cost::Makespan, claimed.makespan),
    ];
    let both = both.into_iter();
    both.filter_map(|(cost, claimed)| {
        let claimed = claimed?;
        let counted = ours.map(|costs| costs.get(cost));
        let mut one = ClaimedCost {
            cost,
            claimed,
            counted,
            definition: None,
        };
        if !one.agrees() && *is_legal.get_or_init(|| check(instance, plan).is_valid()) {
            let tried = definitions(instance, plan, cost, written).into_iter();
            let mut fits = tried.filter(|(_, value)| *value == Some(claimed));
            one.definition = fits.next().map(|(definition, _)| definition);
        }
        Some(one)
    })
    .collect()
}

/// The value of a cost by the definitions of others, the most frequent first.
fn definitions(
    instance: &Instance,
    plan: &Plan,
    cost: Cost,
    written: Claimed,
) -> Vec<(Definition, Option<u64>)> {
    let agents = instance.agents().len() as u64;
    let ours = costs(instance, plan);
    let of = |cost: Cost| ours.map(|costs| u64::from(costs.get(cost)));
    match cost {
        Cost::Makespan => vec![
            (Definition::WrittenSteps, written.makespan),
            (Definition::Times, of(Cost::Makespan).map(|n| n + 1)),
        ],
        Cost::SumOfCosts => vec![
            (Definition::WrittenSteps, written.sum_of_costs),
            (
                Definition::MakespanForAll,
                of(Cost::Makespan).map(|n| n * agents),
            ),
            (Definition::Cells, of(Cost::SumOfCosts).map(|n| n + agents)),
            (Definition::Moves, of(Cost::Moves)),
            (
                Definition::AwayFromGoal,
                Some(away_from_goal(instance, plan)),
            ),
        ],
        Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => Vec::new(),
    }
}

/// The steps of all agents that do not begin and end at the goal.
pub(super) fn away_from_goal(instance: &Instance, plan: &Plan) -> u64 {
    let mut steps = 0;
    for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
        let path = plan.path(&agent.name);
        let path = path.get(..=arrival.unwrap_or_default() as usize);
        let goal = agent.goal.or_else(|| path?.last().copied().flatten());
        let away = |step: &&[Option<crate::Cell>]| step.iter().any(|cell| *cell != goal);
        steps += path.unwrap_or_default().windows(2).filter(away).count() as u64;
    }
    steps
}
