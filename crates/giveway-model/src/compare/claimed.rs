//! What a file says that its plan costs, beside what it costs here, and by which
//! other definition its makers may have counted.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::check::{arrivals, costs};
use crate::format::foreign::Claimed;
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
    /// How it counts, as a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::WrittenSteps => tr!("It counts waits at the goal after the arrival, too."),
            Self::MakespanForAll => tr!("It counts the makespan for every robot."),
            Self::Cells => {
                tr!("It counts the cells of each path, the start too, and not the steps.")
            }
            Self::Moves => tr!("It counts moves only, no waits."),
            Self::AwayFromGoal => {
                tr!(
                    "It does not count steps that a robot rests at its goal, even if it leaves it again."
                )
            }
            Self::Times => tr!("It counts the time 0, too."),
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
    /// What the file says.
    pub claimed: u64,
    /// By this project's definition; `null` where an agent has no path.
    pub counted: Option<u32>,
    /// The definition that gives what the file says; `null` where both agree, and
    /// where none is known.
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
        if !one.agrees() {
            let tried = definitions(instance, plan, cost, written).into_iter();
            let mut fits = tried.filter(|(_, value)| *value == Some(claimed));
            one.definition = fits.next().map(|(definition, _)| definition);
        }
        Some(one)
    })
    .collect()
}

/// What a cost is by the definitions of others, the most frequent first.
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
        Cost::Charges | Cost::Moves | Cost::Waits => Vec::new(),
    }
}

/// The steps of all agents that do not begin and end at the goal.
fn away_from_goal(instance: &Instance, plan: &Plan) -> u64 {
    let mut steps = 0;
    for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
        let path = plan.path(&agent.name);
        let path = path.get(..=arrival.unwrap_or_default() as usize);
        let goal = Some(agent.goal);
        let away = |step: &&[Option<crate::Cell>]| step.iter().any(|cell| *cell != goal);
        steps += path.unwrap_or_default().windows(2).filter(away).count() as u64;
    }
    steps
}
