//! A constraint from its keys: those that its kind must have, may have, and has not.

use super::Written;
use super::kind::{Kind, kind_name};
use crate::condition::Times;
use crate::constraint::{Constraint, ConstraintKind};
use crate::object::unknown_key;

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
