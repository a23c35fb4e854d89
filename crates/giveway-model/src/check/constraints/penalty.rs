//! What rules of a scene's own make a plan cost.

use super::{Judged, Row, Table, Walk};
use crate::Instance;
use crate::constraint::ConstraintKind;

/// What the rules of the scene's own make the walks of a plan cost.
pub(in super::super) fn penalty(instance: &Instance, walks: &[Walk<'_>]) -> u32 {
    let mut rules = instance.constraints_in_force();
    if !rules.any(|rule| rule.constraint.is_penalty()) {
        return 0;
    }
    let rows = walks.iter().map(|walk| Row::of_walk(instance, walk));
    let table = Table::new((instance.grid(), instance.zones()), rows.collect(), &[]);
    let past = table.rows.iter().filter(|row| row.arrival > 0);
    let past = past.map(|row| row.start.penalty_if_it_goes_on);
    let rules = instance.constraints_in_force().map(Judged::always);
    let penalties = rules.map(|rule| table.penalty(&rule, |row| row.arrival));
    past.chain(penalties).fold(0, u32::saturating_add)
}

impl Table<'_> {
    /// What a rule makes its agents cost, each up to an arrival. An agent that is removed
    /// leaves all costs.
    pub(in super::super) fn penalty(
        &self,
        judged: &Judged<'_>,
        arrival: impl Fn(&Row<'_>) -> u32,
    ) -> u32 {
        let rows = self.rows(&judged.rule).into_iter();
        let rows = rows.filter(|row| !row.is_removed);
        let (first, end) = (judged.span.first(), judged.span.last().saturating_add(1));
        let (times, weight): (Vec<u32>, u32) = match &judged.rule.constraint.kind {
            ConstraintKind::Avoid { zone, weight } => {
                let area = self.area(zone);
                let inside = |row: &Row<'_>| {
                    let times = first..arrival(row).min(end);
                    times.filter(|&time| row.is_in(&area, time)).count() as u32
                };
                (rows.map(inside).collect(), *weight)
            }
            ConstraintKind::Late { by, weight } => {
                let late = |row: &Row<'_>| {
                    let from = first.max(*by);
                    arrival(row).min(end).saturating_sub(from)
                };
                (rows.map(late).collect(), *weight)
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
            | ConstraintKind::Turns { .. } => return 0,
        };
        let times = times.into_iter().fold(0, u32::saturating_add);
        times.saturating_mul(weight)
    }
}
