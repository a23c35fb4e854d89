//! Relations between answers, on instances too large for the oracle.
//!
//! All plans within one horizon are compared, since only then a relation between
//! two sets of plans is one between two answers. An instance that needs too many
//! conflicts is passed over, which few may be.
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

/// Conflicts of the SAT solver for one answer.
const CONFLICTS: u64 = 10_000;

const SEED: u64 = 1;

/// Holds a relation against so many instances. It is given the number and the
/// instance, and returns `None` where an answer took too long.
fn check_each(count: u64, relation: impl Fn(u64, &Instance) -> Option<()>) {
    let answered = (0..count)
        .filter_map(|number| relation(number, &random::medium(SEED, number)))
        .count() as u64;
    println!("{answered} of {count} instances");
    assert!(
        answered * 10 >= count * 9,
        "only {answered} of {count} instances were answered"
    );
}

/// The optimum as a value that can be compared: impossible is the largest.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Optimum {
    Plan(Vec<u32>),
    None,
}

fn optimum(instance: &Instance, within: u32) -> Option<Optimum> {
    let answer = ask::best_within_conflicts(instance, Some(within), CONFLICTS);
    match answer.status {
        Status::Optimal => {
            let report = check::check(instance, answer.plan.as_ref().unwrap());
            assert_eq!(report.violations, [], "{}", json(instance));
            assert_eq!(report.costs, answer.costs, "{}", json(instance));
            let vector = answer.costs.unwrap().vector(instance.objective());
            Some(Optimum::Plan(vector))
        }
        Status::Impossible => Some(Optimum::None),
        Status::Feasible | Status::Unknown => {
            let all_used = answer.stats.conflicts >= CONFLICTS;
            assert!(all_used, "{answer:?} for {}", json(instance));
            None
        }
    }
}

fn json(instance: &Instance) -> String {
    serde_json::to_string(&instance.to_scene()).unwrap()
}

#[test]
fn an_added_obstacle_never_lowers_the_optimum() {
    check_each(40, |number, instance| {
        let cell = random::spare_cell(instance, number)?;
        let mut scene = instance.to_scene();
        let row = &mut scene.map[cell.y as usize];
        let x = cell.x as usize;
        row.replace_range(x..=x, "#");
        let walled = optimum(&Instance::new(scene).unwrap(), WITHIN)?;
        let free = optimum(instance, WITHIN)?;
        assert!(
            free <= walled,
            "{free:?}, and {walled:?} with an obstacle at {cell}: {}",
            json(instance)
        );
        Some(())
    });
}

#[test]
fn removing_an_agent_never_raises_the_optimum() {
    check_each(40, |number, instance| {
        let mut scene = instance.to_scene();
        let gone = scene.agents.remove(number as usize % scene.agents.len());
        let fewer = optimum(&Instance::new(scene).unwrap(), WITHIN)?;
        let all = optimum(instance, WITHIN)?;
        assert!(
            fewer <= all,
            "{all:?}, and {fewer:?} without {}: {}",
            gone.name,
            json(instance)
        );
        Some(())
    });
}

#[test]
fn a_mirrored_map_has_the_same_optimum() {
    check_each(40, |number, instance| {
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
        let there = optimum(instance, WITHIN)?;
        let here = optimum(&mirrored(instance, mirror), WITHIN)?;
        assert_eq!(there, here, "mirrored {name}: {}", json(instance));
        Some(())
    });
}

#[test]
fn the_order_of_the_agents_does_not_matter() {
    check_each(40, |_, instance| {
        let mut scene = instance.to_scene();
        scene.agents.reverse();
        let reversed = optimum(&Instance::new(scene).unwrap(), WITHIN)?;
        assert_eq!(optimum(instance, WITHIN)?, reversed, "{}", json(instance));
        Some(())
    });
}

#[test]
fn a_larger_horizon_never_raises_the_optimum() {
    check_each(40, |_, instance| {
        let optima = (6..18).step_by(3).map(|within| optimum(instance, within));
        let optima: Vec<Optimum> = optima.collect::<Option<_>>()?;
        let falls = optima.is_sorted_by(|a, b| a >= b);
        assert!(falls, "{optima:?}: {}", json(instance));
        Some(())
    });
}

#[test]
fn two_runs_give_one_plan() {
    check_each(40, |number, medium| {
        for instance in [medium, &random::small(SEED, number)] {
            let answer = || {
                let answer = ask::best_within_conflicts(instance, None, CONFLICTS);
                ask::without_seconds(answer)
            };
            assert_eq!(answer(), answer(), "{}", json(instance));
        }
        Some(())
    });
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
        agent.goal = agent.goal.map(|goal| mirror(goal, grid));
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
