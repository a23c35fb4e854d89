//! A constraint as its keys.

use super::Written;
use super::kind::Kind;
use crate::condition::Times;
use crate::constraint::{Constraint, ConstraintKind};

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
