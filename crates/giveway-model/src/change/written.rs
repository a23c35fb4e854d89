//! A change as it is written: one object whose keys depend on its kind.

mod keys;
mod whom;

use serde::{Deserialize, Deserializer, Serialize};

use keys::Keys;
use whom::Whom;

use super::{Change, ConstraintRef, What};
use crate::object::{one_of, unknown_key};
use crate::object_only;
use crate::{Cell, Constraint};

/// All keys that a change may have.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
pub(super) struct Written {
    at: u32,
    change: Kind,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    agent: Option<Whom>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cell: Option<Cell>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cells: Option<Vec<Cell>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    from: Option<Cell>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    to: Option<Cell>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    level: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    steps: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    constraint: Option<Constraint>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    index: Option<u32>,
}

object_only!(Written);

/// The kinds of change, by their names in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    AddAgent,
    RemoveAgent,
    AddObstacle,
    RemoveObstacle,
    MoveObstacle,
    SetSlow,
    SetNormal,
    AddCharger,
    RemoveCharger,
    SetGoal,
    AddWaypoint,
    DropWaypoint,
    SetBattery,
    DelayAgent,
    StopAgent,
    AddConstraint,
    RemoveConstraint,
}

const KINDS: [(&str, Kind); 17] = [
    ("add-agent", Kind::AddAgent),
    ("remove-agent", Kind::RemoveAgent),
    ("add-obstacle", Kind::AddObstacle),
    ("remove-obstacle", Kind::RemoveObstacle),
    ("move-obstacle", Kind::MoveObstacle),
    ("set-slow", Kind::SetSlow),
    ("set-normal", Kind::SetNormal),
    ("add-charger", Kind::AddCharger),
    ("remove-charger", Kind::RemoveCharger),
    ("set-goal", Kind::SetGoal),
    ("add-waypoint", Kind::AddWaypoint),
    ("drop-waypoint", Kind::DropWaypoint),
    ("set-battery", Kind::SetBattery),
    ("delay-agent", Kind::DelayAgent),
    ("stop-agent", Kind::StopAgent),
    ("add-constraint", Kind::AddConstraint),
    ("remove-constraint", Kind::RemoveConstraint),
];

impl<'de> Deserialize<'de> for Kind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        one_of(deserializer, &KINDS)
    }
}

impl TryFrom<Written> for Change {
    type Error = String;

    fn try_from(written: Written) -> Result<Self, String> {
        let at = written.at;
        let kind = written.change;
        let mut keys = Keys::of(written);
        let what = keys.what()?;
        match keys.left_over() {
            None => Ok(Self { at, what }),
            Some(key) => {
                let name = KINDS.iter().find(|(_, other)| *other == kind);
                let name = name.map_or("", |(name, _)| name);
                Err(unknown_key(key, name))
            }
        }
    }
}

impl From<Change> for Written {
    fn from(change: Change) -> Self {
        let empty = |kind| Self {
            at: change.at,
            change: kind,
            agent: None,
            cell: None,
            cells: None,
            from: None,
            to: None,
            level: None,
            steps: None,
            constraint: None,
            name: None,
            index: None,
        };
        let of = |kind, agent: String| Self {
            agent: Some(Whom::Name(agent)),
            ..empty(kind)
        };
        let at = |kind, cell| Self {
            cell: Some(cell),
            ..empty(kind)
        };
        let all = |kind, cells| Self {
            cells: Some(cells),
            ..empty(kind)
        };
        let of_at = |kind, agent, cell| Self {
            cell: Some(cell),
            ..of(kind, agent)
        };
        match change.what {
            What::AddAgent { agent } => Self {
                agent: Some(Whom::Agent(agent)),
                ..empty(Kind::AddAgent)
            },
            What::RemoveAgent { agent } => of(Kind::RemoveAgent, agent),
            What::AddObstacle { cell } => at(Kind::AddObstacle, cell),
            What::RemoveObstacle { cell } => at(Kind::RemoveObstacle, cell),
            What::MoveObstacle { from, to } => Self {
                from: Some(from),
                to: Some(to),
                ..empty(Kind::MoveObstacle)
            },
            What::SetSlow { cells } => all(Kind::SetSlow, cells),
            What::SetNormal { cells } => all(Kind::SetNormal, cells),
            What::AddCharger { cell } => at(Kind::AddCharger, cell),
            What::RemoveCharger { cell } => at(Kind::RemoveCharger, cell),
            What::SetGoal { agent, cell } => of_at(Kind::SetGoal, agent, cell),
            What::AddWaypoint { agent, cell } => of_at(Kind::AddWaypoint, agent, cell),
            What::DropWaypoint { agent, cell } => of_at(Kind::DropWaypoint, agent, cell),
            What::SetBattery { agent, level } => Self {
                level: Some(level),
                ..of(Kind::SetBattery, agent)
            },
            What::DelayAgent { agent, steps } => Self {
                steps: Some(steps),
                ..of(Kind::DelayAgent, agent)
            },
            What::StopAgent { agent } => of(Kind::StopAgent, agent),
            What::AddConstraint { constraint } => Self {
                constraint: Some(constraint),
                ..empty(Kind::AddConstraint)
            },
            What::RemoveConstraint { constraint } => match constraint {
                ConstraintRef::Name(name) => Self {
                    name: Some(name),
                    ..empty(Kind::RemoveConstraint)
                },
                ConstraintRef::Index(index) => Self {
                    index: Some(index),
                    ..empty(Kind::RemoveConstraint)
                },
            },
        }
    }
}
