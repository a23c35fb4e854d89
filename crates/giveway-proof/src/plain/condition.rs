//! The condition that a claim sets plans, in clauses.

use giveway_model::condition::{Act, Times};
use giveway_model::{Cell, Condition, Cost, Instance};

use super::agent::Walker;
use super::{Cnf, Lit, Name, NoFormula, constraints, count};

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
    let always = Times::default();
    match condition {
        Condition::Never { agent, act, times } => {
            exclude(cnf, instance, find(agent)?, *act, *times);
        }
        Condition::Visit { agent: None, cell } => {
            let visits = walkers.iter().flat_map(|it| it.visits(*cell, always));
            cnf.clause(visits.collect::<Vec<Lit>>());
        }
        Condition::Visit {
            agent: Some(agent),
            cell,
        } => cnf.clause(find(agent)?.visits(*cell, always)),
        Condition::Move {
            agent,
            from,
            to,
            times,
        } => one_happens(cnf, find(agent)?.moves_between(*from, *to, *times)),
        Condition::Charge { agent, cell } => {
            let walker = find(agent)?;
            let there = walker.charging().into_iter();
            let both = there.filter_map(|(charge, when)| {
                let there = walker.at(*cell, when)?;
                Some((vec![charge, there], when))
            });
            one_happens(cnf, both.collect());
        }
        Condition::Before { first, second } => {
            let (early, late) = (find(&first.agent)?, find(&second.agent)?);
            before(cnf, (early, first.cell), (late, second.cell));
        }
        // It is one of the instance's own here.
        Condition::Keeps(_) => {}
        Condition::Below {
            agent,
            cost,
            limit: below,
        } => {
            // A limit on the costs of all is one of the claim.
            let walker = find(agent.as_deref().ok_or(NoFormula::NoAgent)?)?;
            let most = below.checked_sub(1);
            match cost {
                Cost::Makespan | Cost::SumOfCosts => {
                    cnf.clause(most.and_then(|time| walker.done_by(time)));
                }
                Cost::Charges | Cost::Moves | Cost::Waits => match most {
                    None => cnf.clause([]),
                    Some(most) => {
                        let counted = walker.counted(cnf, *cost);
                        let name = |n| Name::AtLeast(*cost, n);
                        count::at_most(cnf, &name, &[counted], false, most as usize, limit);
                    }
                },
                Cost::Penalty => match most {
                    None => cnf.clause([]),
                    Some(most) => {
                        let paid = constraints::penalties(cnf, instance, walker);
                        constraints::limit(cnf, &paid, most, limit)?;
                    }
                },
            }
        }
    }
    Ok(())
}

/// Says that the agent does this at none of the times.
fn exclude(cnf: &mut Cnf, instance: &Instance, walker: &Walker<'_>, act: Act, times: Times) {
    match act {
        Act::Visit(cell) => {
            for there in walker.visits(cell, times) {
                cnf.clause([-there]);
            }
            // After the horizon it rests where it arrived.
            if !times.are_all() && times.last() > walker.last() {
                walker.exclude_rest(cnf, cell);
            }
        }
        Act::Move(from, to) => {
            for (begins, _) in walker.moves_between(from, to, times) {
                cnf.implies(&begins, []);
            }
        }
        Act::SlowMove(edge) => {
            for half in walker.slow_moves(edge, times) {
                cnf.clause([-half]);
            }
        }
        Act::Wait { cell, steps } => {
            let cells: Vec<Cell> = match cell {
                Some(cell) => vec![cell],
                None => instance.grid().cells().map(|(cell, _)| cell).collect(),
            };
            let steps = steps.max(1);
            let end = times.last().min(walker.last());
            for begin in times.first()..=end.saturating_sub(steps) {
                if begin.saturating_add(steps) > end {
                    break;
                }
                for &cell in &cells {
                    walker.exclude_wait(cnf, cell, begin, steps);
                }
            }
        }
        Act::Charge(cell) => {
            for (charge, when) in walker.charging() {
                if times.contains(when) {
                    match cell {
                        None => cnf.clause([-charge]),
                        Some(cell) => {
                            if let Some(there) = walker.at(cell, when) {
                                cnf.clause([-charge, -there]);
                            }
                        }
                    }
                }
            }
        }
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
