//! The exact tables: every state, every metric.

use giveway_model::Instance;

use super::PICTURES;
use crate::{
    budget::Unlimited,
    single::{CostToGo, Metric, Task},
    terrain::Terrain,
    tests::{Lone, Spot, instance, random},
};

/// Compares a table with the rules; returns how many states have an end.
fn check(instance: &Instance, metric: Metric) -> usize {
    let budget = Unlimited::default();
    let terrain = Terrain::new(instance.grid());
    let floor = instance.rules().battery_floor;
    let mut ends = 0;
    for (i, agent) in instance.agents().iter().enumerate() {
        let lone = Lone::new(instance, i);
        let Ok(task) = Task::new(agent, instance.rules(), &terrain) else {
            assert_eq!(lone.start(), None);
            continue;
        };
        let table = CostToGo::new(&task, &terrain, metric, &budget).unwrap();
        let expect = lone.cost_to_go(metric);
        for state in lone.states() {
            let Spot::At(cell) = state.spot else { continue };
            let level = state.level.map_or(0, |level| level - floor);
            let found = table.from(terrain.vertex(cell).unwrap(), state.visited.into(), level);
            let expect = expect.get(&state).copied();
            ends += usize::from(expect.is_some());
            let rows = instance.grid().rows();
            assert_eq!(
                found, expect,
                "{metric:?} {state:?} of {agent:?} in {rows:#?}"
            );
        }
    }
    ends
}

#[test]
fn time() {
    for picture in PICTURES {
        assert!(check(&instance(picture), Metric::Time) > 0);
    }
}

#[test]
fn charges() {
    for picture in PICTURES {
        assert!(check(&instance(picture), Metric::Charges) > 0);
    }
}

#[test]
fn moves() {
    for picture in PICTURES {
        assert!(check(&instance(picture), Metric::Moves) > 0);
    }
}

#[test]
fn random_instances() {
    let mut ends = 0;
    for seed in 0..400 {
        let metric = [Metric::Time, Metric::Charges, Metric::Moves][seed as usize % 3];
        ends += check(&random(seed, 1), metric);
    }
    assert!(ends > 4_000, "{ends} states");
}

#[test]
fn a_known_value() {
    // Charge at (2, 0), half way: the table is not only equal, but right.
    let instance = instance(
        "a . + . A
         battery a 2/4",
    );
    let budget = Unlimited::default();
    let terrain = Terrain::new(instance.grid());
    let task = Task::new(&instance.agents()[0], instance.rules(), &terrain).unwrap();
    for (metric, most, least) in [
        (Metric::Time, 4, 4),
        (Metric::Charges, 1, 0),
        (Metric::Moves, 4, 4),
    ] {
        let table = CostToGo::new(&task, &terrain, metric, &budget).unwrap();
        assert_eq!(table.from(task.start, 0, 2), Some(most));
        assert_eq!(table.from(task.start, 0, 4), Some(least));
        assert_eq!(table.from(task.start, 0, 1), None);
    }
}
