//! Rules of a scene's own that changes add and remove.

use super::{Reason, World, refuse};
use crate::change::ConstraintRef;
use crate::constraint::{self, MAX_CONSTRAINTS, TimedConstraint};
use crate::{Constraint, Fault};

impl World<'_> {
    pub(super) fn add_constraint(
        &mut self,
        index: usize,
        constraint: &Constraint,
    ) -> Result<(), Reason> {
        if self.after.constraints.len() >= MAX_CONSTRAINTS {
            return Err(refuse::too_many_constraints());
        }
        self.ruled.push((index, self.after.constraints.len()));
        self.after.constraints.push(TimedConstraint {
            constraint: constraint.clone(),
            since: Some(self.at),
            until: None,
        });
        Ok(())
    }

    /// Removes a rule that was there before this time.
    pub(super) fn remove_constraint(&mut self, which: &ConstraintRef) -> Result<(), Reason> {
        let at = self.at;
        let before = self.before.constraints.len();
        let mut rules = self.after.constraints.iter_mut().take(before).zip(0..);
        let found = rules.find(|(rule, index)| {
            let is_it = match which {
                ConstraintRef::Name(name) => rule.constraint.name.as_ref() == Some(name),
                ConstraintRef::Index(wanted) => index == wanted,
            };
            is_it && rule.until.is_none()
        });
        let (rule, _) = found.ok_or_else(|| refuse::unknown_constraint(which))?;
        rule.until = Some(at);
        Ok(())
    }

    /// Finds the faults of new rules, once everything else has changed.
    pub(super) fn look_over_constraints(&mut self) {
        let mut faults = Vec::new();
        let there = |name: &str| {
            let mut old = self.trajectories.iter().map(|it| it.timeline.name());
            let mut new = self.placed.iter().map(|(_, name, _)| name.as_str());
            let mut timelines = self.after.timelines.iter();
            let is_removed =
                timelines.any(|timeline| timeline.name() == name && timeline.until.is_some());
            (old.any(|it| it == name) || new.any(|it| it == name)) && !is_removed
        };
        let world = constraint::World {
            is_agent: &there,
            zones: self.after.zones(),
            grid: &self.grid,
        };
        for &(index, number) in &self.ruled {
            let Some(rule) = self.after.constraints.get(number) else {
                continue;
            };
            let place = format!("changes[{index}].constraint");
            constraint::check(&rule.constraint, &world, place.clone(), &mut faults);
            let Some(name) = &rule.constraint.name else {
                continue;
            };
            let mut others = self.after.constraints.iter().take(number);
            let is_taken = others
                .any(|other| other.until.is_none() && other.constraint.name.as_ref() == Some(name));
            if is_taken || name.is_empty() {
                let (found, expected) = refuse::constraint_name(name);
                faults.push(Fault::at(format!("{place}.name"), found, expected));
            }
        }
        self.faults.append(&mut faults);
    }
}
