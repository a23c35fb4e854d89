//! The search of states beside the oracle, and conditions beside rules.

use std::collections::BTreeMap;

use giveway_model::condition::{Act, Times, Visit};
use giveway_model::format::native;
use giveway_model::{Cell, Condition, Cost, Instance};
use giveway_proof::exhaust::{Exhausted, exhaust, exhaust_kind};
use giveway_proof::{Budget, Claim};
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::scene_with_rules;

use super::{LAST, MOST_STATES, Optima, is_satisfiable, kinds, scenes, seed};

#[test]
fn a_search_of_states_agrees_with_the_oracle_at_any_horizon() {
    let budget = Budget {
        states: 60_000,
        ..Budget::default()
    };
    let (mut plans, mut none, mut limits, mut stopped) = (0, 0, 0, 0);
    for number in 0..scenes(420) {
        let scene = scene_with_rules(seed(63), number, &kinds(number)).to_string();
        let instance = native::read_instance(&scene).unwrap();
        let all: Vec<usize> = (0..instance.agents().len()).collect();
        let mut agrees = |most: &BTreeMap<Cost, u32>, exists: bool| {
            let found = exhaust(&instance, &all, most, &budget);
            stopped += u32::from(found == Exhausted::Stopped);
            found == Exhausted::Stopped || matches!(found, Exhausted::Plan(_)) == exists
        };
        match best(&RuleScene::read(&scene, &[]), None, MOST_STATES) {
            Answer::Capped => {}
            Answer::Impossible => {
                none += 1;
                assert!(agrees(&BTreeMap::new(), false), "{number}: {scene}");
            }
            Answer::Best(vector) => {
                plans += 1;
                let optima = Optima::of(&instance, &vector);
                assert!(agrees(&optima.met(), true), "{number}: {vector:?} {scene}");
                for less in optima.less() {
                    limits += 1;
                    assert!(
                        agrees(&less, false),
                        "{number}: {less:?} of {vector:?} {scene}"
                    );
                }
            }
        }
    }
    println!("{plans} with plans, {none} without, {limits} limits, {stopped} too large");
    assert!(plans > 200 && none > 50 && limits > 300 && stopped < 40);
}

/// A condition of a claim about agents and cells of a scene.
fn condition(number: u64, instance: &Instance) -> Condition {
    let agents = instance.agents();
    let agent = |n: u64| &agents[n as usize % agents.len()];
    let name = agent(number).name.clone();
    let cells: Vec<Cell> = instance.grid().cells().map(|(cell, _)| cell).collect();
    let cell = cells[number as usize % cells.len()];
    let visit = |n: u64, cell: Cell| Visit {
        agent: agent(n).name.clone(),
        cell,
    };
    match number % 5 {
        0 => Condition::Visit {
            agent: Some(name),
            cell,
        },
        1 => Condition::Never {
            agent: name,
            act: Act::Visit(cell),
            times: Times::at(Some(number as u32 % 7)),
        },
        2 => Condition::Never {
            agent: name,
            act: Act::Wait {
                cell: None,
                steps: 1,
            },
            times: Times::default(),
        },
        3 => Condition::Before {
            first: visit(number, cell),
            second: visit(number + 1, agent(number).goal.unwrap()),
        },
        _ => Condition::Below {
            agent: Some(name),
            cost: Cost::Moves,
            limit: 3 + number as u32 % 3,
        },
    }
}

/// Formula and search are written apart, and agree on what a condition and rules leave.
#[test]
fn conditions_hold_beside_rules() {
    let budget = Budget {
        states: 60_000,
        ..Budget::default()
    };
    let (mut plans, mut none, mut later) = (0, 0, 0);
    for number in 0..scenes(280) {
        let scene = scene_with_rules(seed(66), number, &kinds(number)).to_string();
        let instance = native::read_instance(&scene).unwrap();
        let claim = Claim {
            condition: Some(condition(number, &instance)),
            ..Claim::default()
        };
        let in_time = claim.clone().within(Some(LAST));
        match exhaust_kind(&instance, &claim, &budget) {
            Exhausted::Stopped => {}
            Exhausted::NoPlan => {
                none += 1;
                assert!(!is_satisfiable(&instance, &in_time), "{claim:?} {scene}");
            }
            Exhausted::Plan(_) if is_satisfiable(&instance, &in_time) => plans += 1,
            Exhausted::Plan(_) => later += 1,
        }
    }
    println!("{plans} with plans, {none} without, {later} perhaps with later ones");
    assert!(plans > 100 && none > 40 && later * 10 < plans);
}
