//! From a map and a scenario to a scene.

use std::collections::BTreeMap;

use super::{Route, Scenario};
use crate::format::text::shorten;
use crate::{Agent, Cell, Fault, Grid, Ground, Scene};

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
/// use giveway_model::format::movingai::{read_map, read_scenario, to_scene};
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
        let found = format!("a scenario for {lines} robots");
        return Err(Fault::at("", found, format!("one for {wanted}")));
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
        check_cell(grid, route, "start", route.start)?;
        check_cell(grid, route, "goal", route.goal)?;
        check_shared(&mut starts, route, "start", route.start)?;
        check_shared(&mut goals, route, "goal", route.goal)?;
        scene.agents.push(Agent {
            name: format!("A{}", i + 1),
            start: route.start,
            goal: route.goal,
            waypoints: Vec::new(),
            battery: None,
        });
    }
    Ok(scene)
}

fn check_map(scenario: &Scenario, route: &Route, grid: &Grid) -> Result<(), Fault> {
    let first = scenario.map_name().unwrap_or_default();
    if route.map != first {
        let found = format!("the map \"{}\"", shorten(&route.map));
        let expected = format!("\"{}\", as in the first line", shorten(first));
        return Err(fault(route, found, expected));
    }
    let (width, height) = (grid.width(), grid.height());
    if (route.width, route.height) != (width, height) {
        let found = format!("a map of {} x {} cells", route.width, route.height);
        let expected = format!("{width} x {height}, the size of the map given");
        return Err(fault(route, found, expected));
    }
    Ok(())
}

fn check_cell(grid: &Grid, route: &Route, what: &str, cell: Cell) -> Result<(), Fault> {
    match grid.ground(cell) {
        None => Err(fault(
            route,
            format!("the {what} {cell}"),
            format!("a cell of the {} x {} map", grid.width(), grid.height()),
        )),
        Some(Ground::Obstacle) => {
            let found = format!("the {what} {cell} in an obstacle");
            Err(fault(route, found, "a free cell"))
        }
        Some(_) => Ok(()),
    }
}

fn check_shared(
    seen: &mut BTreeMap<Cell, usize>,
    route: &Route,
    what: &str,
    cell: Cell,
) -> Result<(), Fault> {
    match seen.insert(cell, route.line) {
        None => Ok(()),
        Some(line) => {
            let found = format!("the {what} {cell}, which is that of line {line} too");
            Err(fault(route, found, format!("a {what} of its own")))
        }
    }
}

fn fault(route: &Route, found: String, expected: impl Into<String>) -> Fault {
    Fault {
        line: Some(route.line),
        ..Fault::at("", found, expected)
    }
}
