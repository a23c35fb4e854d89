//! The facts of a plan that a question about one agent gets wrong.

use super::Misfit;
use super::{Question, so};
use crate::check::Walk;
use crate::condition::{Times, first_visit, goes, moves};
use crate::{Instance, tr};

/// The facts of the plan, for the questions about one agent.
#[expect(clippy::too_many_lines, reason = "an arm for each kind of question")]
pub(super) fn not_so(
    question: &Question,
    instance: &Instance,
    walk: &Walk<'_>,
) -> Result<(), Misfit> {
    let name = walk.agent.name.as_str();
    let agent = || name.to_owned();
    let misfit = |is_so: String, ask: Option<Question>| Err(Misfit::NotSo { is_so, ask });
    match *question {
        Question::Wait {
            at,
            from,
            to,
            at_least,
            ..
        } => {
            let place = at.map_or(String::new(), |at| tr!("something done" => " at {at}", at));
            let time = match (from, to) {
                (None, None) => String::new(),
                (from, Some(to)) => {
                    tr!("something done" => " from time {from} to {to}", from = from.unwrap_or(0), to)
                }
                (Some(from), None) => tr!("something done" => " from time {from} on", from),
            };
            let long = match at_least {
                Some(steps) if steps > 1 => {
                    tr!("something done" => " {steps} steps in a row", steps)
                }
                _ => String::new(),
            };
            let waits = so::waits(instance, walk);
            let asked = waits
                .iter()
                .find(|(cell, ..)| at.is_none_or(|at| at == *cell));
            let ask = match asked.or(waits.first()) {
                Some(&(cell, from, to)) => Question::Wait {
                    agent: agent(),
                    at: Some(cell),
                    from: Some(from),
                    to: Some(to),
                    at_least: None,
                },
                None => Question::Arrival { agent: agent() },
            };
            let so = so::waiting(instance, walk);
            misfit(
                tr!(
                    "{name} does not wait{place}{time}{long}. {so}",
                    name,
                    place,
                    time,
                    long,
                    so
                ),
                Some(ask),
            )
        }
        Question::Charge { at, time, .. } => {
            let place = at.map_or(String::new(), |at| tr!("something done" => " at {at}", at));
            let when = time.map_or(
                String::new(),
                |time| tr!("something done" => " at time {time}", time),
            );
            let ask = match (walk.charges.first(), at) {
                (Some(&charge), _) => Some(Question::Charge {
                    agent: agent(),
                    at: walk.at(charge as usize),
                    time: Some(charge),
                }),
                (None, Some(at)) => Some(Question::NoCharge { agent: agent(), at }),
                (None, None) => None,
            };
            let so = so::charging(walk);
            misfit(
                tr!(
                    "{name} does not charge{place}{when}. {so}",
                    name,
                    place,
                    when,
                    so
                ),
                ask,
            )
        }
        Question::NoCharge { at, .. } => {
            let ask = Question::Charge {
                agent: agent(),
                at: Some(at),
                time: None,
            };
            let so = so::charging(walk);
            misfit(
                tr!("{name} does charge at {at}. {so}", name, at, so),
                Some(ask),
            )
        }
        Question::Visit { at, time, .. } => {
            let visit = first_visit(walk, at);
            let is_so = match (time, visit) {
                (Some(time), Some(_)) => tr!(
                    "{name} is not at {at} at time {time}. {whereabouts}",
                    name,
                    at,
                    time,
                    whereabouts = so::whereabouts(instance, walk, time)
                ),
                _ => tr!("{name} never passes {at}.", name, at),
            };
            let ask = if visit.is_some() {
                Some(Question::Visit {
                    agent: agent(),
                    at,
                    time: None,
                })
            } else if instance.grid().is_vertex(at) {
                let agent = Some(agent());
                Some(Question::NoVisit { agent, at })
            } else {
                None
            };
            misfit(is_so, ask)
        }
        Question::NoVisit { at, .. } => {
            let time = first_visit(walk, at).unwrap_or(0);
            let ask = Question::Visit {
                agent: agent(),
                at,
                time: None,
            };
            misfit(
                tr!("{name} does pass {at}, at time {time}.", name, at, time),
                Some(ask),
            )
        }
        Question::Move {
            from_cell,
            to_cell,
            time,
            ..
        } => {
            let ever = goes(instance, walk, from_cell, to_cell, Times::default());
            let when = time.map_or(
                String::new(),
                |time| tr!("something done" => " at time {time}", time),
            );
            let so = so::going(instance, walk, from_cell, to_cell);
            let agent = agent();
            let ask = if ever {
                Question::Move {
                    agent,
                    from_cell,
                    to_cell,
                    time: None,
                }
            } else {
                Question::NoMove {
                    agent,
                    from_cell,
                    to_cell,
                    time,
                }
            };
            misfit(
                tr!(
                    "{name} does not go from {from_cell} to {to_cell}{when}. {so}",
                    name,
                    from_cell,
                    to_cell,
                    when,
                    so
                ),
                Some(ask),
            )
        }
        Question::NoMove {
            from_cell,
            to_cell,
            time,
            ..
        } => {
            let so = so::going(instance, walk, from_cell, to_cell);
            let ask = Question::Move {
                agent: agent(),
                from_cell,
                to_cell,
                time,
            };
            misfit(tr!("{name} does go that way. {so}", name, so), Some(ask))
        }
        Question::Slow {
            from_cell, to_cell, ..
        } => {
            let so = so::slowly(instance, walk);
            let over = match (from_cell, to_cell) {
                (Some(u), Some(v)) => tr!("something done" => " between {u} and {v}", u, v),
                _ => String::new(),
            };
            let ask = so.is_some().then(|| Question::Slow {
                agent: agent(),
                from_cell: None,
                to_cell: None,
            });
            let so = so.map_or_else(String::new, |so| format!(" {so}"));
            misfit(
                tr!("{name} makes no slow move{over}.{so}", name, over, so),
                ask,
            )
        }
        Question::Order { first, second, .. } => {
            let is_so = match (first_visit(walk, first), first_visit(walk, second)) {
                (Some(first), Some(second)) if first < second => return Ok(()),
                (Some(p), Some(q)) => {
                    tr!(
                        "{name} visits {second} first, at time {q}, and {first} at time {p}.",
                        name,
                        second,
                        q,
                        first,
                        p
                    )
                }
                (None, _) => tr!("{name} never visits {first}.", name, first),
                (_, None) => tr!("{name} never visits {second}.", name, second),
            };
            let both = first_visit(walk, first).and(first_visit(walk, second));
            let ask = both.map(|_| Question::Order {
                agent: agent(),
                first: second,
                second: first,
            });
            misfit(is_so, ask)
        }
        Question::Length { .. } => {
            let moves = moves(instance, walk);
            let ask = Question::Length {
                agent: agent(),
                fewer_than: None,
            };
            misfit(
                tr!("{name} makes only {moves} moves.", name, moves),
                Some(ask),
            )
        }
        Question::Yield { .. }
        | Question::Arrival { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => Ok(()),
    }
}
