//! The condition that a question contrasts a plan with.

use super::Question;
use crate::condition::{Act, Condition, Times, Visit};
use crate::{Cost, Instance, Plan, check};

impl Question {
    /// The contrast of a question about a plan: what must hold in another plan for it
    /// to be otherwise. `None` where the question has none (`unsolvable`, `plan`), or
    /// an agent that it names has no path.
    pub fn contrast(&self, instance: &Instance, plan: &Plan) -> Option<Condition> {
        self.condition(|agent, cost| check::cost_of(instance, plan, agent, cost))
    }

    /// The same, where `costs` tells what the plan costs an agent, or altogether. The
    /// makespan of an agent is its arrival.
    pub fn condition(
        &self,
        costs: impl Fn(Option<&str>, Cost) -> Option<u32>,
    ) -> Option<Condition> {
        let never = |agent: &String, act, times| Condition::Never {
            agent: agent.clone(),
            act,
            times,
        };
        let below = |agent: Option<&String>, cost: Cost, limit: Option<u32>| {
            Some(Condition::Below {
                agent: agent.cloned(),
                cost,
                limit: limit.or_else(|| costs(agent.map(String::as_str), cost))?,
            })
        };
        let visit = |agent: &String, &cell| Visit {
            agent: agent.clone(),
            cell,
        };
        Some(match self {
            Self::Wait {
                agent,
                at: cell,
                from,
                to,
                at_least,
            } => {
                let act = Act::Wait {
                    cell: *cell,
                    steps: at_least.unwrap_or(1).max(1),
                };
                let times = Times {
                    from: *from,
                    to: *to,
                };
                never(agent, act, times)
            }
            Self::Charge { agent, at, time } => never(agent, Act::Charge(*at), Times::at(*time)),
            Self::Visit { agent, at, time } => never(agent, Act::Visit(*at), Times::at(*time)),
            Self::Move {
                agent,
                from_cell,
                to_cell,
                time,
            } => never(agent, Act::Move(*from_cell, *to_cell), Times::at(*time)),
            Self::Slow {
                agent,
                from_cell,
                to_cell,
            } => {
                let edge = from_cell.zip(*to_cell);
                never(agent, Act::SlowMove(edge), Times::default())
            }
            Self::NoCharge { agent, at: cell } => Condition::Charge {
                agent: agent.clone(),
                cell: *cell,
            },
            Self::NoVisit { agent, at: cell } => Condition::Visit {
                agent: agent.clone(),
                cell: *cell,
            },
            Self::NoMove {
                agent,
                from_cell: from,
                to_cell: to,
                time,
            } => Condition::Move {
                agent: agent.clone(),
                from: *from,
                to: *to,
                times: Times::at(*time),
            },
            Self::Order {
                agent,
                first,
                second,
            } => Condition::Before {
                first: visit(agent, second),
                second: visit(agent, first),
            },
            Self::Yield { agent, to, at } => Condition::Before {
                first: visit(agent, at),
                second: visit(to, at),
            },
            Self::Arrival { agent } => below(Some(agent), Cost::Makespan, None)?,
            Self::Length { agent, fewer_than } => below(Some(agent), Cost::Moves, *fewer_than)?,
            Self::Makespan => below(None, Cost::Makespan, None)?,
            Self::SumOfCosts => below(None, Cost::SumOfCosts, None)?,
            Self::Penalty => below(None, Cost::Penalty, None)?,
            Self::Charges { agent } => below(agent.as_ref(), Cost::Charges, None)?,
            Self::Moves { agent } => below(agent.as_ref(), Cost::Moves, None)?,
            Self::Waits { agent } => below(agent.as_ref(), Cost::Waits, None)?,
            Self::Rule { rule } => Condition::Keeps(rule.clone()),
            Self::Unsolvable | Self::Plan => return None,
        })
    }

    /// The question about what an agent does or does not do that has this contrast;
    /// `None` where none has.
    pub fn with_contrast(condition: Condition) -> Option<Self> {
        let time = |times: Times| (times == Times::at(times.from)).then_some(times.from);
        Some(match condition {
            Condition::Never { agent, act, times } => match act {
                Act::Wait { cell: at, steps } => Self::Wait {
                    agent,
                    at,
                    from: times.from,
                    to: times.to,
                    at_least: (steps > 1).then_some(steps),
                },
                Act::Charge(at) => Self::Charge {
                    agent,
                    at,
                    time: time(times)?,
                },
                Act::Visit(at) => Self::Visit {
                    agent,
                    at,
                    time: time(times)?,
                },
                Act::Move(from_cell, to_cell) => Self::Move {
                    agent,
                    from_cell,
                    to_cell,
                    time: time(times)?,
                },
                Act::SlowMove(edge) if times.are_all() => {
                    let (from_cell, to_cell) = edge.unzip();
                    Self::Slow {
                        agent,
                        from_cell,
                        to_cell,
                    }
                }
                Act::SlowMove(_) => return None,
            },
            Condition::Charge { agent, cell: at } => Self::NoCharge { agent, at },
            Condition::Visit { agent, cell: at } => Self::NoVisit { agent, at },
            Condition::Move {
                agent,
                from: from_cell,
                to: to_cell,
                times,
            } => Self::NoMove {
                agent,
                from_cell,
                to_cell,
                time: time(times)?,
            },
            Condition::Before { first, second } if first.agent == second.agent => Self::Order {
                agent: first.agent,
                first: second.cell,
                second: first.cell,
            },
            Condition::Before { first, second } if first.cell == second.cell => Self::Yield {
                agent: first.agent,
                to: second.agent,
                at: first.cell,
            },
            Condition::Keeps(rule) => Self::Rule { rule },
            Condition::Before { .. } | Condition::Below { .. } => return None,
        })
    }
}
