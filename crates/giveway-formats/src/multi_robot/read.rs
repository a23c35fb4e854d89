//! The keys of a file, and what it holds.

use super::moving::Moving;
use super::scenario::{self, Map, WrittenRobot};
use super::{lines, moving, schedule};
use crate::limits::Steps;
use crate::unknown_keys::UnknownKeys;
use crate::yaml::{Kind, Yaml};
use crate::{Conventions, Held, WrittenAgent, WrittenPlan};
use giveway_model::compare::Claimed;
use giveway_model::{Fault, tr, tr_later};

/// The parts of a file.
#[derive(Default)]
struct Parts {
    map: Option<Map>,
    robots: Option<Vec<WrittenRobot>>,
    moving: Vec<Moving>,
    claimed: Claimed,
    schedule: Option<Vec<WrittenAgent>>,
    /// A remark on the schedule.
    note: Option<String>,
}

/// Reads a scenario, a schedule, or both.
pub(crate) fn read(text: &str) -> Result<Held, Fault> {
    match lines::read(text) {
        Some((agents, claimed, note)) => Ok(Held::Plan(plan(agents, claimed, note))),
        None => parsed(text),
    }
}

pub(super) fn plan(
    agents: Vec<WrittenAgent>,
    claimed: Claimed,
    note: Option<String>,
) -> WrittenPlan {
    WrittenPlan {
        claimed,
        notes: note.into_iter().collect(),
        ..WrittenPlan::new(agents, Conventions::OWN)
    }
}

/// The content of a text, by a parser of all of YAML.
pub(super) fn parsed(text: &str) -> Result<Held, Fault> {
    let mut yaml = Yaml::new(text);
    let mut parts = Parts::default();
    let mut unknown = UnknownKeys::default();
    let mut in_plan = UnknownKeys::default();
    let mut steps = Steps::default();
    if yaml.document()? {
        yaml.object(
            tr_later!("an object with map and agents, or with schedule"),
            |y, key| {
                match key {
                    "map" => parts.map = Some(scenario::map(y, &mut unknown)?),
                    "agents" => parts.robots = Some(scenario::robots(y, &mut unknown)?),
                    "dynamic_obstacles" => {
                        parts.moving = moving::obstacles(y, (&mut steps, &mut unknown))?;
                    }
                    "statistics" => {
                        schedule::statistics(y, (&mut parts.claimed, &mut in_plan))?;
                    }
                    "schedule" => {
                        let (agents, note) = schedule::agents(y, (&mut steps, &mut in_plan))?;
                        (parts.schedule, parts.note) = (Some(agents), note);
                    }
                    "cost" | "makespan" if y.kind()? == Kind::Scalar => {
                        schedule::claim(&mut parts.claimed, key, &y.text(tr_later!("a number"))?);
                    }
                    _ => y.skip_unknown(&mut unknown, ("", key))?,
                }
                Ok(())
            },
        )?;
    }
    let scene = match (parts.map, parts.robots) {
        (Some(map), Some(robots)) => Some(scenario::scene(&map, robots)?),
        (None, None) => None,
        (map, _) => {
            let missing = if map.is_some() { "agents" } else { "map" };
            let found = tr!("no key \"{key}\"", key = missing);
            return Err(Fault::at("", found, tr!("map and agents")).in_text(1, 1));
        }
    };
    let plan = parts.schedule.map(|agents| {
        let mut plan = plan(agents, parts.claimed, parts.note);
        plan.notes.extend(in_plan.sentence());
        plan
    });
    let Some((mut scene, mut remarks)) = scene else {
        let Some(mut plan) = plan else {
            let expected = tr!("map and agents, or schedule");
            return Err(Fault::at("", tr!("none of these keys"), expected).in_text(1, 1));
        };
        if !parts.moving.is_empty() {
            unknown.note("", "dynamic_obstacles");
        }
        plan.notes.extend(unknown.sentence());
        return Ok(Held::Plan(plan));
    };
    remarks
        .notes
        .extend(moving::close(&mut scene, parts.moving));
    scene.assumptions.extend(unknown.assumptions());
    Ok(match plan {
        None => Held::Scene(scene, remarks),
        Some(plan) => Held::Both(scene, remarks, plan),
    })
}
