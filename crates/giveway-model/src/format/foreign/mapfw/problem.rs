//! From a problem to a scene.

use std::collections::BTreeMap;

use super::fields::{Place, Problem};
use crate::words::count;
use crate::{Agent, Cell, Fault, MAX_SIDE, Scene, tr};

/// The scene; its faults have the place in the problem.
pub(super) fn scene(problem: &Problem, notes: &mut Vec<String>) -> Result<Scene, Fault> {
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
    let goals = by_colour(problem, &all_goals)?;
    if problem.starts.iter().any(|start| start.color.is_some()) {
        notes.push(
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
            name: format!("A{}", i + 1),
            start,
            goal,
            waypoints,
            battery: None,
        });
    }
    if again > 0 {
        let repeats = count(again, "waypoint");
        notes.push(format!("Left out: {repeats} that a robot has twice."));
    }
    Ok(Scene {
        map,
        agents,
        ..Scene::default()
    })
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
    for (place, told, is) in [
        ("width", problem.width, width),
        ("height", problem.height, height),
    ] {
        if let Some(told) = told.filter(|told| told.0 != is) {
            let expected = tr!("{is}, as in the grid", is);
            return Err(Fault::at(place, told.0.to_string(), expected));
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

/// The goal of each robot: its own, or where there are colours the first of its
/// colour that is left.
fn by_colour(problem: &Problem, goals: &[Cell]) -> Result<Vec<Cell>, Fault> {
    let mut left: BTreeMap<Option<i64>, std::collections::VecDeque<Cell>> = BTreeMap::new();
    for (place, cell) in problem.goals.iter().zip(goals) {
        left.entry(place.color).or_default().push_back(*cell);
    }
    let of_start = |(i, start): (usize, &Place)| {
        let goal = left
            .get_mut(&start.color)
            .and_then(std::collections::VecDeque::pop_front);
        goal.ok_or_else(|| {
            let found = match start.color {
                Some(color) => tr!("a start of the colour {color}, and no goal for it", color),
                None => tr!("a start of the colour none, and no goal for it").to_owned(),
            };
            Fault::at(
                format!("starts[{i}]"),
                found,
                tr!("as many goals of each colour as starts"),
            )
        })
    };
    problem.starts.iter().enumerate().map(of_start).collect()
}
