//! Whether another plan is what a question contrasts the plan with.
//!
//! A judge, like [`crate::check`]: it reads plans as they are and shares
//! nothing with the encoding of the same constraint.

use super::Question;
use crate::check::{self, Step, Walk, steps};
use crate::{Cell, Instance, Plan};

/// Whether the counterfactual of a question about `plan` holds in `other`.
///
/// Both plans are taken to be valid. Times are those of `other`, with its own
/// arrivals. `None` where the question has no counterfactual (`unsolvable`,
/// `plan`), or an agent that it names has no path.
///
/// ```
/// use giveway_model::{Cell, Question, format::native, question::holds};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let slow = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let fast = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let why = Question::Wait {
///     agent: "A1".into(), at: Some(Cell::new(1, 0)), from: None, to: None, at_least: None,
/// };
/// assert_eq!(holds(&why, &instance, &slow, &fast), Some(true));
/// assert_eq!(holds(&why, &instance, &slow, &slow), Some(false));
/// ```
#[expect(clippy::too_many_lines, reason = "an arm for each kind of question")]
pub fn holds(question: &Question, instance: &Instance, plan: &Plan, other: &Plan) -> Option<bool> {
    let walk = |name: &str| walk(instance, other, name);
    let before = |name: &str| self::walk(instance, plan, name);
    Some(match question {
        Question::Wait {
            agent,
            at,
            from,
            to,
            at_least,
        } => longest_wait(instance, &walk(agent)?, *at, *from, *to) < at_least.unwrap_or(1).max(1),
        Question::Charge { agent, at, time } => {
            let walk = walk(agent)?;
            let asked = |&charge: &u32| {
                time.is_none_or(|time| time == charge)
                    && at.is_none_or(|at| walk.at(charge as usize) == Some(at))
            };
            !walk.charges.iter().any(asked)
        }
        Question::NoCharge { agent, at } => {
            let walk = walk(agent)?;
            let there = |&charge: &u32| walk.at(charge as usize) == Some(*at);
            walk.charges.iter().any(there)
        }
        Question::Visit { agent, at, time } => !is_at(instance, &walk(agent)?, *at, *time),
        Question::NoVisit {
            agent: Some(agent),
            at,
        } => is_at(instance, &walk(agent)?, *at, None),
        Question::NoVisit { agent: None, at } => Walk::all(instance, other)
            .iter()
            .any(|walk| is_at(instance, walk, *at, None)),
        Question::Move {
            agent,
            from_cell,
            to_cell,
            time,
        } => !goes(instance, &walk(agent)?, *from_cell, *to_cell, *time),
        Question::NoMove {
            agent,
            from_cell,
            to_cell,
            time,
        } => goes(instance, &walk(agent)?, *from_cell, *to_cell, *time),
        Question::Slow {
            agent,
            from_cell,
            to_cell,
        } => {
            let edge = from_cell.zip(*to_cell);
            !steps(instance.grid(), walk(agent)?.path).any(|(_, step)| match step {
                Step::SlowMove { from, to } => {
                    edge.is_none_or(|edge| edge == (from, to) || edge == (to, from))
                }
                _ => false,
            })
        }
        Question::Order {
            agent,
            first,
            second,
        } => {
            let walk = walk(agent)?;
            match (first_visit(&walk, *first), first_visit(&walk, *second)) {
                (Some(first), Some(second)) => second < first,
                (None, Some(_)) => true,
                (_, None) => false,
            }
        }
        Question::Arrival { agent } => walk(agent)?.arrival() < before(agent)?.arrival(),
        Question::Length { agent, fewer_than } => {
            let most = match fewer_than {
                Some(most) => *most,
                None => moves(instance, &before(agent)?),
            };
            moves(instance, &walk(agent)?) < most
        }
        Question::Makespan => {
            check::costs(instance, other)?.makespan < check::costs(instance, plan)?.makespan
        }
        Question::SumOfCosts => {
            check::costs(instance, other)?.sum_of_costs < check::costs(instance, plan)?.sum_of_costs
        }
        Question::Charges { agent } => {
            let count = |_: &Instance, walk: &Walk<'_>| walk.charges.len() as u32;
            let agent = agent.as_deref();
            total(instance, other, agent, count)? < total(instance, plan, agent, count)?
        }
        Question::Moves { agent } => {
            let agent = agent.as_deref();
            total(instance, other, agent, moves)? < total(instance, plan, agent, moves)?
        }
        Question::Waits { agent } => {
            let agent = agent.as_deref();
            total(instance, other, agent, waits)? < total(instance, plan, agent, waits)?
        }
        Question::Yield { agent, to, at } => {
            let first = first_visit(&walk(agent)?, *at);
            let others = first_visit(&walk(to)?, *at);
            match (first, others) {
                (Some(first), Some(others)) => first < others,
                (Some(_), None) => true,
                (None, _) => false,
            }
        }
        Question::Unsolvable | Question::Plan => return None,
    })
}

pub(super) fn walk<'a>(instance: &'a Instance, plan: &'a Plan, name: &str) -> Option<Walk<'a>> {
    let index = instance.agents().iter().position(|a| a.name == name)?;
    Walk::of(instance, index, plan)
}

/// The most wait steps on end at a cell within an interval, before the arrival.
///
/// A wait step from t to t + 1 lies in the interval iff both of them do.
fn longest_wait(
    instance: &Instance,
    walk: &Walk<'_>,
    at: Option<Cell>,
    from: Option<u32>,
    to: Option<u32>,
) -> u32 {
    let (from, to) = (from.unwrap_or(0), to.unwrap_or(u32::MAX));
    let (mut longest, mut run) = (0, 0);
    for (time, step) in steps(instance.grid(), walk.path) {
        let time = time as u32;
        let here = at.is_none_or(|at| walk.at(time as usize) == Some(at));
        let asked = step == Step::Wait && here && from <= time && time < to;
        run = if asked { run + 1 } else { 0 };
        longest = run.max(longest);
    }
    longest
}

/// Whether an agent is at a cell, at a time or ever; resting at its goal is
/// being there, where agents stay.
pub(super) fn is_at(instance: &Instance, walk: &Walk<'_>, at: Cell, time: Option<u32>) -> bool {
    match time {
        None => walk.path.contains(&Some(at)),
        Some(time) if time as usize > walk.arrival() => instance.stays() && walk.end() == Some(at),
        Some(time) => walk.at(time as usize) == Some(at),
    }
}

/// Where an agent goes: when it leaves, from where, to where.
pub(super) fn turns(instance: &Instance, walk: &Walk<'_>) -> Vec<(u32, Cell, Cell)> {
    steps(instance.grid(), walk.path)
        .filter_map(|(begin, step)| match step {
            Step::Move { from, to } | Step::SlowMove { from, to } => Some((begin as u32, from, to)),
            _ => None,
        })
        .collect()
}

/// Whether an agent leaves one cell for another, at a time or ever.
pub(super) fn goes(
    instance: &Instance,
    walk: &Walk<'_>,
    from: Cell,
    to: Cell,
    time: Option<u32>,
) -> bool {
    let mut turns = turns(instance, walk).into_iter();
    turns.any(|(begin, u, v)| (u, v) == (from, to) && time.is_none_or(|time| time == begin))
}

pub(super) fn first_visit(walk: &Walk<'_>, cell: Cell) -> Option<usize> {
    walk.path.iter().position(|&entry| entry == Some(cell))
}

pub(super) fn moves(instance: &Instance, walk: &Walk<'_>) -> u32 {
    let moves = steps(instance.grid(), walk.path).filter(|(_, step)| *step != Step::Wait);
    moves.count() as u32
}

fn waits(instance: &Instance, walk: &Walk<'_>) -> u32 {
    let waits = steps(instance.grid(), walk.path).filter(|(_, step)| *step == Step::Wait);
    waits.count() as u32
}

/// A count of one agent, or of all.
fn total(
    instance: &Instance,
    plan: &Plan,
    agent: Option<&str>,
    count: impl Fn(&Instance, &Walk<'_>) -> u32,
) -> Option<u32> {
    if let Some(agent) = agent {
        return Some(count(instance, &walk(instance, plan, agent)?));
    }
    let walks = Walk::all(instance, plan);
    let all = walks.len() == instance.agents().len();
    all.then(|| walks.iter().map(|walk| count(instance, walk)).sum())
}
