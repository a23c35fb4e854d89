//! Optima of pebble motion (a `gap` of 1 among all robots) that SAT encodings of others have
//! proved (`data/README.md`). `scripts/records.mjs` compares all of their rows.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fs;
use std::path::Path;

use giveway_formats::movingai;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Constraint, Cost, Instance, Objective, check::check};
use giveway_solve::Status;
use giveway_tests::ask;

fn read(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/pebble");
    fs::read_to_string(folder.join(name)).unwrap()
}

/// The first agents of a scenario, who leave each cell free for a step.
fn pebbles(map: &str, scenario: &str, agents: usize, cost: Cost) -> Instance {
    let grid = movingai::read_map(&read(map)).unwrap();
    let scenario = movingai::read_scenario(&read(scenario)).unwrap();
    let mut scene = movingai::to_scene(map, &grid, &scenario, Some(agents)).unwrap();
    scene.objective = Objective::new(vec![cost]).unwrap();
    scene.constraints = vec![Constraint {
        kind: ConstraintKind::Gap { steps: 1 },
        agents: None,
        name: None,
        off: false,
    }];
    Instance::new(scene).unwrap()
}

#[test]
fn optima_are_those_of_the_encodings_of_others() {
    let mut rows = 0;
    for line in read("optima.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [map, scenario, agents, cost, motion, optimum, ..] = cells[..] else {
            unreachable!("{line}")
        };
        assert_eq!(motion, "pebble");
        let cost: Cost = cost.parse().unwrap();
        let instance = pebbles(map, scenario, agents.parse().unwrap(), cost);
        let answer = ask::best(&instance, None);
        assert_eq!(answer.status, Status::Optimal, "{line}");
        let costs = answer.costs.unwrap();
        assert_eq!(costs.get(cost).to_string(), optimum, "{line}");
        assert!(answer.reach.is_complete(), "{line}");
        let report = check(&instance, answer.plan.as_ref().unwrap());
        assert!(report.is_valid(), "{line}");
        rows += 1;
    }
    println!("{rows} rows");
    assert_eq!(rows, 16);
}
