//! What no tool of a lesson can change of a scene and its robots.
//!
//! Each field is named here, so that a field that is added cannot be forgotten.

use giveway_model::{Agent, Grid, Scene};

/// Whether a scene differs from the one that a step began with in nothing but its map and
/// its robots, and in what zones and rules lose with those.
pub(super) fn is_same_but_for_board(start: &Scene, scene: &Scene, grid: &Grid) -> bool {
    let Scene {
        giveway,
        name,
        map: _,
        rules,
        objective,
        agents: _,
        assumptions,
        zones,
        constraints,
        units,
    } = start;
    let is_same = *giveway == scene.giveway
        && *name == scene.name
        && *rules == scene.rules
        && *objective == scene.objective
        && *assumptions == scene.assumptions
        && *units == scene.units;
    // A robot that is removed goes out of the rules that name it, as on the page.
    let mut settled = Scene {
        zones: zones.clone(),
        constraints: constraints.clone(),
        agents: scene.agents.clone(),
        ..Scene::default()
    };
    let found = (&scene.zones, &scene.constraints);
    is_same
        && (found == (zones, constraints) || {
            settled.settle_rules(grid);
            found == (&settled.zones, &settled.constraints)
        })
}

/// Whether a robot differs from what it was in nothing but its places.
pub(super) fn is_same_but_for_places(before: &Agent, now: &Agent) -> bool {
    let Agent {
        name,
        start: _,
        goal: _,
        waypoints: _,
        battery,
        heading,
    } = before;
    *name == now.name && *battery == now.battery && *heading == now.heading
}

/// Whether a robot that came is one that the page places: with the battery of one that
/// was there, without one where none was, and facing nowhere.
pub(super) fn is_as_placed(start: &Scene, scene: &Scene, agent: &Agent, may_erase: bool) -> bool {
    let Agent {
        name: _,
        start: _,
        goal: _,
        waypoints: _,
        battery,
        heading,
    } = agent;
    let has_none = || scene.agents.iter().all(|other| other.battery.is_none());
    let is_first = battery.is_none() && (start.agents.is_empty() || (may_erase && has_none()));
    let has_like = || start.agents.iter().any(|other| other.battery == *battery);
    heading.is_none() && (is_first || has_like())
}
