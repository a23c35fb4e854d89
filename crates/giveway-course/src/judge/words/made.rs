//! What a learner has changed of a scene, in words: `You blocked (4, 0).`

use giveway_model::{Cell, Grid, Ground, Scene};

use super::spans::{cell, robot, text};
use crate::lesson::{Span, Text};

/// The most changes that are told one by one.
const FEW: usize = 3;

/// What was changed; nothing where nothing was.
pub fn made(start: &Scene, scene: &Scene) -> Option<Text> {
    let mut changes = cells(start, scene);
    changes.extend(robots(start, scene));
    if changes.is_empty() {
        return None;
    }
    if changes.len() > FEW {
        let words = format!("You made {} changes.", changes.len());
        return Some(Text::of(vec![text(&words)]));
    }
    let last = changes.len() - 1;
    let mut spans = vec![text("You ")];
    for (index, change) in changes.into_iter().enumerate() {
        match index {
            0 => {}
            _ if index == last => spans.push(text(" and ")),
            _ => spans.push(text(", ")),
        }
        spans.extend(change);
    }
    spans.push(text("."));
    Some(Text::of(spans))
}

fn cells(start: &Scene, scene: &Scene) -> Vec<Vec<Span>> {
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
fn ground(was: Ground, is: Ground, at: Cell) -> Vec<Span> {
    let (before, after) = match (was, is) {
        (_, Ground::Obstacle) => ("blocked ", ""),
        (Ground::Obstacle, Ground::Free) => ("freed ", ""),
        _ if is.is_charger() && !was.is_charger() => ("put a charger on ", ""),
        _ if was.is_charger() && !is.is_charger() => ("took the charger from ", ""),
        _ if is.is_slow() => ("made ", " slow"),
        _ => ("made ", " normal"),
    };
    vec![text(before), cell(at), text(after)]
}

fn robots(start: &Scene, scene: &Scene) -> Vec<Vec<Span>> {
    let find = |scene: &'_ Scene, name: &str| {
        let mut agents = scene.agents.iter();
        agents.find(|agent| agent.name == name).cloned()
    };
    let mut changes = Vec::new();
    for agent in &scene.agents {
        let name = robot(&agent.name);
        match find(start, &agent.name) {
            None => changes.push(vec![text("added "), name]),
            Some(before) if before.start != agent.start => {
                changes.push(vec![text("moved "), name, text(" to "), cell(agent.start)]);
            }
            Some(before) if before.goal != agent.goal => {
                let to = text(" another flag, ");
                changes.push(vec![text("gave "), name, to, cell(agent.goal)]);
            }
            Some(before) if before.waypoints != agent.waypoints => {
                changes.push(vec![text("changed the waypoints of "), name]);
            }
            Some(_) => {}
        }
    }
    for agent in &start.agents {
        if find(scene, &agent.name).is_none() {
            changes.push(vec![text("took "), text(&agent.name), text(" away")]);
        }
    }
    changes
}
