//! What a learner has changed of a scene, in words: `You blocked (4, 0).`

use giveway_model::words::and;
use giveway_model::{Cell, Grid, Ground, Scene, tr};

use super::spans::{cell, plain, robot, text};
use crate::lesson::Text;

/// The most changes that are told one by one.
const FEW: usize = 3;

/// What was changed; nothing where nothing was.
pub fn made(start: &Scene, scene: &Scene) -> Option<Text> {
    let mut changes = cells(start, scene);
    changes.extend(robots(start, scene));
    let sentence = match changes.len() {
        0 => return None,
        1..=FEW => tr!("You {changes}.", changes = and(&changes)),
        many => tr!("You made {n} change." | "You made {n} changes." % many),
    };
    Some(text(&sentence))
}

fn cells(start: &Scene, scene: &Scene) -> Vec<String> {
    let grids = (Grid::from_rows(&start.map), Grid::from_rows(&scene.map));
    let (Ok(before), Ok(now)) = grids else {
        return Vec::new();
    };
    let all = (0..now.height()).flat_map(|y| (0..now.width()).map(move |x| Cell::new(x, y)));
    let changed = all.filter_map(|at| {
        let (was, is) = (before.ground(at)?, now.ground(at)?);
        (was != is).then(|| ground(was, is, at))
    });
    changed.collect()
}

/// What was done to one cell.
fn ground(was: Ground, is: Ground, at: Cell) -> String {
    let cell = cell(at);
    match (was, is) {
        (_, Ground::Obstacle) => tr!("You ..." => "blocked {cell}", cell),
        (Ground::Obstacle, Ground::Free) => tr!("You ..." => "freed {cell}", cell),
        _ if is.is_charger() && !was.is_charger() => {
            tr!("You ..." => "put a charger on {cell}", cell)
        }
        _ if was.is_charger() && !is.is_charger() => {
            tr!("You ..." => "took the charger from {cell}", cell)
        }
        _ if is.is_slow() => tr!("You ..." => "made {cell} slow", cell),
        _ => tr!("You ..." => "made {cell} normal", cell),
    }
}

fn robots(start: &Scene, scene: &Scene) -> Vec<String> {
    let find = |scene: &'_ Scene, name: &str| {
        let mut agents = scene.agents.iter();
        agents.find(|agent| agent.name == name).cloned()
    };
    let mut changes = Vec::new();
    for agent in &scene.agents {
        let robot = robot(&agent.name);
        changes.push(match find(start, &agent.name) {
            None => tr!("You ..." => "added {robot}", robot),
            Some(before) if before.start != agent.start => {
                tr!("You ..." => "moved {robot} to {cell}", robot, cell = cell(agent.start))
            }
            Some(before) if before.goal != agent.goal => match agent.goal {
                Some(goal) => {
                    tr!("You ..." => "gave {robot} another flag, {cell}", robot, cell = cell(goal))
                }
                None => tr!("You ..." => "took the flag of {robot} away", robot),
            },
            Some(before) if before.waypoints != agent.waypoints => {
                tr!("You ..." => "changed the waypoints of {robot}", robot)
            }
            Some(_) => continue,
        });
    }
    for agent in &start.agents {
        if find(scene, &agent.name).is_none() {
            let robot = plain(&agent.name);
            changes.push(tr!("You ..." => "took {robot} away", robot));
        }
    }
    changes
}
