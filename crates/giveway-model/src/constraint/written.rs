//! A constraint as it is written: one object whose keys depend on its kind.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::{Constraint, ConstraintKind};
use crate::condition::{Times, Visit};
use crate::object::{one_of, unknown_key};
use crate::{Cell, object_only};

/// All keys that a constraint may have.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct Written {
    kind: Kind,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    zone: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lane: Option<Vec<Cell>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    agent: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first: Option<At>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    second: Option<At>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cells: Option<Vec<Cell>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cell: Option<Cell>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    most: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    steps: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    distance: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stay: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    by: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    from: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    to: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    quarter: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    weight: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    agents: Option<Vec<String>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    off: bool,
}

object_only!(Written);

/// An agent at a cell, as it is written.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct At {
    agent: String,
    cell: Cell,
}

object_only!(At);

impl From<At> for Visit {
    fn from(At { agent, cell }: At) -> Self {
        Self { agent, cell }
    }
}

impl From<Visit> for At {
    fn from(Visit { agent, cell }: Visit) -> Self {
        Self { agent, cell }
    }
}

/// The kinds of constraints, by their names in files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
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
pub(super) const fn kind_name(kind: &ConstraintKind) -> &'static str {
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

/// Takes a key that must be there.
fn need<T>(value: &mut Option<T>, key: &str) -> Result<T, String> {
    value.take().ok_or_else(|| format!("missing field `{key}`"))
}

impl Written {
    fn times(&mut self) -> Times {
        Times {
            from: self.from.take(),
            to: self.to.take(),
        }
    }

    /// Takes the keys of its kind.
    fn take(&mut self) -> Result<ConstraintKind, String> {
        Ok(match self.kind {
            Kind::Capacity => ConstraintKind::Capacity {
                zone: need(&mut self.zone, "zone")?,
                most: need(&mut self.most, "most")?,
                times: self.times(),
            },
            Kind::Closed => ConstraintKind::Closed {
                zone: need(&mut self.zone, "zone")?,
                times: self.times(),
            },
            Kind::OneWay => ConstraintKind::OneWay {
                lane: need(&mut self.lane, "lane")?,
            },
            Kind::Gap => ConstraintKind::Gap {
                steps: need(&mut self.steps, "steps")?,
            },
            Kind::Apart => ConstraintKind::Apart {
                distance: need(&mut self.distance, "distance")?,
                times: self.times(),
            },
            Kind::Sequence => ConstraintKind::Sequence {
                agent: need(&mut self.agent, "agent")?,
                cells: need(&mut self.cells, "cells")?,
            },
            Kind::Visit => ConstraintKind::Visit {
                cell: need(&mut self.cell, "cell")?,
                stay: self.stay.take().unwrap_or(0),
                times: self.times(),
            },
            Kind::Arrive => self.arrive()?,
            Kind::Depart => ConstraintKind::Depart {
                from: need(&mut self.from, "from")?,
            },
            Kind::Before => ConstraintKind::Before {
                first: need(&mut self.first, "first")?.into(),
                second: need(&mut self.second, "second")?.into(),
            },
            Kind::NoWaiting => ConstraintKind::NoWaiting {
                zone: need(&mut self.zone, "zone")?,
                most: self.most.take().unwrap_or(0),
            },
            Kind::Turns => ConstraintKind::Turns {
                quarter: need(&mut self.quarter, "quarter")?,
            },
            Kind::Avoid => ConstraintKind::Avoid {
                zone: need(&mut self.zone, "zone")?,
                weight: need(&mut self.weight, "weight")?,
            },
        })
    }

    fn arrive(&mut self) -> Result<ConstraintKind, String> {
        if self.weight.is_some() && self.from.is_none() {
            return Ok(ConstraintKind::Late {
                by: need(&mut self.by, "by")?,
                weight: need(&mut self.weight, "weight")?,
            });
        }
        let (from, to) = (self.from.take(), self.by.take());
        if from.is_none() && to.is_none() {
            return Err("missing field `by`".to_owned());
        }
        Ok(ConstraintKind::Arrive {
            times: Times { from, to },
        })
    }

    /// A key that its kind does not have.
    fn left_over(&self) -> Option<&'static str> {
        let names_agents = matches!(self.kind, Kind::Sequence | Kind::Before);
        let left = [
            ("zone", self.zone.is_some()),
            ("lane", self.lane.is_some()),
            ("agent", self.agent.is_some()),
            ("first", self.first.is_some()),
            ("second", self.second.is_some()),
            ("cells", self.cells.is_some()),
            ("cell", self.cell.is_some()),
            ("most", self.most.is_some()),
            ("steps", self.steps.is_some()),
            ("distance", self.distance.is_some()),
            ("stay", self.stay.is_some()),
            ("by", self.by.is_some()),
            ("from", self.from.is_some()),
            ("to", self.to.is_some()),
            ("quarter", self.quarter.is_some()),
            ("weight", self.weight.is_some()),
            ("agents", self.agents.is_some() && names_agents),
        ];
        left.iter().find(|(_, is)| *is).map(|&(key, _)| key)
    }
}

impl TryFrom<Written> for Constraint {
    type Error = String;

    fn try_from(mut written: Written) -> Result<Self, String> {
        let kind = written.take()?;
        if let Some(key) = written.left_over() {
            return Err(unknown_key(key, kind_name(&kind)));
        }
        Ok(Self {
            kind,
            agents: written.agents,
            name: written.name,
            off: written.off,
        })
    }
}

impl From<Constraint> for Written {
    fn from(constraint: Constraint) -> Self {
        let Constraint {
            kind,
            agents,
            name,
            off,
        } = constraint;
        let common = Self {
            agents,
            name,
            off,
            ..Self::default()
        };
        let of = |kind, times: Times| Self {
            kind,
            from: times.from,
            to: times.to,
            ..common.clone()
        };
        let always = Times::default();
        match kind {
            ConstraintKind::Capacity { zone, most, times } => Self {
                zone: Some(zone),
                most: Some(most),
                ..of(Kind::Capacity, times)
            },
            ConstraintKind::Closed { zone, times } => Self {
                zone: Some(zone),
                ..of(Kind::Closed, times)
            },
            ConstraintKind::OneWay { lane } => Self {
                lane: Some(lane),
                ..of(Kind::OneWay, always)
            },
            ConstraintKind::Gap { steps } => Self {
                steps: Some(steps),
                ..of(Kind::Gap, always)
            },
            ConstraintKind::Apart { distance, times } => Self {
                distance: Some(distance),
                ..of(Kind::Apart, times)
            },
            ConstraintKind::Sequence { agent, cells } => Self {
                agent: Some(agent),
                cells: Some(cells),
                ..of(Kind::Sequence, always)
            },
            ConstraintKind::Visit { cell, stay, times } => Self {
                cell: Some(cell),
                stay: (stay > 0).then_some(stay),
                ..of(Kind::Visit, times)
            },
            ConstraintKind::Arrive { times } => Self {
                by: times.to,
                from: times.from,
                ..of(Kind::Arrive, always)
            },
            ConstraintKind::Late { by, weight } => Self {
                by: Some(by),
                weight: Some(weight),
                ..of(Kind::Arrive, always)
            },
            ConstraintKind::Depart { from } => Self {
                from: Some(from),
                ..of(Kind::Depart, always)
            },
            ConstraintKind::Before { first, second } => Self {
                first: Some(first.into()),
                second: Some(second.into()),
                ..of(Kind::Before, always)
            },
            ConstraintKind::NoWaiting { zone, most } => Self {
                zone: Some(zone),
                most: (most > 0).then_some(most),
                ..of(Kind::NoWaiting, always)
            },
            ConstraintKind::Turns { quarter } => Self {
                quarter: Some(quarter),
                ..of(Kind::Turns, always)
            },
            ConstraintKind::Avoid { zone, weight } => Self {
                zone: Some(zone),
                weight: Some(weight),
                ..of(Kind::Avoid, always)
            },
        }
    }
}

impl Serialize for Constraint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Serialize::serialize(&Written::from(self.clone()), serializer)
    }
}

impl<'de> Deserialize<'de> for Constraint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written: Written = Deserialize::deserialize(deserializer)?;
        Self::try_from(written).map_err(de::Error::custom)
    }
}
