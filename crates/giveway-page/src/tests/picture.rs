//! A page from a picture of its map.

use giveway_model::{Agent, Cell, Cost, Objective, Scene};

use crate::{Draft, State};

/// The page with a map and robots `a` to `d`, each from its lower to its upper letter.
pub(super) fn page(map: &[&str], costs: &[Cost]) -> State {
    let find = |letter: char| {
        let rows = (0..).zip(map);
        let mut cells =
            rows.flat_map(|(y, row)| (0..).zip(row.chars()).map(move |(x, c)| (x, y, c)));
        let found = cells.find(|&(_, _, c)| c == letter);
        found.map(|(x, y, _)| Cell::new(x, y))
    };
    let agent = |letter: char| {
        let goal = letter.to_ascii_uppercase();
        Some(Agent {
            name: goal.to_string(),
            start: find(letter)?,
            goal: Some(find(goal)?),
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        })
    };
    let ground = |row: &&str| row.replace(|c: char| c.is_alphabetic(), ".");
    let scene = Scene {
        map: map.iter().map(ground).collect(),
        agents: "abcd".chars().filter_map(agent).collect(),
        objective: Objective::new(costs.to_vec()).unwrap(),
        ..Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}
