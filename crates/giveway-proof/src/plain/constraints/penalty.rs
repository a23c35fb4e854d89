//! What rules make times in a zone and late arrivals cost.

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cost, Instance, sorting};

use super::super::agent::{Moment, Walker};
use super::super::count::{self, Weights};
use super::super::{Cnf, Lit, Name, NoFormula};
use super::area;

/// What all rules make an agent pay, as weighed literals.
pub(in crate::plain) fn penalties(
    cnf: &mut Cnf,
    instance: &Instance,
    walker: &Walker<'_>,
) -> Vec<Weights> {
    let mut groups = Vec::new();
    for rule in instance.constraints_in_force() {
        if !rule.agents.contains(&walker.index()) {
            continue;
        }
        match &rule.constraint.kind {
            ConstraintKind::Avoid { zone, weight } => {
                let area = area(instance, zone);
                // Each time at which it is in the zone, not arrived yet.
                for time in 0..walker.last() {
                    let inside = walker.inside(&area, Moment::At(time));
                    if inside.is_empty() {
                        continue;
                    }
                    let pays = cnf.variable(Name::Pays(rule.index, walker.index(), time));
                    for lit in inside {
                        cnf.implies(&[lit], walker.done_by(time).into_iter().chain([pays]));
                    }
                    groups.push(Weights::from([(*weight, pays)]));
                }
            }
            ConstraintKind::Late { by, weight } => {
                // Each time from `by` on at which it has not arrived: the first ones.
                let late = (*by..walker.last()).filter_map(|time| walker.done_by(time));
                let late = (1u32..).zip(late.map(|done| -done));
                let late = late.map(|(steps, lit)| (steps.saturating_mul(*weight), lit));
                groups.push(first_of_each(late));
            }
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. } => {}
        }
    }
    groups
}

/// Weights that are too large for a number are one: that of the fewest steps.
fn first_of_each(weights: impl Iterator<Item = (u32, Lit)>) -> Weights {
    let mut weights: Vec<(u32, Lit)> = weights.collect();
    weights.dedup_by_key(|(weight, _)| *weight);
    sorting::map(weights)
}

/// The agents pay at most so much together.
pub(in crate::plain) fn limit(
    cnf: &mut Cnf,
    groups: &[Weights],
    most: u32,
    limit: usize,
) -> Result<(), NoFormula> {
    let name = |n| Name::AtLeast(Cost::Penalty, n);
    count::weigh_at_most(cnf, &name, groups, most, limit)
}
