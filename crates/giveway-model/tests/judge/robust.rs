//! Plans of any size and with any cells.

use std::collections::BTreeMap;

use giveway_model::check::{MAX_VIOLATIONS, Rule, check, levels};
use giveway_model::{Agent, Battery, Cell, Instance, Plan, Scene};

/// A row of agents at (0, 0), (1, 0) and so on, each at its goal.
fn row_of_agents(n: u32) -> Instance {
    let agents = (0..n).map(|x| Agent {
        name: format!("A{x}"),
        start: Cell::new(x, 0),
        goal: Some(Cell::new(x, 0)),
        waypoints: Vec::new(),
        battery: Some(Battery {
            capacity: 5,
            initial: 5,
        }),
        heading: None,
    });
    Instance::new(Scene {
        map: vec![".".repeat(n as usize); 2],
        agents: agents.collect(),
        ..Scene::default()
    })
    .unwrap()
}

#[test]
fn cells_far_off_the_map() {
    let instance = row_of_agents(2);
    let far = Cell::new(u32::MAX, u32::MAX);
    let path = vec![Some(far), Some(Cell::new(0, 0)), None, Some(far), Some(far)];
    let plan = Plan {
        paths: BTreeMap::from([("A0".into(), path.clone()), ("A1".into(), path)]),
        charges: BTreeMap::from([("A0".into(), vec![0, 2, u32::MAX])]),
        ..Plan::default()
    };
    let report = check(&instance, &plan);
    let rules: Vec<Rule> = report.violations.iter().map(|v| v.rule).collect();
    for rule in [
        Rule::Start,
        Rule::Goal,
        Rule::Obstacle,
        Rule::Move,
        Rule::Vertex,
    ] {
        assert!(rules.contains(&rule), "{rule:?}");
    }
}

#[test]
fn a_long_path() {
    let instance = row_of_agents(1);
    let (here, there) = (Some(Cell::new(0, 0)), Some(Cell::new(0, 1)));
    let mut path = vec![here; 200_000];
    path.extend([there, here]);
    let plan = Plan {
        paths: BTreeMap::from([("A0".into(), path)]),
        ..Plan::default()
    };
    let report = check(&instance, &plan);
    assert_eq!(report.violations.len(), 1);
    assert_eq!(report.costs.map(|costs| costs.waits), Some(199_999));
    assert_eq!(levels(&instance, 0, &plan).last(), Some(&(5 - 200_001)));
}

#[test]
fn a_heap_of_agents_gives_a_long_report_not_an_endless_one() {
    let instance = row_of_agents(1000);
    let heap = Some(Cell::new(0, 1));
    let paths = instance
        .agents()
        .iter()
        .map(|agent| (agent.name.clone(), vec![heap; 50]));
    let plan = Plan {
        paths: paths.collect(),
        ..Plan::default()
    };
    assert_eq!(check(&instance, &plan).violations.len(), MAX_VIOLATIONS);
}
