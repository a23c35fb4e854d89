//! From a map and a scenario to a scene.

use crate::limits::refuse;
use std::collections::BTreeMap;

use super::{Route, Scenario};
use giveway_model::format::text::shorten;
use giveway_model::{Agent, Cell, Fault, Grid, Ground, Scene, tr, tr_later};

/// The scene of a scenario's first lines: agents `A1`, `A2` and so on, as many
/// as asked for, or all. They stay at their goals, and the objective is the
/// default one. Lines further down are not looked at.
///
/// # Errors
/// When the scenario has fewer lines than agents are asked for, when a line is
/// for a map of another name or size, when a start or goal is off the map or in
/// an obstacle, or when two agents share a start or a goal. The fault has the
/// line of the scenario.
///
/// ```
/// use giveway_formats::movingai::{read_map, read_scenario, to_scene};
/// let grid = read_map("type octile\nheight 1\nwidth 3\nmap\n...\n").unwrap();
/// let scenario = read_scenario("version 1\n0\ta.map\t3\t1\t0\t0\t2\t0\t2\n").unwrap();
/// let scene = to_scene("a", &grid, &scenario, Some(1)).unwrap();
/// assert_eq!(scene.agents[0].name, "A1");
/// assert!(to_scene("a", &grid, &scenario, Some(2)).is_err());
/// ```
pub fn to_scene(
    name: &str,
    grid: &Grid,
    scenario: &Scenario,
    agents: Option<usize>,
) -> Result<Scene, Fault> {
    let lines = scenario.routes.len();
    let wanted = agents.unwrap_or(lines);
    if wanted > lines {
        let found = tr!("a scenario for {lines} robots", lines);
        return refuse(found, tr!("one for {wanted}", wanted));
    }
    let mut starts = BTreeMap::new();
    let mut goals = BTreeMap::new();
    let mut scene = Scene {
        name: name.to_owned(),
        map: grid.rows(),
        ..Scene::default()
    };
    for (i, route) in scenario.routes.iter().take(wanted).enumerate() {
        check_map(scenario, route, grid)?;
        check_cell(grid, route, End::Start)?;
        check_cell(grid, route, End::Goal)?;
        check_shared(&mut starts, route, End::Start)?;
        check_shared(&mut goals, route, End::Goal)?;
        scene.agents.push(Agent::new(
            format!("A{}", i + 1),
            route.start,
            Some(route.goal),
        ));
    }
    Ok(scene)
}

fn check_map(scenario: &Scenario, route: &Route, grid: &Grid) -> Result<(), Fault> {
    let first = scenario.map_name().unwrap_or_default();
    if route.map != first {
        let found = tr!("the map \"{map}\"", map = shorten(&route.map));
        let expected = tr!("\"{first}\", as in the first line", first = shorten(first));
        return Err(fault(route, found, expected));
    }
    let (width, height) = (grid.width(), grid.height());
    if (route.width, route.height) != (width, height) {
        let found = tr!(
            "a map of {width} x {height} cells",
            width = route.width,
            height = route.height
        );
        let expected = tr!(
            "{width} x {height}, the size of the map given",
            width,
            height
        );
        return Err(fault(route, found, expected));
    }
    Ok(())
}

/// An end of a route.
#[derive(Clone, Copy)]
enum End {
    Start,
    Goal,
}

impl End {
    fn word(self) -> &'static str {
        match self {
            Self::Start => tr!("of a robot" => "start"),
            Self::Goal => tr!("of a robot" => "goal"),
        }
    }

    const fn cell(self, route: &Route) -> Cell {
        match self {
            Self::Start => route.start,
            Self::Goal => route.goal,
        }
    }
}

fn check_cell(grid: &Grid, route: &Route, end: End) -> Result<(), Fault> {
    let (what, cell) = (end.word(), end.cell(route));
    match grid.ground(cell) {
        None => Err(fault(
            route,
            tr!("the {what} {cell}", what, cell),
            tr!(
                "a cell of the {width} x {height} map",
                width = grid.width(),
                height = grid.height()
            ),
        )),
        Some(Ground::Obstacle) => {
            let found = tr!("the {what} {cell} in an obstacle", what, cell);
            Err(fault(route, found, tr_later!("a free cell")))
        }
        Some(_) => Ok(()),
    }
}

fn check_shared(seen: &mut BTreeMap<Cell, usize>, route: &Route, end: End) -> Result<(), Fault> {
    let (what, cell) = (end.word(), end.cell(route));
    match seen.insert(cell, route.line) {
        None => Ok(()),
        Some(line) => {
            let found = tr!(
                "the {what} {cell}, which is that of line {line} too",
                what,
                cell,
                line
            );
            Err(fault(route, found, tr!("a {what} of its own", what)))
        }
    }
}

fn fault(route: &Route, found: String, expected: impl Into<String>) -> Fault {
    Fault {
        line: Some(route.line),
        ..Fault::at("", found, expected)
    }
}
