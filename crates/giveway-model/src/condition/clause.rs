//! Conditions in words.

use super::{Act, Condition, Times};
use crate::words::noun;
use crate::{Cell, Cost, tr};

/// A condition as a clause, in the two moods that sentences need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clause {
    /// After "if": `A2 did not wait at (3, 1)`.
    pub would: String,
    /// After "a plan in which": `A2 does not wait at (3, 1)`.
    pub does: String,
}

impl Condition {
    /// The condition as a clause.
    ///
    /// ```
    /// use giveway_model::{Cell, condition::Condition};
    /// let charges = Condition::Charge { agent: "A1".into(), cell: Cell::new(3, 1) };
    /// let clause = charges.clause();
    /// assert_eq!(clause.would, "A1 charged at (3, 1)");
    /// assert_eq!(clause.does, "A1 charges at (3, 1)");
    /// ```
    pub fn clause(&self) -> Clause {
        match self {
            Self::Never { agent, act, times } => never(agent, *act, *times),
            Self::Visit { agent, cell: at } => doing(
                agent.as_deref().unwrap_or(tr!("somebody")),
                &tr!("If a robot ..." => "passed {at}", at),
                &tr!("a plan in which a robot ..." => "passes {at}", at),
            ),
            Self::Move {
                agent,
                from: from_cell,
                to: to_cell,
                times,
            } => {
                let what = tr!(
                    "something done" => "from {from_cell} to {to_cell}{moment}",
                    from_cell,
                    to_cell,
                    moment = moment(*times)
                );
                doing(
                    agent,
                    &tr!("If a robot ..." => "went {what}", what),
                    &tr!("a plan in which a robot ..." => "goes {what}", what),
                )
            }
            Self::Charge { agent, cell: at } => doing(
                agent,
                &tr!("If a robot ..." => "charged at {at}", at),
                &tr!("a plan in which a robot ..." => "charges at {at}", at),
            ),
            Self::Before { first, second } if first.agent == second.agent => {
                let (earlier, later) = (first.cell, second.cell);
                doing(
                    &first.agent,
                    &tr!("If a robot ..." => "visited {second} before {first}", second = earlier, first = later),
                    &tr!("a plan in which a robot ..." => "visits {second} before {first}", second = earlier, first = later),
                )
            }
            Self::Before { first, second } => {
                let (at, to) = (first.cell, &second.agent);
                doing(
                    &first.agent,
                    &tr!("If a robot ..." => "were at {at} before {to}", at, to),
                    &tr!("a plan in which a robot ..." => "is at {at} before {to}", at, to),
                )
            }
            Self::Keeps(rule) => {
                let rule = rule.sentence();
                Clause {
                    would: tr!("If ..." => "this rule held (\"{rule}\")", rule),
                    does: tr!("a plan in which ..." => "this rule holds: \"{rule}\"", rule),
                }
            }
            Self::Below {
                agent: Some(agent),
                cost,
                limit,
            } => below(agent, *cost, *limit),
            Self::Below {
                agent: None,
                cost,
                limit: below,
            } => {
                let cost = noun(*cost);
                Clause {
                    would: tr!("If ..." => "the {cost} were below {below}", cost, below),
                    does: tr!("a plan in which ..." => "the {cost} is below {below}", cost, below),
                }
            }
        }
    }
}

/// The clause that an agent does something.
fn doing(agent: &str, did: &str, does: &str) -> Clause {
    Clause {
        would: format!("{agent} {did}"),
        does: format!("{agent} {does}"),
    }
}

/// The clause that an agent never does something.
fn never(agent: &str, act: Act, times: Times) -> Clause {
    let what = match act {
        Act::Visit(at) => {
            if let Some(time) = times.single() {
                return doing(
                    agent,
                    &tr!("If a robot ..." => "were not at {at} at time {time}", at, time),
                    &tr!("a plan in which a robot ..." => "is not at {at} at time {time}", at, time),
                );
            }
            let time = span(times);
            tr!("a robot does not" => "pass {at}{time}", at, time)
        }
        Act::Move(from_cell, to_cell) => tr!(
            "a robot does not" => "go from {from_cell} to {to_cell}{moment}",
            from_cell,
            to_cell,
            moment = moment(times)
        ),
        Act::SlowMove(edge) => {
            let edge = edge.map_or_else(
                String::new,
                |(u, v)| tr!("something done" => " between {u} and {v}", u, v),
            );
            tr!("a robot does not" => "take the slow way{edge}{moment}", edge, moment = moment(times))
        }
        Act::Wait { cell, steps: 0 | 1 } => tr!(
            "a robot does not" => "wait{place}{time}",
            place = place(cell),
            time = span(times)
        ),
        Act::Wait { cell, steps } => tr!(
            "a robot does not" => "wait {steps} steps in a row{place}{time}",
            steps,
            place = place(cell),
            time = span(times)
        ),
        Act::Charge(cell) => tr!(
            "a robot does not" => "charge{place}{moment}",
            place = place(cell),
            moment = moment(times)
        ),
    };
    let what = what.trim_start();
    Clause {
        would: tr!("If ..." => "{agent} did not {what}", agent, what),
        does: tr!("a plan in which ..." => "{agent} does not {what}", agent, what),
    }
}

/// The clause that an agent has less of a cost.
fn below(agent: &str, cost: Cost, below: u32) -> Clause {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => Clause {
            would: tr!("If ..." => "{agent} arrived before time {time}", agent, time = below),
            does: tr!("a plan in which ..." => "{agent} arrives before time {time}", agent, time = below),
        },
        Cost::Charges => Clause {
            would: tr!("If ..." => "{agent} made fewer than {below} charges", agent, below),
            does: tr!("a plan in which ..." => "{agent} makes fewer than {below} charges", agent, below),
        },
        Cost::Moves => Clause {
            would: tr!("If ..." => "{agent} made fewer than {below} moves", agent, below),
            does: tr!("a plan in which ..." => "{agent} makes fewer than {below} moves", agent, below),
        },
        Cost::Waits => Clause {
            would: tr!("If ..." => "{agent} made fewer than {below} waits", agent, below),
            does: tr!("a plan in which ..." => "{agent} makes fewer than {below} waits", agent, below),
        },
        Cost::Penalty => Clause {
            would: tr!("If ..." => "{agent} had a penalty below {below}", agent, below),
            does: tr!("a plan in which ..." => "{agent} has a penalty below {below}", agent, below),
        },
    }
}

fn place(at: Option<Cell>) -> String {
    at.map_or_else(String::new, |at| tr!("something done" => " at {at}", at))
}

fn moment(times: Times) -> String {
    match times.single() {
        Some(time) => tr!("something done" => " at time {time}", time),
        None => span(times),
    }
}

fn span(times: Times) -> String {
    match (times.from, times.to) {
        (None | Some(0), None) => String::new(),
        (Some(from), None) => tr!("something done" => " from time {from} on", from),
        (_, Some(to)) => tr!(
            "something done" => " between time {from} and {to}",
            from = times.first(),
            to
        ),
    }
}
