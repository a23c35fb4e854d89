//! The keys of a file, and what it holds.

use super::scenario::{self, Map, WrittenRobot};
use super::{lines, schedule};
use crate::format::foreign::limits::Steps;
use crate::format::foreign::yaml::Yaml;
use crate::format::foreign::{Claimed, Conventions, Held, WrittenAgent, WrittenPlan};
use crate::{Fault, tr, tr_later};

/// What was read of a file.
#[derive(Default)]
struct Parts {
    map: Option<Map>,
    robots: Option<Vec<WrittenRobot>>,
    claimed: Claimed,
    schedule: Option<Vec<WrittenAgent>>,
}

/// Reads a scenario, a schedule, or both.
pub(in crate::format::foreign) fn read(text: &str) -> Result<Held, Vec<Fault>> {
    held(text).map_err(|fault| vec![fault])
}

/// What a text holds.
fn held(text: &str) -> Result<Held, Fault> {
    match lines::read(text) {
        Some((agents, claimed)) => Ok(Held::Plan(plan(agents, claimed))),
        None => parsed(text),
    }
}

pub(super) fn plan(agents: Vec<WrittenAgent>, claimed: Claimed) -> WrittenPlan {
    WrittenPlan {
        map: None,
        agents,
        claimed,
        documented: Conventions::OWN,
        notes: Vec::new(),
    }
}

/// What a text holds, by a parser of all of YAML.
pub(super) fn parsed(text: &str) -> Result<Held, Fault> {
    let mut yaml = Yaml::new(text);
    let mut parts = Parts::default();
    let mut steps = Steps::default();
    if yaml.document()? {
        yaml.object(
            tr_later!("an object with map and agents, or with schedule"),
            |y, key| {
                match key {
                    "map" => parts.map = Some(scenario::map(y)?),
                    "agents" => parts.robots = Some(scenario::robots(y)?),
                    "statistics" => parts.claimed = schedule::statistics(y)?,
                    "schedule" => parts.schedule = Some(schedule::agents(y, &mut steps)?),
                    _ => y.skip()?,
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
    let plan = parts.schedule.map(|agents| plan(agents, parts.claimed));
    match (scene, plan) {
        (Some((scene, notes)), None) => Ok(Held::Scene(scene, notes)),
        (None, Some(plan)) => Ok(Held::Plan(plan)),
        (Some((scene, notes)), Some(plan)) => Ok(Held::Both(scene, WrittenPlan { notes, ..plan })),
        (None, None) => {
            let expected = tr!("map and agents, or schedule");
            Err(Fault::at("", tr!("none of these keys"), expected).in_text(1, 1))
        }
    }
}
