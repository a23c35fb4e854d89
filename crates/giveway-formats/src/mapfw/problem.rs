//! From a problem to a scene.

use std::collections::BTreeMap;

use super::fields::{Place, Problem};
use crate::unknown_keys::UnknownKeys;
use crate::{OpenGoals, Remarks, matching};
use giveway_model::words::count;
use giveway_model::{Agent, Assumption, Cell, Fault, MAX_SIDE, Scene, tr};

/// The keys that are read.
const KEYS: [&str; 7] = [
    "grid",
    "width",
    "height",
    "starts",
    "goals",
    "waypoints",
    "solution",
];

/// The keys that say of the whole what its benchmark is, and change nothing.
pub(super) const ABOUT: [&str; 4] = ["benchmark", "batch_pos", "progressive", "timeout"];

/// The scene, and what its text says beyond it; faults have the place in the problem.
pub(super) fn scene(text: &str, problem: &Problem) -> Result<(Scene, Remarks), Fault> {
    let mut remarks = Remarks::default();
    let mut assumptions = Vec::new();
    let map = map(problem)?;
    let robots = problem.starts.len();
    let same = |place: &str, found: usize| {
        if found == robots {
            return Ok(());
        }
        let expected = tr!("{robots}, one for each start", robots);
        Err(Fault::at(place, tr!("{found} entries", found), expected))
    };
    same("goals", problem.goals.len())?;
    if !problem.waypoints.is_empty() {
        same("waypoints", problem.waypoints.len())?;
    }
    let starts = cells(problem, "starts", &problem.starts)?;
    let all_goals = cells(problem, "goals", &problem.goals)?;
    let has_color = |place: &Place| place.color.is_some();
    let is_chosen = problem.starts.iter().any(has_color);
    let goals = if is_chosen || problem.goals.iter().any(has_color) {
        let choices = of_colours(problem, &all_goals);
        let goals = by_colour(problem, &choices)?;
        remarks.open = OpenGoals::Choices(choices);
        goals
    } else {
        all_goals
    };
    if is_chosen {
        assumptions.push(Assumption::GoalsChosen);
        remarks.chosen.push(
            "A robot may go to any goal of its colour. Here each goes to the first of its colour that is left."
                .to_owned(),
        );
    }
    let mut again = 0;
    let mut agents = Vec::with_capacity(robots);
    for (i, (start, goal)) in starts.into_iter().zip(goals).enumerate() {
        let mut waypoints = Vec::new();
        for (k, place) in problem.waypoints.get(i).into_iter().flatten().enumerate() {
            let cell = cell(problem, &format!("waypoints[{i}][{k}]"), *place)?;
            if waypoints.contains(&cell) {
                again += 1;
            } else {
                waypoints.push(cell);
            }
        }
        agents.push(Agent {
            waypoints,
            ..Agent::new(format!("A{}", i + 1), start, Some(goal))
        });
    }
    if again > 0 {
        let repeats = count(again, "waypoint");
        remarks
            .notes
            .push(format!("Left out: {repeats} that a robot has twice."));
    }
    let is_known = |key: &str| KEYS.contains(&key) || ABOUT.contains(&key);
    assumptions.extend(UnknownKeys::in_object(text, is_known).assumptions());
    let scene = Scene {
        map,
        agents,
        assumptions,
        ..Scene::default()
    };
    Ok((scene, remarks))
}

/// The goals of each robot's colour.
fn of_colours(problem: &Problem, goals: &[Cell]) -> Vec<Vec<Cell>> {
    let of = |start: &Place| {
        let all = problem.goals.iter().zip(goals);
        let own = all.filter(|(goal, _)| goal.color == start.color);
        own.map(|(_, cell)| *cell).collect()
    };
    problem.starts.iter().map(of).collect()
}

fn map(problem: &Problem) -> Result<Vec<String>, Fault> {
    let grid = &problem.grid;
    let height = grid.len() as u64;
    let width = grid.first().map_or(0, Vec::len) as u64;
    let most = u64::from(MAX_SIDE);
    if !(1..=most).contains(&width) || !(1..=most).contains(&height) {
        let found = tr!("a grid of {width} x {height} cells", width, height);
        return Err(Fault::at(
            "grid",
            found,
            tr!("1 to {most} rows and columns", most),
        ));
    }
    for (place, stated, is) in [
        ("width", problem.width, width),
        ("height", problem.height, height),
    ] {
        if let Some(stated) = stated.filter(|stated| stated.0 != is) {
            let expected = tr!("{is}, as in the grid", is);
            return Err(Fault::at(place, stated.0.to_string(), expected));
        }
    }
    let mut rows = Vec::with_capacity(grid.len());
    for (y, row) in grid.iter().enumerate() {
        if row.len() as u64 != width {
            let expected = tr!("{width}, as in the first row", width);
            let found = tr!("a row of {n} cell" | "a row of {n} cells" % row.len());
            return Err(Fault::at(format!("grid[{y}]"), found, expected));
        }
        let mut text = String::with_capacity(row.len());
        for (x, cell) in row.iter().enumerate() {
            text.push(match cell {
                0 => '.',
                1 => '#',
                other => {
                    let place = format!("grid[{y}][{x}]");
                    return Err(Fault::at(place, other.to_string(), tr!("0 or 1")));
                }
            });
        }
        rows.push(text);
    }
    Ok(rows)
}

/// The cells of a list, all different.
fn cells(problem: &Problem, key: &str, places: &[Place]) -> Result<Vec<Cell>, Fault> {
    let mut seen = BTreeMap::new();
    let mut cells = Vec::with_capacity(places.len());
    for (i, place) in places.iter().enumerate() {
        let way = format!("{key}[{i}]");
        let cell = cell(problem, &way, *place)?;
        if let Some(other) = seen.insert(cell, i) {
            let found = tr!("{cell}, which {key}[{other}] is, too", cell, key, other);
            return Err(Fault::at(way, found, tr!("a cell of its own")));
        }
        cells.push(cell);
    }
    Ok(cells)
}

fn cell(problem: &Problem, way: &str, place: Place) -> Result<Cell, Fault> {
    let Place { x, y, .. } = place;
    let at = |x: i32, y: i32| {
        let row = problem.grid.get(usize::try_from(y).ok()?)?;
        row.get(usize::try_from(x).ok()?).copied()
    };
    match at(x, y) {
        Some(0) => Ok(Cell::new(x.cast_unsigned(), y.cast_unsigned())),
        Some(_) => Err(Fault::at(
            way,
            tr!("the wall ({x}, {y})", x, y),
            tr!("a free cell"),
        )),
        None => Err(Fault::at(
            way,
            format!("({x}, {y})"),
            tr!("a cell of the grid"),
        )),
    }
}

/// The goal of each robot: the first of its colour that is left.
fn by_colour(problem: &Problem, choices: &[Vec<Cell>]) -> Result<Vec<Cell>, Fault> {
    let goals = matching::assign(choices).into_iter().enumerate();
    let of_start = |(i, goal): (usize, Option<Cell>)| {
        goal.ok_or_else(|| {
            let found = match problem.starts.get(i).and_then(|start| start.color) {
                Some(color) => tr!("a start of the colour {color}, and no goal for it", color),
                None => tr!("a start of the colour none, and no goal for it").to_owned(),
            };
            let expected = tr!("as many goals of each colour as starts");
            Fault::at(format!("starts[{i}]"), found, expected)
        })
    };
    goals.map(of_start).collect()
}
