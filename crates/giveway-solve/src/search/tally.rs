//! Charges, moves and waits of one agent as a number that SAT can bound.
//!
//! Moves are counted by what they waste: with exact distances as potentials, a
//! plan's moves are the fewest possible plus the waste of each step, which is
//! mostly 0. So only wasteful steps have literals.

use giveway_model::Cost;

use crate::{
    encode::{
        agent::{AgentCode, TakenStep},
        count::Count,
    },
    meter::{Meter, Stop},
    problem::Problem,
    sat::{Clauses, Lit},
    single::{Metric, Node, Place, Task, ToGo},
};

/// The least number of a cost's events in a plan of one agent alone.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn least(
    problem: &Problem,
    agent: usize,
    cost: Cost,
    meter: &Meter,
) -> Result<u32, Stop> {
    let task = &problem.tasks[agent];
    let metric = match cost {
        Cost::Charges if task.reserve.is_some() => Metric::Charges,
        Cost::Moves => Metric::Moves,
        _ => return Ok(0),
    };
    let table = ToGo::new(task, &problem.terrain, metric, meter)?;
    let least = table.from(task.start, task.first_mask(), task.first_level());
    Ok(least.unwrap_or(0))
}

/// The counter of one agent and cost.
pub(crate) struct Tally {
    cost: Cost,
    count: Count,
    /// What is there without any counted event.
    base: u32,
    /// The moves still to make, batteries aside.
    potential: Option<ToGo>,
}

impl Tally {
    pub(crate) fn new(
        problem: &Problem,
        agent: usize,
        cost: Cost,
        meter: &Meter,
    ) -> Result<Self, Stop> {
        let mut base = 0;
        let mut potential = None;
        if cost == Cost::Moves {
            let task = problem.tasks[agent].for_moves();
            let table = ToGo::new(&task, &problem.terrain, Metric::Moves, meter)?;
            base = table.from(task.start, task.first_mask(), 0).unwrap_or(0);
            potential = Some(table);
        }
        Ok(Self {
            cost,
            count: Count::default(),
            base,
            potential,
        })
    }

    /// The literal "more than `most`"; `None` where that is certain.
    pub(crate) fn more_than(&mut self, most: u32, out: &mut impl Clauses) -> Option<Lit> {
        let j = most.checked_sub(self.base)?;
        Some(self.count.more_than(j as usize, out))
    }

    /// Counts the steps that an agent's diagram has gained.
    pub(crate) fn grow(
        &mut self,
        problem: &Problem,
        task: &Task,
        code: &AgentCode,
        steps: &[TakenStep],
        out: &mut impl Clauses,
    ) {
        if self.cost == Cost::Charges {
            let charges = code.battery().map_or(&[][..], |battery| battery.charges());
            for &charge in charges.iter().skip(self.count.times()) {
                self.count.append(charge);
            }
        } else {
            for step in steps {
                let (from, to) = (code.diagram().node(step.from), code.diagram().node(step.to));
                let weight = self.weight(problem, task, from, to);
                if weight > 0 {
                    let event = self.count.event(from.time, out)[weight - 1];
                    out.clause(&[!code.node(step.from), !code.node(step.to), event]);
                }
            }
        }
        self.count.extend(out);
    }

    /// How many events a step counts: 0, 1 or 2.
    fn weight(&self, problem: &Problem, task: &Task, from: &Node, to: &Node) -> usize {
        let waits = matches!((from.place, to.place), (Place::At(u), Place::At(v)) if u == v);
        let Some(potential) = &self.potential else {
            return usize::from(waits);
        };
        let Place::At(u) = from.place else {
            return 0; // a slow move was counted when it began
        };
        if waits {
            return 0;
        }
        let v = match to.place {
            Place::At(v) => v,
            Place::Along(arc) => problem.terrain.ends(arc).1,
        };
        let before = potential.from(u, from.mask, 0).unwrap_or(0);
        let after = potential.from(v, to.mask | task.bit(v), 0).unwrap_or(0);
        (1 + after).saturating_sub(before) as usize
    }
}
