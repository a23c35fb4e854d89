//! Relations between answers, on instances too large for the oracle.
//!
//! All plans within one horizon are compared, since only then a relation between
//! two sets of plans is one between two answers.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cell, Grid, Instance, Scene, check};
use giveway_solve::Status;
use giveway_tests::{ask, random};

/// The horizon, in time steps: enough for most medium instances.
const WITHIN: u32 = 30;

const SEED: u64 = 1;

/// The instances of a relation, each with its number.
fn instances(count: u64) -> impl Iterator<Item = (u64, Instance)> {
    (0..count).map(|number| (number, random::medium(SEED, number)))
}

/// The optimum as a value that can be compared: impossible is the largest.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Optimum {
    Plan(Vec<u32>),
    None,
}

fn optimum(instance: &Instance) -> Optimum {
    let answer = ask::best(instance, Some(WITHIN));
    match answer.status {
        Status::Optimal => {
            let report = check::check(instance, answer.plan.as_ref().unwrap());
            assert_eq!(report.violations, [], "{}", json(instance));
            assert_eq!(report.costs, answer.costs, "{}", json(instance));
            Optimum::Plan(answer.costs.unwrap().vector(instance.objective()))
        }
        Status::Impossible => Optimum::None,
        other => panic!("{other:?} for {}", json(instance)),
    }
}

fn json(instance: &Instance) -> String {
    serde_json::to_string(&instance.to_scene()).unwrap()
}

#[test]
fn an_added_obstacle_never_lowers_the_optimum() {
    for (number, instance) in instances(40) {
        let Some(cell) = random::spare_cell(&instance, number) else {
            continue;
        };
        let mut scene = instance.to_scene();
        let row = &mut scene.map[cell.y as usize];
        let x = cell.x as usize;
        row.replace_range(x..=x, "#");
        let walled = Instance::new(scene).unwrap();
        let (free, walled) = (optimum(&instance), optimum(&walled));
        assert!(
            free <= walled,
            "{free:?}, and {walled:?} with an obstacle at {cell}: {}",
            json(&instance)
        );
    }
}

#[test]
fn removing_an_agent_never_raises_the_optimum() {
    for (number, instance) in instances(40) {
        let mut scene = instance.to_scene();
        let gone = scene.agents.remove(number as usize % scene.agents.len());
        let fewer = optimum(&Instance::new(scene).unwrap());
        let all = optimum(&instance);
        assert!(
            fewer <= all,
            "{all:?}, and {fewer:?} without {}: {}",
            gone.name,
            json(&instance)
        );
    }
}

#[test]
fn a_mirrored_map_has_the_same_optimum() {
    for (number, instance) in instances(30) {
        let (mirror, name): (Mirror, &str) = match number % 3 {
            0 => (
                |c, grid| Cell::new(grid.width() - 1 - c.x, c.y),
                "left to right",
            ),
            1 => (
                |c, grid| Cell::new(c.x, grid.height() - 1 - c.y),
                "top to bottom",
            ),
            _ => (|c, _| Cell::new(c.y, c.x), "along the diagonal"),
        };
        let there = optimum(&instance);
        let here = optimum(&mirrored(&instance, mirror));
        assert_eq!(there, here, "mirrored {name}: {}", json(&instance));
    }
}

#[test]
fn the_order_of_the_agents_does_not_matter() {
    for (_, instance) in instances(20) {
        let mut scene = instance.to_scene();
        scene.agents.reverse();
        let reversed = Instance::new(scene).unwrap();
        assert_eq!(
            optimum(&instance),
            optimum(&reversed),
            "{}",
            json(&instance)
        );
    }
}

#[test]
fn a_larger_horizon_never_raises_the_optimum() {
    for (_, instance) in instances(20) {
        let best = |within| {
            let answer = ask::best(&instance, Some(within));
            match (answer.status, answer.costs) {
                (Status::Optimal, Some(costs)) => Optimum::Plan(costs.vector(instance.objective())),
                (Status::Impossible, None) => Optimum::None,
                other => panic!("{other:?} for {}", json(&instance)),
            }
        };
        let optima: Vec<Optimum> = (6..18).step_by(3).map(best).collect();
        assert!(
            optima.is_sorted_by(|a, b| a >= b),
            "{optima:?}: {}",
            json(&instance)
        );
    }
}

#[test]
fn two_runs_give_one_plan() {
    for (_, instance) in instances(20) {
        let answer = || ask::without_seconds(ask::best(&instance, None));
        assert_eq!(answer(), answer(), "{}", json(&instance));
    }
    for number in 0..40 {
        let instance = random::small(SEED, number);
        let answer = || ask::without_seconds(ask::best(&instance, None));
        assert_eq!(answer(), answer(), "{}", json(&instance));
    }
}

type Mirror = fn(Cell, &Grid) -> Cell;

/// The instance with every cell moved to another place.
fn mirrored(instance: &Instance, mirror: Mirror) -> Instance {
    let grid = instance.grid();
    let mut cells: Vec<(Cell, char)> = grid
        .cells()
        .map(|(cell, ground)| (mirror(cell, grid), ground.to_char()))
        .collect();
    cells.sort_by_key(|&(cell, _)| (cell.y, cell.x));
    let rows = cells.chunk_by(|(a, _), (b, _)| a.y == b.y);
    let mut agents = instance.agents().to_vec();
    for agent in &mut agents {
        agent.start = mirror(agent.start, grid);
        agent.goal = mirror(agent.goal, grid);
        for waypoint in &mut agent.waypoints {
            *waypoint = mirror(*waypoint, grid);
        }
    }
    let scene = Scene {
        map: rows
            .map(|row| row.iter().map(|&(_, c)| c).collect())
            .collect(),
        agents,
        ..instance.to_scene()
    };
    Instance::new(scene).unwrap()
}
