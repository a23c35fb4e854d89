//! The condition that a question sets another plan, in clauses.

use giveway_model::{Cell, Instance, Question};

use super::agent::Walker;
use super::{Cnf, Lit, Name, NoFormula, count};
use crate::condition::Condition;

/// Says that the condition holds.
pub(super) fn require(
    cnf: &mut Cnf,
    instance: &Instance,
    walkers: &[Walker<'_>],
    condition: &Condition,
    limit: usize,
) -> Result<(), NoFormula> {
    let find = |name: &str| {
        let index = instance.agents().iter().position(|a| a.name == name);
        index.and_then(|i| walkers.get(i)).ok_or(NoFormula::NoAgent)
    };
    match condition {
        Condition::Arrival { agent, before } => {
            let walker = find(agent)?;
            cnf.clause(before.checked_sub(1).and_then(|time| walker.done_by(time)));
        }
        Condition::AtMost { agent, cost, most } => {
            let walker = find(agent)?;
            let counted = walker.counted(cnf, *cost);
            count::at_most(cnf, *cost, &[counted], false, *most as usize, limit);
        }
        Condition::Contrast(question) => {
            if let Question::NoVisit { agent: None, at } = question {
                let visits = walkers.iter().flat_map(|walker| walker.visits(*at, None));
                cnf.clause(visits.collect::<Vec<Lit>>());
            } else {
                let walker = find(question.agent().ok_or(NoFormula::NoAgent)?)?;
                let other = match question {
                    Question::Yield { to, .. } => Some(find(to)?),
                    _ => None,
                };
                contrast(cnf, instance, question, walker, other);
            }
        }
    }
    Ok(())
}

fn contrast(
    cnf: &mut Cnf,
    instance: &Instance,
    question: &Question,
    walker: &Walker<'_>,
    other: Option<&Walker<'_>>,
) {
    match question {
        Question::Wait {
            at,
            from,
            to,
            at_least,
            ..
        } => {
            let cells: Vec<Cell> = match at {
                Some(cell) => vec![*cell],
                None => instance.grid().cells().map(|(cell, _)| cell).collect(),
            };
            let steps = at_least.unwrap_or(1).max(1);
            let end = to.unwrap_or(u32::MAX).min(walker.last());
            for begin in from.unwrap_or(0)..=end.saturating_sub(steps) {
                if begin.saturating_add(steps) > end {
                    break;
                }
                for &cell in &cells {
                    walker.exclude_wait(cnf, cell, begin, steps);
                }
            }
        }
        Question::Charge { at, time, .. } => {
            for (charge, when) in walker.charging() {
                if time.is_none_or(|time| time == when) {
                    match at {
                        None => cnf.clause([-charge]),
                        Some(cell) => {
                            if let Some(there) = walker.at(*cell, when) {
                                cnf.clause([-charge, -there]);
                            }
                        }
                    }
                }
            }
        }
        Question::NoCharge { at, .. } => {
            let there = walker.charging().into_iter();
            let both = there.filter_map(|(charge, when)| {
                let there = walker.at(*at, when)?;
                Some((vec![charge, there], when))
            });
            one_happens(cnf, both.collect());
        }
        Question::Visit { at, time, .. } => {
            for there in walker.visits(*at, *time) {
                cnf.clause([-there]);
            }
            // After the horizon it rests at its goal.
            if time.is_some_and(|time| time > walker.last()) && walker.rests_at(*at) {
                cnf.clause([]);
            }
        }
        Question::NoVisit { at, .. } => cnf.clause(walker.visits(*at, None)),
        Question::Move {
            from_cell,
            to_cell,
            time,
            ..
        } => {
            for (begins, _) in walker.moves_between(*from_cell, *to_cell, *time) {
                cnf.implies(&begins, []);
            }
        }
        Question::NoMove {
            from_cell,
            to_cell,
            time,
            ..
        } => one_happens(cnf, walker.moves_between(*from_cell, *to_cell, *time)),
        Question::Slow {
            from_cell, to_cell, ..
        } => {
            let edge = from_cell.zip(*to_cell);
            for half in walker.slow_moves(edge) {
                cnf.clause([-half]);
            }
        }
        Question::Order { first, second, .. } => {
            before(cnf, (walker, *second), (walker, *first));
        }
        Question::Yield { at, .. } => {
            if let Some(other) = other {
                before(cnf, (walker, *at), (other, *at));
            }
        }
        // These are limits of costs, or no conditions at all.
        Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Unsolvable
        | Question::Plan => {}
    }
}

/// At some time all literals of an entry hold.
fn one_happens(cnf: &mut Cnf, entries: Vec<(Vec<Lit>, u32)>) {
    let mut some = Vec::new();
    for (all, time) in entries {
        let happens = cnf.variable(Name::Happens(time));
        for lit in all {
            cnf.implies(&[happens], [lit]);
        }
        some.push(happens);
    }
    cnf.clause(some);
}

/// At some time one agent is at its cell, and the other has not been at its own
/// up to then.
fn before(cnf: &mut Cnf, early: (&Walker<'_>, Cell), late: (&Walker<'_>, Cell)) {
    let mut entries = Vec::new();
    let mut been_before = None;
    for time in 0..=early.0.last() {
        let been = cnf.variable(Name::Been(time));
        let there = late.0.at(late.1, time);
        for earlier in been_before.into_iter().chain(there) {
            cnf.implies(&[earlier], [been]);
        }
        been_before = Some(been);
        if let Some(here) = early.0.at(early.1, time) {
            entries.push((vec![here, -been], time));
        }
    }
    one_happens(cnf, entries);
}
