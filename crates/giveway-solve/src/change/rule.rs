//! Rules of a scene's own that leave an agent, or several of them, no plan.

use std::collections::BTreeSet;

use giveway_model::{Cell, constraint::ConstraintKind};

use super::{CauseKind, CauseRule, freed::Exists, keep::MethodRefusal, method_case::MethodCase};
use crate::{
    budget::Stop,
    problem::{Problem, ProblemError},
    single::Bounds,
};

/// The most rules between agents that are left out one by one to find a cause.
const MOST_RULES: usize = 12;

impl MethodCase<'_, '_> {
    /// The rule that an agent cannot keep alone within its bounds, where it could do its task
    /// without rules; of several that it cannot keep together, the first.
    pub(super) fn unkept_rule(&self, number: usize, bounds: &[Bounds]) -> Option<MethodRefusal> {
        let (agent, _) = self.agent(number)?;
        let own = bounds.get(number)?;
        let whole = self.snapshot.instance.alone(&agent.name)?;
        let could_without = |left_out: &dyn Fn(usize) -> bool| {
            let mut instance = whole.clone();
            instance.switch_off(left_out);
            let problem = Problem::bounded(&instance, vec![own.clone()], &self.budget);
            match problem {
                Ok(_) => Some(true),
                Err(ProblemError::Alone(..)) => Some(false),
                Err(ProblemError::TooManyWaypoints(_) | ProblemError::Stopped(_)) => None,
            }
        };
        if !could_without(&|_| true)? {
            return None;
        }
        let binds = |&index: &usize| {
            let rule = self.snapshot.instance.constraints().get(index);
            let agents = self.snapshot.instance.agents();
            let bound = rule.and_then(|rule| rule.in_force(index, agents));
            let state = self.snapshot.instance.start_state(&agent.name);
            bound.is_some_and(|rule| rule.agents.contains(&number))
                || state.closed_cells.iter().any(|it| it.rule == index)
        };
        let all = 0..self.snapshot.instance.constraints().len();
        let mut core: BTreeSet<usize> = giveway_model::sorting::set(all.filter(binds));
        for index in core.clone() {
            core.remove(&index);
            if could_without(&|other| !core.contains(&other))? {
                core.insert(index);
            }
        }
        let &rule = core.first()?;
        Some(MethodRefusal {
            kind: CauseKind::Rule,
            cell: self.cell_of_rule(rule, number),
            rule: Some(rule),
        })
    }

    /// Where a rule is in the way of an agent: the first cell of the rest of its path in the
    /// zone, or the cell that it has to be at.
    fn cell_of_rule(&self, index: usize, number: usize) -> Option<Cell> {
        let instance = &self.snapshot.instance;
        let (_, running) = self.agent(number)?;
        let on_path = |zone: &String| {
            let zone = instance.zone(zone)?;
            let mut cells = running.cells().into_iter();
            cells.find(|&cell| zone.has(cell))
        };
        match &instance.constraints().get(index)?.kind {
            ConstraintKind::Capacity { zone, .. }
            | ConstraintKind::Closed { zone, .. }
            | ConstraintKind::NoWaiting { zone, .. } => on_path(zone),
            ConstraintKind::Sequence { cells, .. } => cells.first().copied(),
            ConstraintKind::Visit { cell, .. } => Some(*cell),
            ConstraintKind::Before { second, .. } => Some(second.cell),
            ConstraintKind::OneWay { lane } => {
                let cells = running.cells();
                let mut moves = cells.windows(2);
                let against =
                    moves.find(|it| lane.windows(2).any(|pair| it.iter().eq(pair.iter().rev())));
                against.and_then(|it| it.first().copied())
            }
            ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => None,
        }
    }

    /// A rule between agents without which there is a plan with these agents freed, where
    /// there is none; of several that leave none together, the first.
    pub(super) fn blocking_rule(&self, freed: &BTreeSet<usize>) -> Option<usize> {
        let instance = &self.snapshot.instance;
        let between = instance.constraints_in_force();
        let between = between.filter(|rule| rule.constraint.is_between());
        let mut core: BTreeSet<usize> = giveway_model::sorting::set(between.map(|rule| rule.index));
        if core.is_empty() || core.len() > MOST_RULES {
            return None;
        }
        let could_without = |left_out: &BTreeSet<usize>| -> Result<bool, Stop> {
            let mut snapshot = self.snapshot.clone();
            snapshot
                .instance
                .switch_off(|index| left_out.contains(&index));
            let case = MethodCase {
                snapshot: &snapshot,
                method: self.method,
                objective: self.objective,
                within: self.within,
                budget: self.budget.clone(),
            };
            Ok(matches!(case.exists(freed)?, Exists::Yes))
        };
        let all = core.clone();
        if !could_without(&all).ok()? {
            return None;
        }
        for &index in &all {
            core.remove(&index);
            let left_out: BTreeSet<usize> =
                giveway_model::sorting::set(all.difference(&core).copied());
            if could_without(&left_out).ok()? {
                core.insert(index);
            }
        }
        core.first().copied()
    }

    /// A rule by its number, as a cause tells it: as it was written.
    pub(super) fn told_rule(&self, index: usize) -> Option<Box<CauseRule>> {
        let rule = self.snapshot.history.constraints().get(index)?;
        Some(Box::new(CauseRule {
            index: index as u32,
            constraint: rule.constraint.clone(),
        }))
    }
}
