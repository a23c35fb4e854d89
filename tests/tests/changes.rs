//! How plans go on in a changed world, against joint states, exhausted; and the
//! order of the methods.
//!
//! `GIVEWAY_RANDOM_CHANGES` sets how many (150 by default), `GIVEWAY_RANDOM_SEED`
//! the seed.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::change::{Change, Changes, What};
use giveway_model::check::{check, check_changes};
use giveway_model::{Instance, Objective, Plan, Version};
use giveway_solve::Status;
use giveway_solve::change::Method;
use giveway_tests::going_on::{costs, difference, go_on, oracle, plan_of};
use giveway_tests::loiter::loiter;
use giveway_tests::oracle::{Changed, Held, map_after};
use giveway_tests::{environment, random, upheaval};

/// The methods, and what each holds the old agents to.
const METHODS: [(Method, Held); 3] = [
    (Method::Revise, Held::Path),
    (Method::Tunnel(1), Held::Tunnel(1)),
    (Method::Replan, Held::Nothing),
];

#[test]
fn the_oracle_agrees() {
    let [freed, impossible] = agree(random::small);
    assert!(
        freed > 10 && impossible > 5,
        "freed {freed}, impossible {impossible}"
    );
}

#[test]
fn the_oracle_agrees_where_agents_have_no_goals() {
    agree(random::small_goalless);
}

/// Compares the answers about the instances of all numbers; how many freed agents, and
/// how many were impossible.
fn agree(instance_of: fn(u64, u64) -> Instance) -> [u32; 2] {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_CHANGES", 150);
    let (mut agreed, mut freed, mut impossible, mut differ) = (0, 0, 0, 0);
    for number in 0.. {
        if agreed + differ >= 3 * count {
            break;
        }
        assert!(number < 100 * count, "too few of them can be compared");
        let instance = instance_of(seed, number);
        if !(1..=2).contains(&instance.agents().len()) {
            continue;
        }
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let plan = if number % 2 == 0 {
            plan
        } else {
            loiter(&instance, &plan, seed, number)
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1);
        let mut list = upheaval::changes(&instance, longest as u32 - 1, seed, number);
        if instance.agents().iter().any(|agent| agent.goal.is_none()) {
            for change in &mut list {
                if let What::AddAgent { agent } = &mut change.what
                    && number % 3 == 0
                {
                    agent.goal = None;
                }
            }
        }
        let changes = Changes {
            giveway: Version,
            changes: list,
        };
        let asked: Vec<Method> = METHODS.iter().map(|&(method, _)| method).collect();
        let Some(answer) = go_on(&instance, &plan, &changes, &asked) else {
            continue;
        };
        let costs = costs(&instance);
        let at = answer.at.unwrap();
        let world = Changed::new(&instance, &costs, &plan, at, &changes.changes);
        let Some(mut world) = world else { continue };
        for (method, held) in METHODS {
            let Ok(known) = oracle(&mut world, held) else {
                continue;
            };
            let answer = answer.methods.get(method).unwrap();
            if let Some(plan) = &answer.result.plan {
                let report = check_changes(&instance, &changes, plan).unwrap();
                assert_eq!(report.violations, []);
                assert_eq!(report.costs, answer.result.costs);
            }
            match difference(&costs, answer, known.as_ref()) {
                None => agreed += 1,
                Some(told) => {
                    differ += 1;
                    let scene = serde_json::to_string(&instance.to_scene()).unwrap();
                    let plan = serde_json::to_string(&plan).unwrap();
                    let changes = serde_json::to_string(&changes).unwrap();
                    println!(
                        "{number} of seed {seed}, {method}: {told}\n{scene}\n{plan}\n{changes}"
                    );
                }
            }
            freed += u32::from(known.as_ref().is_some_and(|(freed, _)| *freed > 0));
            impossible += u32::from(known.is_none());
        }
    }
    println!("{agreed} agreed, {differ} differ; {freed} freed agents, {impossible} impossible");
    assert_eq!(differ, 0, "they are printed above");
    [freed, impossible]
}

/// The less the old agents are held to, the better.
#[test]
fn more_freedom_is_never_worse() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let methods = [
        Method::Replan,
        Method::Tunnel(2),
        Method::Tunnel(1),
        Method::Tunnel(0),
        Method::Revise,
    ];
    let mut compared = 0;
    for number in 0..60 {
        let instance = random::medium(seed, number);
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1);
        let list = upheaval::changes(&instance, longest as u32 / 2, seed, number);
        let changes = Changes {
            giveway: Version,
            changes: list,
        };
        let Some(answer) = go_on(&instance, &plan, &changes, &methods) else {
            continue;
        };
        let objective = Objective::new(costs(&instance)).unwrap();
        let mut before: Option<Vec<u32>> = None;
        for (method, answer) in &answer.methods.0 {
            let is_whole = answer.result.status == Status::Optimal && answer.closest;
            if !is_whole || !answer.freed.is_empty() {
                continue;
            }
            let mut vector = answer.result.costs.unwrap().vector(&objective);
            vector.push((answer.retimed.len() + answer.rerouted.len()) as u32);
            if let Some(before) = &before {
                assert!(*before <= vector, "{number} of seed {seed}: {method}");
                compared += 1;
            }
            before = Some(vector);
        }
    }
    println!("{compared} compared");
    assert!(compared > 40, "{compared} compared");
}

/// The instance as if the changes had been so from the beginning; `None` where a change
/// is of a kind that says more about the time when it comes.
fn from_the_beginning(instance: &Instance, changes: &[Change]) -> Option<Instance> {
    let mut scene = instance.to_scene();
    scene.map = map_after(&scene.map, changes);
    for change in changes {
        match &change.what {
            What::SetGoal { agent, cell } => {
                let mut agents = scene.agents.iter_mut();
                agents.find(|a| a.name == *agent)?.goal = Some(*cell);
            }
            What::AddWaypoint { agent, cell } => {
                let mut agents = scene.agents.iter_mut();
                let waypoints = &mut agents.find(|a| a.name == *agent)?.waypoints;
                waypoints.retain(|old| old != cell);
                waypoints.push(*cell);
            }
            What::AddObstacle { .. }
            | What::RemoveObstacle { .. }
            | What::MoveObstacle { .. }
            | What::SetSlow { .. }
            | What::SetNormal { .. }
            | What::AddCharger { .. }
            | What::RemoveCharger { .. } => {}
            _ => return None,
        }
    }
    Instance::new(scene).ok()
}

/// Two times of changes, one after the other. Where the plan after the first is one of
/// the instance that has these changes from the beginning, and costs the same, the
/// oracle can start from there.
#[test]
fn the_oracle_agrees_after_two_times_of_changes() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_CHANGES", 150) / 5;
    let asked: Vec<Method> = METHODS.iter().map(|&(method, _)| method).collect();
    let (mut agreed, mut differ, mut by_method) = (0, 0, BTreeMap::new());
    for number in 0.. {
        if agreed + differ >= 3 * count {
            break;
        }
        assert!(number < 1000 * count, "too few of them can be compared");
        let instance = random::small(seed ^ 0x2c, number);
        if !(1..=2).contains(&instance.agents().len()) {
            continue;
        }
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1) as u32 - 1;
        let first = upheaval::changes(&instance, longest / 2, seed, 2 * number);
        let Some(later) = from_the_beginning(&instance, &first) else {
            continue;
        };
        let since = first[0].at;
        let mut second = upheaval::changes(&later, longest, seed, 2 * number + 1);
        for change in &mut second {
            change.at += since + 1;
        }
        let changes = |list: &[Change]| Changes {
            giveway: Version,
            changes: list.to_vec(),
        };
        let Some(between) = go_on(&instance, &plan, &changes(&first), &asked) else {
            continue;
        };
        let Some(adopted) = between
            .adopted()
            .and_then(|method| method.result.plan.clone())
        else {
            continue;
        };
        let report = check(&later, &forgetful(&adopted));
        let told = between.adopted().and_then(|method| method.result.costs);
        if !report.violations.is_empty() || report.costs != told {
            continue;
        }
        let both = changes(&[first, second.clone()].concat());
        let Some(answer) = go_on(&instance, &plan, &both, &asked) else {
            continue;
        };
        let costs = costs(&instance);
        let at = answer.at.unwrap();
        let world = Changed::new(&later, &costs, &forgetful(&adopted), at, &second);
        let Some(mut world) = world else { continue };
        for (method, held) in METHODS {
            let Ok(known) = oracle(&mut world, held) else {
                continue;
            };
            let answer = answer.methods.get(method).unwrap();
            if let Some(plan) = &answer.result.plan {
                let report = check_changes(&instance, &both, plan).unwrap();
                assert_eq!(report.violations, []);
                assert_eq!(report.costs, answer.result.costs);
            }
            match difference(&costs, answer, known.as_ref()) {
                None => {
                    agreed += 1;
                    *by_method.entry(method.to_string()).or_insert(0) += 1;
                }
                Some(told) => {
                    differ += 1;
                    let scene = serde_json::to_string(&instance.to_scene()).unwrap();
                    let plan = serde_json::to_string(&plan).unwrap();
                    let both = serde_json::to_string(&both).unwrap();
                    println!("{number} of seed {seed}, {method}: {told}\n{scene}\n{plan}\n{both}");
                }
            }
        }
    }
    println!("{agreed} agreed {by_method:?}, {differ} differ");
    assert_eq!(differ, 0, "they are printed above");
}

/// The plan as one that knows of no change.
fn forgetful(plan: &Plan) -> Plan {
    Plan {
        knows: None,
        ..plan.clone()
    }
}
