//! Ledgers of single scenes, and what does not change them.

use std::collections::BTreeMap;

use giveway_model::check::Rule;
use giveway_model::format::native;
use giveway_model::{Cost, Instance, Objective, Plan};
use giveway_solve::delays::{DelayCause, DelaysRequest};
use giveway_solve::{Request, Response, SilentHost, serve};
use giveway_tests::going_on::plan_of;
use giveway_tests::random::small;
use serde_json::json;

use crate::lost::{by_cell, places_are_right};
use crate::{ask, ledger, plans, scenes};

#[test]
fn names_do_not_matter_and_one_robot_loses_nothing() {
    let (seed, count) = scenes(60);
    for number in 0..count {
        let instance = small(seed, number);
        let Some(plan) = plans(&instance).pop() else {
            continue;
        };
        let names: Vec<String> = instance.agents().iter().map(|it| it.name.clone()).collect();
        let other = |name: &str| {
            let place = names.iter().position(|it| it == name).unwrap();
            format!("Z{}", 9 - place)
        };
        let mut scene = instance.to_scene();
        for agent in &mut scene.agents {
            agent.name = other(&agent.name);
        }
        let renamed_plan = Plan {
            paths: plan
                .paths
                .iter()
                .map(|(name, it)| (other(name), it.clone()))
                .collect(),
            charges: plan
                .charges
                .iter()
                .map(|(name, it)| (other(name), it.clone()))
                .collect(),
            ..plan.clone()
        };
        let renamed = ledger(&Instance::new(scene).unwrap(), &renamed_plan);
        let answer = ledger(&instance, &plan);
        let mut rows = answer.agents.clone();
        for row in &mut rows {
            row.agent = other(&row.agent);
            for share in &mut row.because {
                if let DelayCause::Agent { agent } = &mut share.cause {
                    *agent = other(agent);
                }
            }
        }
        assert_eq!(renamed.agents, rows, "{number}");
        assert_eq!(renamed.lost, answer.lost, "{number}");
        for name in &names {
            let lone = instance.alone(name).unwrap();
            if let Some(plan) = plan_of(&lone.with_objective(Objective::default())) {
                let answer = ledger(&instance.alone(name).unwrap(), &plan);
                assert_eq!((answer.delay, answer.because.len()), (0, 0), "{number}");
            }
        }
    }
}

/// A robot that turns into a bay for another one, and one that nobody hinders.
#[test]
fn a_ledger_by_hand() {
    let scene = json!({ "giveway": 1, "map": ["...", "#.#"],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] },
                   { "name": "A2", "start": [2, 0], "goal": [0, 0] }] });
    let instance = native::read_instance(&scene.to_string()).unwrap();
    let plan = json!({ "giveway": 1, "paths": {
        "A1": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0]],
        "A2": [[2, 0], [2, 0], [1, 0], [0, 0]] } });
    let plan = native::read_plan(&plan.to_string()).unwrap();
    let answer = ledger(&instance, &plan);
    assert_eq!(answer.calm, None);
    let rows: Vec<(&str, u32, u32)> = answer
        .agents
        .iter()
        .map(|row| (row.agent.as_str(), row.delay, row.because.len() as u32))
        .collect();
    assert_eq!(rows, [("A1", 2, 1), ("A2", 1, 1)]);
    // It leaves the aisle for the bay, and comes back.
    assert_eq!(
        by_cell(&answer.agents[0].lost),
        BTreeMap::from([((1, 0), 2)])
    );
    assert_eq!(
        by_cell(&answer.agents[1].lost),
        BTreeMap::from([((2, 0), 1)])
    );
    assert_eq!(
        answer.words,
        "3 steps are lost: alone the robots need 4 in all, here 7. Whether any of this can be \
         saved is open. A1 arrives at 4 and loses 2: in the way that it would take alone there is A2. A2 \
         arrives at 3 and loses 1: in the way that it would take alone there is A1. Most is lost from (1, 0) to (2, 0): 3 steps (A1 2 and A2 1)."
    );
    let answer = ask(DelaysRequest {
        scene: instance.to_scene(),
        plan: Some(plan),
        ..DelaysRequest::default()
    });
    let proof = answer.proof.clone().unwrap();
    assert_eq!((proof.at_least, proof.at_most), (3, 3));
    assert_eq!(proof.given, BTreeMap::from([(Cost::Makespan, 4)]));
    assert!(
        answer
            .words
            .contains("No plan that is done at 4 loses less.")
    );
}

/// A plan that breaks a rule has no ledger.
#[test]
fn what_is_no_plan_is_refused() {
    let scene = json!({ "giveway": 1, "map": ["..."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] });
    let scene = native::read_scene(&scene.to_string()).unwrap();
    let plan = json!({ "giveway": 1, "paths": { "A1": [[0, 0], [2, 0]] } });
    let request = DelaysRequest {
        scene,
        plan: Some(native::read_plan(&plan.to_string()).unwrap()),
        ..DelaysRequest::default()
    };
    let response = serve(&Request::Delays(request), &SilentHost);
    let Response::Refused(giveway_solve::Refusal::Plan { violations }) = response else {
        panic!("{response:?}")
    };
    assert_eq!(violations[0].rule, Rule::Move);
}

/// A floor that was drawn by hand: 16 robots on 40 x 24 cells.
#[test]
fn a_real_floor_has_its_ledger() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/depot/");
    let read = |file: &str| std::fs::read_to_string(format!("{folder}{file}")).unwrap();
    let instance = native::read_instance(&read("depot.json")).unwrap();
    let plan = native::read_plan(&read("depot-plan.json")).unwrap();
    let answer = ledger(&instance, &plan);
    assert_eq!((answer.alone, answer.delay), (848, 150));
    let first: Vec<(&str, u32)> = answer
        .agents
        .iter()
        .take(4)
        .map(|row| (row.agent.as_str(), row.delay))
        .collect();
    assert_eq!(first, [("A1", 43), ("A2", 38), ("A3", 33), ("A4", 22)]);
    places_are_right(&answer, "depot");
}
