//! Faults of zones and constraints: what `Instance::new` refuses.

mod zones;

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Constraint, ConstraintKind, MAX_CONSTRAINTS, MAX_NUMBER, MAX_ZONE_CELLS, MAX_ZONES, Zone, meant,
};
use crate::condition::Times;
use crate::format::text::shorten;
use crate::sorting::set;
use crate::{Cell, Fault, Grid, Ground, Scene, tr, tr_later};
use zones::{check_zone, off_map};

/// Finds the faults of a scene's zones and constraints.
pub(crate) fn find(scene: &Scene, grid: &Grid, faults: &mut Vec<Fault>) {
    if are_too_many(scene, faults) {
        return;
    }
    let mut names = BTreeMap::new();
    for (i, zone) in scene.zones.iter().enumerate() {
        let place = format!("zones[{i}]");
        check_name(&zone.name, (i, &place, "zones"), &mut names, faults);
        check_zone(zone, &place, grid, faults);
    }
    let agents = scene.agents.iter();
    let agents: BTreeSet<&str> = set(agents.map(|agent| agent.name.as_str()));
    let mut names = BTreeMap::new();
    for (i, constraint) in scene.constraints.iter().enumerate() {
        let place = format!("constraints[{i}]");
        if let Some(name) = &constraint.name {
            check_name(name, (i, &place, "constraints"), &mut names, faults);
        }
        let world = World {
            is_agent: &|name| agents.contains(name),
            zones: &scene.zones,
            grid,
        };
        check(constraint, &world, place, faults);
    }
}

/// What a constraint may name.
pub(crate) struct World<'a> {
    /// Whether an agent of a name is there.
    pub(crate) is_agent: &'a dyn Fn(&str) -> bool,
    /// The zones.
    pub(crate) zones: &'a [Zone],
    /// The map.
    pub(crate) grid: &'a Grid,
}

/// Finds the faults of one constraint, but for its name.
pub(crate) fn check(
    constraint: &Constraint,
    world: &World<'_>,
    place: String,
    faults: &mut Vec<Fault>,
) {
    let mut check = Check {
        world,
        place,
        faults,
    };
    check.agents(constraint);
    check.times(constraint);
    check.kind(constraint);
}

/// Notes numbers of things that are too large, and that nothing else was looked at.
fn are_too_many(scene: &Scene, faults: &mut Vec<Fault>) -> bool {
    let before = faults.len();
    let mut at_most = |place: &str, n: usize, most: usize| {
        if n > most {
            let most = tr!("at most {most}", most);
            faults.push(Fault::at(place, n.to_string(), most));
        }
    };
    at_most("zones", scene.zones.len(), MAX_ZONES);
    at_most("constraints", scene.constraints.len(), MAX_CONSTRAINTS);
    let size = |zone: &Zone| {
        let rect = zone.rect.map_or(0, |[x0, y0, x1, y1]| {
            let side = |from: u32, to: u32| to.saturating_sub(from) as usize + 1;
            side(x0, x1).saturating_mul(side(y0, y1))
        });
        rect.saturating_add(zone.listed.as_ref().map_or(0, Vec::len))
    };
    let sizes = scene.zones.iter().map(size);
    let cells = sizes.fold(0, usize::saturating_add);
    // A rectangle that leaves the map is told with its place, not as too many cells.
    let is_on_map = |zone: &Zone| zone.rect.is_none_or(|[_, _, x1, y1]| x1.max(y1) < 4096);
    if scene.zones.iter().all(is_on_map) {
        at_most("zones", cells, MAX_ZONE_CELLS);
    }
    faults.len() > before
}

/// A name that is not empty, and was not met before.
fn check_name<'s>(
    name: &'s str,
    (i, place, list): (usize, &str, &str),
    names: &mut BTreeMap<&'s str, usize>,
    faults: &mut Vec<Fault>,
) {
    let place = format!("{place}.name");
    if name.is_empty() {
        faults.push(Fault::at(
            place,
            tr_later!("an empty name"),
            tr_later!("a name"),
        ));
    } else if let Some(first) = names.insert(name, i) {
        faults.push(Fault::at(
            place,
            tr!(
                "\"{name}\", the name of {list}[{first}]",
                name = shorten(name),
                list,
                first
            ),
            tr_later!("a name of its own"),
        ));
    }
}

/// The faults of one constraint.
struct Check<'a> {
    world: &'a World<'a>,
    place: String,
    faults: &'a mut Vec<Fault>,
}

impl Check<'_> {
    fn fault(&mut self, key: &str, found: String, expected: impl Into<String>) {
        let place = format!("{}.{key}", self.place);
        self.faults.push(Fault::at(place, found, expected));
    }

    fn agents(&mut self, constraint: &Constraint) {
        let Some(names) = &constraint.agents else {
            return;
        };
        if names.is_empty() {
            let expected = tr_later!("at least one robot, or no agents for all of them");
            self.fault("agents", tr!("no robot").to_owned(), expected);
        }
        let mut seen = BTreeSet::new();
        for (k, name) in names.iter().enumerate() {
            let key = format!("agents[{k}]");
            self.agent(&key, name);
            if !seen.insert(name) {
                let found = tr!("\"{name}\" again", name = shorten(name));
                self.fault(&key, found, tr_later!("each robot once"));
            }
        }
    }

    fn agent(&mut self, key: &str, name: &str) {
        if !(self.world.is_agent)(name) {
            let found = tr!("the unknown robot \"{name}\"", name = shorten(name));
            self.fault(key, found, tr_later!("a robot of the scene"));
        }
    }

    fn times(&mut self, constraint: &Constraint) {
        let Some(Times { from, to }) = constraint.times() else {
            return;
        };
        let last = match constraint.kind {
            ConstraintKind::Arrive { .. } | ConstraintKind::Late { .. } => "by",
            _ => "to",
        };
        for (key, time) in [("from", from), (last, to)] {
            if let Some(time) = time {
                self.number(key, time, 0);
            }
        }
        if let (Some(from), Some(to)) = (from, to)
            && from > to
        {
            let expected = tr!("at most {most}", most = to);
            self.fault("from", from.to_string(), expected);
        }
    }

    fn number(&mut self, key: &str, number: u32, least: u32) {
        if number < least {
            let expected = tr!("at least {least}", least);
            self.fault(key, number.to_string(), expected);
        } else if number > MAX_NUMBER {
            let expected = tr!("at most {most}", most = MAX_NUMBER);
            self.fault(key, number.to_string(), expected);
        }
    }

    fn zone(&mut self, name: &str) {
        if !self.world.zones.iter().any(|zone| zone.name == name) {
            let found = tr!("the unknown zone \"{name}\"", name = shorten(name));
            self.fault("zone", found, tr_later!("a zone of the scene"));
        }
    }

    /// A cell where an agent can be; whether it is one.
    fn cell(&mut self, key: &str, cell: Cell) -> bool {
        let place = format!("{}.{key}", self.place);
        if let Some(fault) = off_map(cell, self.world.grid, &place) {
            self.faults.push(fault);
            return false;
        }
        let is_free = self.world.grid.ground(cell) != Some(Ground::Obstacle);
        if !is_free {
            let found = tr!("the obstacle {cell}", cell);
            self.fault(key, found, tr_later!("a free cell"));
        }
        is_free
    }

    fn kind(&mut self, constraint: &Constraint) {
        match &constraint.kind {
            ConstraintKind::Capacity { zone, most, .. }
            | ConstraintKind::NoWaiting { zone, most } => {
                self.zone(zone);
                self.number("most", *most, 0);
            }
            ConstraintKind::Closed { zone, .. } => self.zone(zone),
            ConstraintKind::OneWay { lane } => self.lane(lane),
            ConstraintKind::Gap { steps } => self.number("steps", *steps, 1),
            ConstraintKind::Apart { distance, .. } => self.number("distance", *distance, 2),
            ConstraintKind::Sequence { agent, cells } => {
                self.agent("agent", agent);
                if cells.is_empty() {
                    let expected = tr_later!("at least one cell");
                    self.fault("cells", tr!("no cell").to_owned(), expected);
                }
                for (k, &cell) in cells.iter().enumerate() {
                    self.cell(&format!("cells[{k}]"), cell);
                }
            }
            ConstraintKind::Visit { cell, stay, times } => {
                self.cell("cell", *cell);
                self.number("stay", *stay, 0);
                let window = meant(*times).last().saturating_sub(times.first());
                if times.first() <= times.last() && window < *stay {
                    let expected = tr!("at most {most}, the length of its times", most = window);
                    self.fault("stay", stay.to_string(), expected);
                }
            }
            // Their times are all that they have.
            ConstraintKind::Arrive { .. } | ConstraintKind::Depart { .. } => {}
            ConstraintKind::Late { weight, .. } => self.number("weight", *weight, 1),
            ConstraintKind::Before { first, second } => {
                for (key, visit) in [("first", first), ("second", second)] {
                    self.agent(&format!("{key}.agent"), &visit.agent);
                    self.cell(&format!("{key}.cell"), visit.cell);
                }
            }
            ConstraintKind::Turns { quarter } => self.number("quarter", *quarter, 1),
            ConstraintKind::Avoid { zone, weight } => {
                self.zone(zone);
                self.number("weight", *weight, 1);
            }
        }
    }

    fn lane(&mut self, lane: &[Cell]) {
        if lane.len() < 2 {
            let found = tr!("{n} cell" | "{n} cells" % lane.len());
            self.fault("lane", found, tr_later!("two or more cells"));
        }
        let mut seen = BTreeSet::new();
        let mut before: Option<Cell> = None;
        for (k, &cell) in lane.iter().enumerate() {
            let key = format!("lane[{k}]");
            if !self.cell(&key, cell) {
                return;
            }
            if !seen.insert(cell) {
                let found = tr!("{cell} again", cell);
                self.fault(&key, found, tr_later!("each cell once"));
            } else if let Some(before) = before
                && !before.touches(cell)
            {
                let found = cell.to_string();
                self.fault(&key, found, tr!("a neighbour of {before}", before));
            }
            before = Some(cell);
        }
    }
}
