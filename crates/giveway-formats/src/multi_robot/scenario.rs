//! Reads `map` and `agents`, and makes a scene of them.

use std::collections::BTreeSet;

use crate::unknown_keys::UnknownKeys;
use crate::yaml::Yaml;
use crate::{OpenGoals, Remarks, matching};
use giveway_model::format::text::shorten;
use giveway_model::words::{Later, count};
use giveway_model::{Agent, Assumption, Cell, Fault, MAX_AGENTS, MAX_SIDE, Scene, tr, tr_later};

const CELL: Later = tr_later!("a cell [x, y]");

/// A cell, with its place in the file.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    x: i32,
    y: i32,
    /// A fault there, to be filled in.
    place: Fault,
}

/// The map of a scenario.
#[derive(Debug)]
pub(super) struct Map {
    width: u32,
    height: u32,
    obstacles: BTreeSet<(i32, i32)>,
}

/// An agent of a scenario.
#[derive(Debug)]
pub(super) struct WrittenRobot {
    name: String,
    start: Placed,
    /// One, or those that it may choose from.
    goals: Vec<Placed>,
    chooses: bool,
    place: Fault,
}

/// Reads two numbers.
fn cell(y: &mut Yaml<'_>) -> Result<Placed, Fault> {
    let mut numbers = [0; 2];
    let mut length = 0;
    let mut place = None;
    y.list(CELL, |y, i| {
        let number = y.number(tr_later!("a whole number"))?;
        match numbers.get_mut(i) {
            Some(slot) => *slot = number,
            None => return Err(y.fault(tr!("a third number"), CELL)),
        }
        length += 1;
        place.get_or_insert_with(|| y.fault("", ""));
        Ok(())
    })?;
    match (length, place) {
        (2, Some(mut place)) => {
            // The place of the pair, not of its first number.
            place.place = place.place.trim_end_matches("[0]").to_owned();
            let [x, y] = numbers;
            Ok(Placed { x, y, place })
        }
        _ => Err(y.fault(tr!("a list of {length}", length), CELL)),
    }
}

/// Reads `map`.
pub(super) fn map(y: &mut Yaml<'_>, unknown: &mut UnknownKeys) -> Result<Map, Fault> {
    let mut obstacles = BTreeSet::new();
    let mut size = None;
    y.object(
        tr_later!("an object with dimensions and obstacles"),
        |y, key| {
            match key {
                "dimensions" => size = Some(dimensions(&cell(y)?)?),
                "obstacles" => y.list(tr_later!("a list of cells"), |y, _| {
                    let Placed { x, y, .. } = cell(y)?;
                    obstacles.insert((x, y));
                    Ok(())
                })?,
                _ => y.skip_unknown(unknown, ("map", key))?,
            }
            Ok(())
        },
    )?;
    let (width, height) = size.ok_or_else(|| {
        y.fault(
            tr!("no key \"{key}\"", key = "dimensions"),
            tr!("one in map"),
        )
    })?;
    Ok(Map {
        width,
        height,
        obstacles,
    })
}

fn dimensions(cell: &Placed) -> Result<(u32, u32), Fault> {
    let side = |side: i32| {
        let side = u32::try_from(side).ok();
        side.filter(|side| (1..=MAX_SIDE).contains(side))
    };
    side(cell.x).zip(side(cell.y)).ok_or_else(|| {
        let found = tr!(
            "a map of {width} x {height} cells",
            width = cell.x,
            height = cell.y
        );
        let expected = tr!("1 to {most} rows and columns", most = MAX_SIDE);
        at(&cell.place, found, expected)
    })
}

fn at(place: &Fault, found: impl Into<String>, expected: impl Into<String>) -> Fault {
    Fault {
        found: found.into(),
        expected: expected.into(),
        ..place.clone()
    }
}

/// Reads `agents`.
pub(super) fn robots(
    y: &mut Yaml<'_>,
    unknown: &mut UnknownKeys,
) -> Result<Vec<WrittenRobot>, Fault> {
    let mut robots = Vec::new();
    y.list(tr_later!("a list of agents"), |y, i| {
        if i >= MAX_AGENTS {
            let expected = tr!("at most {most} robots", most = MAX_AGENTS);
            return Err(y.fault(tr!("one more agent"), expected));
        }
        let (mut name, mut start, mut goals, mut chooses) = (None, None, Vec::new(), false);
        y.object(
            tr_later!("an object with name, start and goal"),
            |y, key| {
                match key {
                    "name" => name = y.optional(tr_later!("a name"))?.map(String::from),
                    "start" => start = Some(cell(y)?),
                    "goal" => goals = vec![cell(y)?],
                    "potentialGoals" => {
                        chooses = true;
                        goals.clear();
                        y.list(tr_later!("a list of cells"), |y, _| {
                            goals.push(cell(y)?);
                            Ok(())
                        })?;
                    }
                    _ => y.skip_unknown(unknown, ("agents", key))?,
                }
                Ok(())
            },
        )?;
        let start = start.ok_or_else(|| {
            y.fault(
                tr!("no key \"{key}\"", key = "start"),
                tr!("one for each agent"),
            )
        })?;
        if goals.is_empty() {
            return Err(y.fault(tr!("no goal"), tr!("goal or potentialGoals for each agent")));
        }
        let name = name.filter(|name| !name.is_empty());
        robots.push(WrittenRobot {
            name: name.unwrap_or_else(|| format!("agent{i}")),
            start,
            goals,
            chooses,
            place: y.fault("", ""),
        });
        Ok(())
    })?;
    Ok(robots)
}

/// The scene, and what the file says beyond it.
pub(super) fn scene(map: &Map, robots: Vec<WrittenRobot>) -> Result<(Scene, Remarks), Fault> {
    let mut remarks = Remarks::default();
    let outside = map
        .obstacles
        .iter()
        .filter(|&&(x, y)| !map.has(x, y))
        .count();
    if outside > 0 {
        let obstacles = count(outside, "obstacle");
        let note = format!("Left out: {obstacles} outside the map.");
        remarks.notes.push(note);
    }
    let (mut names, mut starts) = (BTreeSet::new(), BTreeSet::new());
    let mut choices = Vec::with_capacity(robots.len());
    for robot in &robots {
        if !names.insert(&*robot.name) {
            let found = tr!("the name \"{name}\" again", name = shorten(&robot.name));
            return Err(at(&robot.place, found, tr!("a name of its own")));
        }
        let start = map.free(&robot.start)?;
        if !starts.insert(start) {
            let found = tr!("the start {start} again", start);
            return Err(at(&robot.start.place, found, tr!("a start of its own")));
        }
        let cells: Result<Vec<Cell>, Fault> =
            robot.goals.iter().map(|goal| map.free(goal)).collect();
        choices.push(cells?);
    }
    let chooses = robots.iter().any(|robot| robot.chooses);
    if chooses {
        remarks.open = OpenGoals::Choices(choices.clone());
        remarks.chosen.push(
            "Robots may choose from several goals. Here each goes to the first one that leaves a goal for the others."
                .to_owned(),
        );
    }
    let goals = matching::assign(&choices);
    let mut agents = Vec::with_capacity(robots.len());
    for (robot, goal) in robots.into_iter().zip(goals) {
        let Some(goal) = goal else {
            let place = robot.goals.first().map_or(&robot.place, |goal| &goal.place);
            let found = tr!("no goal left for {name}", name = shorten(&robot.name));
            return Err(at(place, found, tr!("a goal of its own for each robot")));
        };
        agents.push(Agent::new(robot.name, map.free(&robot.start)?, Some(goal)));
    }
    let scene = Scene {
        map: map.rows(),
        agents,
        assumptions: Vec::from_iter(chooses.then_some(Assumption::GoalsChosen)),
        ..Scene::default()
    };
    Ok((scene, remarks))
}

impl Map {
    fn has(&self, x: i32, y: i32) -> bool {
        let within = |number, side| u32::try_from(number).is_ok_and(|number| number < side);
        within(x, self.width) && within(y, self.height)
    }

    fn free(&self, cell: &Placed) -> Result<Cell, Fault> {
        let Placed { x, y, ref place } = *cell;
        if !self.has(x, y) {
            let expected = tr!(
                "a cell of the {width} x {height} map",
                width = self.width,
                height = self.height
            );
            return Err(at(place, format!("({x}, {y})"), expected));
        }
        if self.obstacles.contains(&(x, y)) {
            return Err(at(
                place,
                tr!("the obstacle {cell}", cell = format!("({x}, {y})")),
                tr!("a free cell"),
            ));
        }
        Ok(Cell::new(x.cast_unsigned(), y.cast_unsigned()))
    }

    fn rows(&self) -> Vec<String> {
        let is_obstacle = |x: u32, y: u32| {
            let cell = (x.cast_signed(), y.cast_signed());
            self.obstacles.contains(&cell)
        };
        let row = |y| {
            let cells = (0..self.width).map(|x| if is_obstacle(x, y) { '#' } else { '.' });
            cells.collect()
        };
        (0..self.height).map(row).collect()
    }
}
