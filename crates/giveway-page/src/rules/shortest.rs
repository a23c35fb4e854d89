//! The shortest ways of the robots that rules leave no plan for: on the map alone, without rules
//! and without other robots.

use std::collections::{BTreeMap, VecDeque};

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Grid, Ground};
use giveway_solve::explain::FactKind;

use super::clash::{core, single};
use crate::{Draft, State};

/// The ways of more robots than that could not be told apart.
const MOST: usize = 3;

/// The robots that the rules and facts without a plan are about, by their indices in the scene;
/// none where that is not known, or of too many.
pub fn in_clash_robots(state: &State) -> Vec<usize> {
    let Some(core) = core(state) else {
        return Vec::new();
    };
    let scene = state.document.draft.scene();
    let index = |name: &String| scene.agents.iter().position(|agent| agent.name == *name);
    let mut robots: Vec<usize> = Vec::new();
    for fact in &core.facts {
        match fact.kind {
            // Whose way it is.
            FactKind::Task
            | FactKind::Presence
            | FactKind::Waypoint
            | FactKind::Battery
            | FactKind::Deadline => robots.extend(fact.agents.iter().filter_map(index)),
            FactKind::Constraint => {
                let rule = fact.index.and_then(|at| scene.constraints.get(at as usize));
                let one = rule.and_then(|rule| single(&scene.agents, rule));
                robots.extend(one.map(|(index, _)| index));
            }
            FactKind::Floor
            | FactKind::Obstacle
            | FactKind::Slow
            | FactKind::Collision
            | FactKind::Stay
            | FactKind::Rest
            | FactKind::Breakdown => {}
        }
    }
    robots.sort_unstable();
    robots.dedup();
    if robots.len() > MOST {
        robots.clear();
    }
    robots
}

/// A short way of a robot over its waypoints to its goal: in the order that a rule gives, the
/// others by the nearest next one. Empty where there is none.
pub fn short_way(draft: &Draft, robot: usize) -> Vec<Cell> {
    let Some(agent) = draft.agents().get(robot) else {
        return Vec::new();
    };
    over_stops(draft, agent).unwrap_or_default()
}

fn over_stops(draft: &Draft, agent: &Agent) -> Option<Vec<Cell>> {
    let grid = draft.grid();
    let mut ordered = ordered(draft, agent);
    let mut open: Vec<Cell> = agent.waypoints.clone();
    open.retain(|cell| !ordered.contains(cell));
    let mut cells = vec![agent.start];
    while let Some(&at) = cells.last() {
        let next = ordered.front().copied();
        let ways = open.iter().copied().chain(next);
        let ways = ways.filter_map(|stop| way(grid, at, stop));
        let Some(way) = ways.min_by_key(Vec::len) else {
            break;
        };
        let stop = way.last().copied();
        ordered.pop_front_if(|cell| Some(*cell) == stop);
        open.retain(|cell| Some(*cell) != stop);
        cells.extend(way.into_iter().skip(1));
    }
    if !ordered.is_empty() || !open.is_empty() {
        return None;
    }
    if let Some(goal) = agent.goal {
        let last = way(grid, *cells.last()?, goal)?;
        cells.extend(last.into_iter().skip(1));
    }
    Some(cells)
}

/// The waypoints that rules give an order to.
fn ordered(draft: &Draft, agent: &Agent) -> VecDeque<Cell> {
    let rules = draft.scene().constraints.iter().filter(|rule| !rule.off);
    for rule in rules {
        if let ConstraintKind::Sequence { agent: of, cells } = &rule.kind
            && *of == agent.name
        {
            let own = cells.iter().copied();
            return own.filter(|cell| agent.waypoints.contains(cell)).collect();
        }
    }
    VecDeque::new()
}

/// Steps that a robot needs at least, by way of the waypoint that is furthest out: it may need
/// more.
pub(super) fn least_steps(grid: &Grid, agent: &Agent) -> Option<u32> {
    let goal = agent.goal?;
    let steps = |from, to| Some(way(grid, from, to)?.len().saturating_sub(1));
    let stops = agent.waypoints.iter().copied().chain([agent.start]);
    let ways = stops.map(|stop| Some(steps(agent.start, stop)? + steps(stop, goal)?));
    let longest = ways.collect::<Option<Vec<usize>>>()?.into_iter().max()?;
    u32::try_from(longest).ok()
}

/// A shortest way from one cell to another on an empty map, both ends in it.
fn way(grid: &Grid, from: Cell, to: Cell) -> Option<Vec<Cell>> {
    let mut before = BTreeMap::from([(from, from)]);
    let mut next = VecDeque::from([from]);
    while let Some(at) = next.pop_front() {
        if at == to {
            let back = std::iter::successors(Some(to), |at| {
                before.get(at).copied().filter(|_| *at != from)
            });
            let mut cells: Vec<Cell> = back.collect();
            cells.reverse();
            return Some(cells);
        }
        let (right, below) = (at.x.checked_add(1), at.y.checked_add(1));
        let around = [
            right.map(|x| Cell::new(x, at.y)),
            below.map(|y| Cell::new(at.x, y)),
            at.x.checked_sub(1).map(|x| Cell::new(x, at.y)),
            at.y.checked_sub(1).map(|y| Cell::new(at.x, y)),
        ];
        for cell in around.into_iter().flatten() {
            let is_free = grid.ground(cell).is_some_and(Ground::is_vertex);
            if is_free && !before.contains_key(&cell) {
                before.insert(cell, at);
                next.push_back(cell);
            }
        }
    }
    None
}
