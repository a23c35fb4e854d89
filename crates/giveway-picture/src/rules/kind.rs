//! What kinds of rules have in common: a zone, times.

use giveway_model::Constraint;
use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;

/// The zone of a rule, by its name.
pub const fn zone_of(kind: &ConstraintKind) -> Option<&str> {
    match kind {
        ConstraintKind::Capacity { zone, .. }
        | ConstraintKind::Closed { zone, .. }
        | ConstraintKind::NoWaiting { zone, .. }
        | ConstraintKind::Avoid { zone, .. } => Some(zone.as_str()),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Turns { .. } => None,
    }
}

/// The times of a rule, of a kind that has some.
pub(super) const fn times_of(kind: &ConstraintKind) -> Option<Times> {
    match kind {
        ConstraintKind::Capacity { times, .. }
        | ConstraintKind::Closed { times, .. }
        | ConstraintKind::Apart { times, .. }
        | ConstraintKind::Visit { times, .. }
        | ConstraintKind::Arrive { times } => Some(*times),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => None,
    }
}

/// Which rules are in force at a time.
pub fn in_force(rules: &[Constraint], time: u32) -> Vec<bool> {
    let holds = |rule: &Constraint| {
        let times = times_of(&rule.kind);
        !rule.off && times.is_none_or(|times| times.contains(time))
    };
    rules.iter().map(holds).collect()
}
