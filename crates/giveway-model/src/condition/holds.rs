//! Whether a plan meets a condition.
//!
//! A judge, like [`crate::check`]: it reads plans as they are and shares
//! nothing with the encoding of the same condition.

use super::{Act, Condition, Times, Visit};
use crate::check::{Rule, Step, Walk, check, cost_of, steps};
use crate::{Cell, Instance, Plan};

impl Condition {
    /// Whether a plan meets it. The plan is taken to be valid. `None` where an agent
    /// that it is about has no path.
    ///
    /// ```
    /// use giveway_model::condition::{Act, Condition, Times};
    /// use giveway_model::{Cell, format::native};
    /// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
    ///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
    /// let plan = native::read_plan(
    ///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [1, 0], [2, 0]] } }"#).unwrap();
    /// let never = |cell: Cell| Condition::Never {
    ///     agent: "A1".into(),
    ///     act: Act::Wait { cell: Some(cell), steps: 1 },
    ///     times: Times::default(),
    /// };
    /// assert_eq!(never(Cell::new(1, 0)).holds(&instance, &plan), Some(false));
    /// assert_eq!(never(Cell::new(0, 0)).holds(&instance, &plan), Some(true));
    /// ```
    pub fn holds(&self, instance: &Instance, plan: &Plan) -> Option<bool> {
        let walk = |name: &str| Walk::named(instance, name, plan);
        let always = Times::default();
        Some(match self {
            Self::Never { agent, act, times } => !does(instance, &walk(agent)?, *act, *times),
            Self::Visit { agent, cell } => {
                let walks = match agent {
                    Some(agent) => vec![walk(agent)?],
                    None => Walk::all(instance, plan),
                };
                let visits = |walk| does(instance, walk, Act::Visit(*cell), always);
                walks.iter().any(visits)
            }
            Self::Move {
                agent,
                from,
                to,
                times,
            } => does(instance, &walk(agent)?, Act::Move(*from, *to), *times),
            Self::Charge { agent, cell } => {
                does(instance, &walk(agent)?, Act::Charge(Some(*cell)), always)
            }
            Self::Before { first, second } => {
                let visit = |visit: &Visit| Some(first_visit(&walk(&visit.agent)?, visit.cell));
                // An agent that does not exist is never there.
                let exists = instance.agents().iter().any(|a| a.name == second.agent);
                let second = if exists { visit(second)? } else { None };
                match (visit(first)?, second) {
                    (Some(first), Some(second)) => first < second,
                    (first, None) => first.is_some(),
                    (None, Some(_)) => false,
                }
            }
            Self::Below { agent, cost, limit } => {
                cost_of(instance, plan, agent.as_deref(), *cost)? < *limit
            }
            Self::Keeps(rule) => {
                for name in rule.named_agents() {
                    walk(name)?;
                }
                let alone = instance.with_only_rule(rule);
                let violations = check(&alone, plan).violations;
                violations.iter().all(|it| it.rule != Rule::Constraint)
            }
        })
    }
}

/// Whether an agent does something at one of some times.
fn does(instance: &Instance, walk: &Walk<'_>, act: Act, times: Times) -> bool {
    match act {
        Act::Visit(cell) => is_at(instance, walk, cell, times),
        Act::Move(from, to) => goes(instance, walk, from, to, times),
        Act::SlowMove(edge) => steps(instance.grid(), walk.path).any(|(time, step)| match step {
            Step::SlowMove { from, to } => {
                let asked = edge.is_none_or(|edge| edge == (from, to) || edge == (to, from));
                asked && times.contains(time as u32)
            }
            _ => false,
        }),
        Act::Wait { cell, steps } => longest_wait(instance, walk, cell, times) >= steps.max(1),
        Act::Charge(cell) => {
            let asked = |&time: &u32| {
                times.contains(time) && cell.is_none_or(|it| walk.at(time as usize) == Some(it))
            };
            walk.charges.iter().any(asked)
        }
    }
}

/// The most wait steps on end at a cell within some times, before the arrival. Waits
/// that had begun before time 0 go on, where the times have a beginning no later.
fn longest_wait(instance: &Instance, walk: &Walk<'_>, cell: Option<Cell>, times: Times) -> u32 {
    let begun = times.first() == 0 && cell.is_none_or(|cell| cell == walk.agent.start);
    let begun = begun.then(|| instance.start_state(&walk.agent.name).waits_begun);
    let (mut longest, mut run) = (0, begun.unwrap_or(0));
    for (time, step) in steps(instance.grid(), walk.path) {
        let here = cell.is_none_or(|cell| walk.at(time) == Some(cell));
        let within = times.contains(time as u32) && times.contains(time as u32 + 1);
        run = if step == Step::Wait && here && within {
            run + 1
        } else {
            0
        };
        longest = run.max(longest);
    }
    longest
}

/// Whether an agent is at a cell at one of some times; resting at its goal is being
/// there, where agents stay.
pub(crate) fn is_at(instance: &Instance, walk: &Walk<'_>, cell: Cell, times: Times) -> bool {
    let rests = instance.keeps(walk.agent) && times.last() as usize > walk.arrival();
    let mut entries = walk.path.iter().enumerate();
    rests && walk.end() == Some(cell)
        || entries.any(|(time, &entry)| entry == Some(cell) && times.contains(time as u32))
}

/// Where an agent goes: when it leaves, from where, to where.
pub(crate) fn turns(instance: &Instance, walk: &Walk<'_>) -> Vec<(u32, Cell, Cell)> {
    steps(instance.grid(), walk.path)
        .filter_map(|(begin, step)| match step {
            Step::Move { from, to } | Step::SlowMove { from, to } => Some((begin as u32, from, to)),
            _ => None,
        })
        .collect()
}

/// Whether an agent leaves one cell for another at one of some times.
pub(crate) fn goes(
    instance: &Instance,
    walk: &Walk<'_>,
    from: Cell,
    to: Cell,
    times: Times,
) -> bool {
    let mut turns = turns(instance, walk).into_iter();
    turns.any(|(begin, u, v)| (u, v) == (from, to) && times.contains(begin))
}

pub(crate) fn first_visit(walk: &Walk<'_>, cell: Cell) -> Option<usize> {
    walk.path.iter().position(|&entry| entry == Some(cell))
}

pub(crate) fn moves(instance: &Instance, walk: &Walk<'_>) -> u32 {
    let moves = steps(instance.grid(), walk.path).filter(|(_, step)| *step != Step::Wait);
    moves.count() as u32
}
