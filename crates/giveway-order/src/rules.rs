//! The rules of a scene's own that the order keeps: turning takes time, gaps between agents.

use giveway_model::change::History;
use giveway_model::constraint::{ConstraintKind, Heading, TimedConstraint};
use giveway_model::{Cell, Constraint};

use crate::events::Time;

/// The rules of the whole time that are in force.
fn whole_time(history: &History) -> impl Iterator<Item = &Constraint> {
    let rules = history.constraints().iter().filter(|rule| is_whole(rule));
    rules.map(|rule| &rule.constraint)
}

/// Whether a rule is in force all the time.
pub(crate) fn is_whole(rule: &TimedConstraint) -> bool {
    !rule.constraint.off && rule.since.is_none() && rule.until.is_none()
}

/// Whether a rule binds an agent.
fn binds(rule: &Constraint, agent: &str) -> bool {
    let named = rule.agents.as_ref();
    named.is_none_or(|names| names.iter().any(|name| name == agent))
}

/// A number of steps that a rule asks for.
enum Steps {
    /// For each quarter turn.
    Turn(u32),
    /// Between two agents in a cell.
    Gap(u32),
}

/// What a rule asks for of what the order keeps.
const fn steps(rule: &Constraint) -> Option<Steps> {
    match rule.kind {
        ConstraintKind::Turns { quarter } => Some(Steps::Turn(quarter)),
        ConstraintKind::Gap { steps } => Some(Steps::Gap(steps)),
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Avoid { .. } => None,
    }
}

/// The rules by which turning takes time.
pub(crate) struct TurnRules<'a> {
    rules: Vec<(&'a Constraint, u32)>,
}

impl<'a> TurnRules<'a> {
    pub(crate) fn of(history: &'a History) -> Self {
        let rules = whole_time(history).filter_map(|rule| match steps(rule)? {
            Steps::Turn(quarter) => Some((rule, quarter)),
            Steps::Gap(_) => None,
        });
        Self {
            rules: rules.collect(),
        }
    }

    /// The steps that an agent has to stand before a move, and its heading after it.
    pub(crate) fn stands(
        &self,
        agent: &str,
        heading: &mut Option<Heading>,
        (from, to): (Cell, Cell),
    ) -> Time {
        let next = Heading::of(from, to);
        let turned = heading.zip(next);
        *heading = next;
        let quarters = turned.map_or(0, |(before, next)| before.quarters_to(next));
        let bound = self.rules.iter().filter(|(rule, _)| binds(rule, agent));
        let steps = bound.map(|(_, quarter)| quarters.saturating_mul(*quarter));
        Time::from(steps.max().unwrap_or(0))
    }
}

/// The rules by which there is a gap between agents in a cell.
pub(crate) struct GapRules<'a> {
    rules: Vec<(&'a Constraint, u32)>,
}

impl<'a> GapRules<'a> {
    pub(crate) fn of(history: &'a History) -> Self {
        let rules = whole_time(history).filter_map(|rule| match steps(rule)? {
            Steps::Gap(steps) => Some((rule, steps)),
            Steps::Turn(_) => None,
        });
        Self {
            rules: rules.collect(),
        }
    }

    /// The longest gap of all.
    pub(crate) fn longest(&self) -> Time {
        Time::from(
            self.rules
                .iter()
                .map(|&(_, steps)| steps)
                .max()
                .unwrap_or(0),
        )
    }

    /// How many steps a cell stays closed to the second agent after the first was there.
    pub(crate) fn between(&self, first: &str, second: &str) -> Time {
        let bound = |rule: &&(&Constraint, u32)| binds(rule.0, first) && binds(rule.0, second);
        let steps = self.rules.iter().filter(bound).map(|&(_, steps)| steps);
        Time::from(steps.max().unwrap_or(0))
    }
}
