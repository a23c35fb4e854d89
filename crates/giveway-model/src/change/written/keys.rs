//! The keys of a change by its kind: those that it must have, and no others.

use super::whom::Whom;
use super::{Kind, Written};
use crate::change::{ConstraintRef, What};
use crate::{Agent, Cell, tr};

/// Takes the keys of one kind; what is left over belongs to no such change.
pub(super) struct Keys(Written);

impl Keys {
    pub(super) const fn of(written: Written) -> Self {
        Self(written)
    }

    fn name(&mut self) -> Result<String, String> {
        match self.0.agent.take() {
            Some(Whom::Name(name)) => Ok(name),
            Some(Whom::Agent(_)) => Err(instead(tr!("a robot"), tr!("the name of one"))),
            None => Err(missing("agent")),
        }
    }

    fn agent(&mut self) -> Result<Agent, String> {
        match self.0.agent.take() {
            Some(Whom::Agent(agent)) => Ok(agent),
            Some(Whom::Name(_)) => Err(instead(
                tr!("the name of a robot"),
                tr!("the robot as an object"),
            )),
            None => Err(missing("agent")),
        }
    }

    fn cell(&mut self) -> Result<Cell, String> {
        self.0.cell.take().ok_or_else(|| missing("cell"))
    }

    fn cells(&mut self) -> Result<Vec<Cell>, String> {
        self.0.cells.take().ok_or_else(|| missing("cells"))
    }

    pub(super) fn what(&mut self) -> Result<What, String> {
        Ok(match self.0.change {
            Kind::AddAgent => What::AddAgent {
                agent: self.agent()?,
            },
            Kind::RemoveAgent => What::RemoveAgent {
                agent: self.name()?,
            },
            Kind::AddObstacle => What::AddObstacle { cell: self.cell()? },
            Kind::RemoveObstacle => What::RemoveObstacle { cell: self.cell()? },
            Kind::MoveObstacle => What::MoveObstacle {
                from: self.0.from.take().ok_or_else(|| missing("from"))?,
                to: self.0.to.take().ok_or_else(|| missing("to"))?,
            },
            Kind::SetSlow => What::SetSlow {
                cells: self.cells()?,
            },
            Kind::SetNormal => What::SetNormal {
                cells: self.cells()?,
            },
            Kind::AddCharger => What::AddCharger { cell: self.cell()? },
            Kind::RemoveCharger => What::RemoveCharger { cell: self.cell()? },
            Kind::SetGoal => What::SetGoal {
                agent: self.name()?,
                cell: self.cell()?,
            },
            Kind::AddWaypoint => What::AddWaypoint {
                agent: self.name()?,
                cell: self.cell()?,
            },
            Kind::DropWaypoint => What::DropWaypoint {
                agent: self.name()?,
                cell: self.cell()?,
            },
            Kind::SetBattery => What::SetBattery {
                agent: self.name()?,
                level: self.0.level.take().ok_or_else(|| missing("level"))?,
            },
            Kind::DelayAgent => What::DelayAgent {
                agent: self.name()?,
                steps: self.0.steps.take().ok_or_else(|| missing("steps"))?,
            },
            Kind::StopAgent => What::StopAgent {
                agent: self.name()?,
            },
            Kind::AddConstraint => What::AddConstraint {
                constraint: self
                    .0
                    .constraint
                    .take()
                    .ok_or_else(|| missing("constraint"))?,
            },
            Kind::RemoveConstraint => What::RemoveConstraint {
                constraint: match (self.0.name.take(), self.0.index) {
                    (Some(name), _) => ConstraintRef::Name(name),
                    (None, Some(index)) => {
                        self.0.index = None;
                        ConstraintRef::Index(index)
                    }
                    (None, None) => return Err(missing("name")),
                },
            },
        })
    }

    pub(super) fn left_over(&self) -> Option<&'static str> {
        let left = [
            ("agent", self.0.agent.is_some()),
            ("cell", self.0.cell.is_some()),
            ("cells", self.0.cells.is_some()),
            ("from", self.0.from.is_some()),
            ("to", self.0.to.is_some()),
            ("level", self.0.level.is_some()),
            ("steps", self.0.steps.is_some()),
            ("constraint", self.0.constraint.is_some()),
            ("name", self.0.name.is_some()),
            ("index", self.0.index.is_some()),
        ];
        left.iter().find(|(_, is)| *is).map(|&(key, _)| key)
    }
}

/// In the JSON library's own words, which are made a sentence elsewhere.
fn missing(key: &str) -> String {
    format!("missing field `{key}`")
}

fn instead(found: &str, expected: &str) -> String {
    format!("found {found}, expected {expected}")
}
