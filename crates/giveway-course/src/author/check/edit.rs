//! The single edits of a scene that the tools of a step allow.

use giveway_model::{Agent, Cell, Grid, Ground, Instance, Scene};

use crate::lesson::{Step, Tool};

/// A single edit. Robots are named by their index.
#[derive(Clone, Copy, Debug)]
pub(super) enum Edit {
    /// A cell gets this ground.
    Ground(Cell, Ground),
    /// A robot starts here.
    Start(usize, Cell),
    /// A robot has its goal here.
    Goal(usize, Cell),
    /// A robot has one more waypoint.
    Waypoint(usize, Cell),
    /// A robot is removed.
    Gone(usize),
    /// A new robot with its start and its goal.
    New(Cell, Cell),
}

/// The edits that the tools of a step allow, at most so many of a kind.
pub(super) fn edits(step: &Step, scene: &Scene, most: usize) -> Vec<Edit> {
    let Ok(grid) = Grid::from_rows(&scene.map) else {
        return Vec::new();
    };
    let all = (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| Cell::new(x, y)));
    let all = all.filter_map(|cell| Some((cell, grid.ground(cell)?)));
    let is_allowed = |cell: &Cell| step.cells.as_ref().is_none_or(|cells| cells.contains(cell));
    let cells: Vec<(Cell, Ground)> = all.filter(|(cell, _)| is_allowed(cell)).collect();
    let free = cells.iter().filter(|(_, ground)| ground.is_vertex());
    let free: Vec<Cell> = free.map(|(cell, _)| *cell).collect();
    let robots = 0..scene.agents.len();
    let ground = |tool: Tool| {
        let made = cells.iter().filter_map(move |(cell, was)| {
            let is = made(tool, *was)?;
            Some(Edit::Ground(*cell, is))
        });
        made.take(most)
    };
    let each = |edit: fn(usize, Cell) -> Edit| {
        let (robots, free) = (robots.clone(), &free);
        let each = robots.flat_map(move |robot| free.iter().map(move |cell| edit(robot, *cell)));
        each.take(most)
    };
    let mut edits = Vec::new();
    for tool in &step.tools {
        match tool {
            Tool::Obstacle | Tool::Charger | Tool::SlowZone => edits.extend(ground(*tool)),
            Tool::Erase => {
                edits.extend(ground(*tool));
                edits.extend(robots.clone().map(Edit::Gone));
            }
            Tool::Move => {
                edits.extend(each(Edit::Goal));
                edits.extend(each(Edit::Start));
            }
            Tool::Goal => edits.extend(each(Edit::Goal)),
            Tool::Waypoint => edits.extend(each(Edit::Waypoint)),
            Tool::Robot => {
                let pairs = free.iter().flat_map(|start| {
                    let goals = free.iter().filter(move |goal| *goal != start);
                    goals.map(|goal| Edit::New(*start, *goal))
                });
                edits.extend(pairs.take(most));
            }
        }
    }
    edits
}

/// What a tool makes of a cell, where that is something else.
fn made(tool: Tool, was: Ground) -> Option<Ground> {
    let is = match tool {
        Tool::Obstacle if was == Ground::Obstacle => Ground::Free,
        Tool::Obstacle => Ground::Obstacle,
        Tool::Charger if was == Ground::Slow => Ground::SlowCharger,
        Tool::Charger => Ground::Charger,
        Tool::SlowZone if was == Ground::Charger => Ground::SlowCharger,
        Tool::SlowZone => Ground::Slow,
        Tool::Erase => Ground::Free,
        Tool::Move | Tool::Robot | Tool::Goal | Tool::Waypoint => return None,
    };
    (is != was).then_some(is)
}

/// The scene after an edit, where it is valid.
pub(super) fn applied(scene: &Scene, edit: &Edit) -> Option<Scene> {
    let mut scene = scene.clone();
    let agents = &mut scene.agents;
    match *edit {
        Edit::Ground(cell, ground) => {
            let row = scene.map.get_mut(cell.y as usize)?;
            let letters = row.chars().enumerate();
            let letters = letters.map(|(x, letter)| {
                let is_here = x == cell.x as usize;
                if is_here { ground.to_char() } else { letter }
            });
            *row = letters.collect();
        }
        Edit::Start(robot, cell) => agents.get_mut(robot)?.start = cell,
        Edit::Goal(robot, cell) => agents.get_mut(robot)?.goal = Some(cell),
        Edit::Waypoint(robot, cell) => agents.get_mut(robot)?.waypoints.push(cell),
        Edit::Gone(robot) => drop(agents.remove(robot)),
        Edit::New(start, goal) => {
            let mut names = (0..=agents.len()).map(|index| format!("A{}", index + 1));
            let is_new = |name: &String| agents.iter().all(|agent| agent.name != *name);
            let name = names.find(is_new)?;
            agents.push(Agent {
                name,
                start,
                goal: Some(goal),
                waypoints: Vec::new(),
                battery: None,
                heading: None,
            });
        }
    }
    Instance::new(scene.clone()).is_ok().then_some(scene)
}
