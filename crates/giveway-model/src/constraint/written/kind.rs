//! The kinds of constraints, by their names in files.

use serde::{Deserialize, Deserializer, Serialize};

use crate::constraint::ConstraintKind;
use crate::object::one_of;

/// The kinds of constraints, by their names in files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Kind {
    #[default]
    Capacity,
    Closed,
    OneWay,
    Gap,
    Apart,
    Sequence,
    Visit,
    Arrive,
    Depart,
    Before,
    NoWaiting,
    Turns,
    Avoid,
}

const KINDS: [(&str, Kind); 13] = [
    ("capacity", Kind::Capacity),
    ("closed", Kind::Closed),
    ("one-way", Kind::OneWay),
    ("gap", Kind::Gap),
    ("apart", Kind::Apart),
    ("sequence", Kind::Sequence),
    ("visit", Kind::Visit),
    ("arrive", Kind::Arrive),
    ("depart", Kind::Depart),
    ("before", Kind::Before),
    ("no-waiting", Kind::NoWaiting),
    ("turns", Kind::Turns),
    ("avoid", Kind::Avoid),
];

impl<'de> Deserialize<'de> for Kind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        one_of(deserializer, &KINDS)
    }
}

/// The name of a kind in files.
pub(in crate::constraint) const fn kind_name(kind: &ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Capacity { .. } => "capacity",
        ConstraintKind::Closed { .. } => "closed",
        ConstraintKind::OneWay { .. } => "one-way",
        ConstraintKind::Gap { .. } => "gap",
        ConstraintKind::Apart { .. } => "apart",
        ConstraintKind::Sequence { .. } => "sequence",
        ConstraintKind::Visit { .. } => "visit",
        ConstraintKind::Arrive { .. } | ConstraintKind::Late { .. } => "arrive",
        ConstraintKind::Depart { .. } => "depart",
        ConstraintKind::Before { .. } => "before",
        ConstraintKind::NoWaiting { .. } => "no-waiting",
        ConstraintKind::Turns { .. } => "turns",
        ConstraintKind::Avoid { .. } => "avoid",
    }
}
