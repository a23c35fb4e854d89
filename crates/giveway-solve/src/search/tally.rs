//! Charges, moves, waits and the penalty of one agent as a number that SAT can bound.
//!
//! Moves are counted by what they waste: with exact distances as potentials, a
//! plan's moves are the fewest possible plus the waste of each step, which is
//! mostly 0. So only wasteful steps have literals. Likewise late steps up to the agent's
//! optimum are certain and are not counted.

use giveway_model::Cost;

use crate::{
    budget::{Budget, Stop},
    encode::{
        agent::{MddEncoding, TakenStep},
        count::EventCounter,
        weighted::WeightedCounter,
    },
    problem::Problem,
    sat::{Clauses, Lit},
    single::{CostToGo, Metric, Node, Place, Task},
};

/// The counter of one agent and cost.
pub(crate) struct CostCounter {
    cost: Cost,
    count: EventCounter,
    /// The penalty, in units.
    weighted: WeightedCounter,
    /// The amount of which each penalty is a multiple.
    unit: u32,
    /// The earliest arrival, up to which late steps are certain.
    optimum: u32,
    /// The count without any event.
    base: u32,
    /// The moves still to make, batteries aside.
    potential: Option<CostToGo>,
    /// The literal "it does not stay where it is", of an agent that stood at its
    /// goal: then these waits count too, before the first step.
    goes_on: Option<Lit>,
}

impl CostCounter {
    pub(crate) fn new(
        problem: &Problem,
        agent: usize,
        cost: Cost,
        budget: &Budget,
    ) -> Result<Self, Stop> {
        let mut base = 0;
        let mut potential = None;
        if cost == Cost::Moves {
            let task = problem.tasks[agent].for_moves();
            let table = CostToGo::new(&task, &problem.terrain, Metric::Moves, budget)?;
            base = table.from(task.start, task.first_mask(), 0).unwrap_or(0);
            potential = Some(table);
        }
        let optimum = problem.optima[agent];
        if cost == Cost::Penalty {
            base = problem.tasks[agent].penalty_of_time(0, optimum);
        }
        Ok(Self {
            cost,
            count: EventCounter::default(),
            weighted: WeightedCounter::default(),
            unit: problem.penalty_unit(),
            optimum,
            base,
            potential,
            goes_on: None,
        })
    }

    /// The literal "more than `most`"; `None` where that is certain.
    pub(crate) fn more_than(&mut self, most: u32, out: &mut impl Clauses) -> Option<Lit> {
        let j = most.checked_sub(self.base)?;
        if self.cost == Cost::Penalty {
            return Some(self.weighted.more_than(j / self.unit, out));
        }
        Some(self.count.more_than(j as usize, out))
    }

    /// Counts the steps that an agent's MDD has gained.
    pub(crate) fn grow(
        &mut self,
        problem: &Problem,
        task: &Task,
        code: &MddEncoding,
        steps: &[TakenStep],
        out: &mut impl Clauses,
    ) {
        if self.cost == Cost::Penalty {
            self.grow_penalty((problem, task), code, steps, out);
            return;
        }
        if self.cost == Cost::Charges {
            let charges = code.battery().map_or(&[][..], |battery| battery.charges());
            for &charge in charges.iter().skip(self.count.times()) {
                self.count.append(charge);
            }
        } else {
            let before = self.before(task, out);
            for step in steps {
                let (from, to) = (code.mdd().node(step.from), code.mdd().node(step.to));
                let taken = [!code.node(step.from), !code.node(step.to)];
                let first = self.goes_on.filter(|_| from.time == 0);
                if let Some(goes_on) = first {
                    out.clause(&[taken[0], taken[1], goes_on]);
                }
                let weight = self.weight(problem, task, from, to);
                if weight > 0 {
                    let event = self.count.event(before + from.time, out)[weight - 1];
                    out.clause(&[taken[0], taken[1], event]);
                }
            }
        }
        self.count.extend(out);
    }

    /// The same of the penalty: each step costs what its place and time cost.
    fn grow_penalty(
        &mut self,
        (problem, task): (&Problem, &Task),
        code: &MddEncoding,
        steps: &[TakenStep],
        out: &mut impl Clauses,
    ) {
        for step in steps {
            let from = code.mdd().node(step.from);
            let all = task.penalty_at(&problem.terrain, from.place, from.time);
            let certain = if from.time < self.optimum {
                task.penalty_of_time(from.time, from.time + 1)
            } else {
                0
            };
            let weight = all.saturating_sub(certain) / self.unit;
            if weight > 0 {
                let event = self.weighted.event(from.time, weight, out);
                out.clause(&[!code.node(step.from), !code.node(step.to), event]);
            }
        }
        self.weighted.extend(out);
    }

    /// The number of events that come before the first step.
    fn before(&mut self, task: &Task, out: &mut impl Clauses) -> u32 {
        if self.cost != Cost::Waits || task.waits_if_it_leaves_goal == 0 {
            return 0;
        }
        let goes_on = *self.goes_on.get_or_insert_with(|| out.fresh());
        while self.count.times() < task.waits_if_it_leaves_goal as usize {
            self.count.append(goes_on);
        }
        task.waits_if_it_leaves_goal
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
