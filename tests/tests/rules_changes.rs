//! Plans that go on when the world changes, under rules of a scene's own: the solver against
//! joint states, exhausted from the time of the change on.
//!
//! `GIVEWAY_RULE_CHANGES` sets how many random changes each test compares,
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RULE_CHANGES=20000 cargo test --release -p giveway-tests --test rules_changes
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::change::{Changes, History};
use giveway_model::check::{check, check_changes};
use giveway_model::format::native;
use giveway_model::snapshot::Snapshot;
use giveway_model::{Instance, Objective, Plan};
use giveway_solve::change::{Method, MethodAnswer};
use giveway_solve::{Ended, Status};
use giveway_tests::environment;
use giveway_tests::going_on::{go_on, plan_of};
use giveway_tests::rules_oracle::{Answer, ChangedRules};
use giveway_tests::rules_random::{KINDS, changes_of_rules, scene_to_change};
use serde_json::{Value, json};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 20_000;

/// A plan around which the world changes.
struct Case {
    text: String,
    scene: Value,
    instance: Instance,
    plan: Plan,
    changes: Vec<Value>,
    read: Changes,
}

impl Case {
    fn random(seed: u64, number: u64, kinds: &[&str]) -> Option<Self> {
        let (scene, rule) = scene_to_change(seed, number, kinds);
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let plan = plan_of(&instance)?;
        assert!(check(&instance, &plan).is_valid());
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1);
        let changes = changes_of_rules(seed, number, (&scene, &rule), longest as u32 - 1);
        let file = json!({ "giveway": 1, "changes": changes }).to_string();
        let read = native::read_changes(&file).unwrap();
        let plan_text = serde_json::to_string(&plan).unwrap();
        Some(Self {
            text: format!("{number} {kinds:?}\n{scene}\n{plan_text}\n{file}"),
            scene,
            instance,
            plan,
            changes,
            read,
        })
    }
}

/// There were too many joint states.
struct TooMany;

/// The fewest agents freed of a method that holds the others, and the best plan then.
fn fewest(world: &mut ChangedRules, holds: bool) -> Result<Option<(usize, Vec<i64>)>, TooMany> {
    let old: Vec<String> = world.old().into_iter().map(str::to_owned).collect();
    let most = if holds { old.len() } else { 0 };
    for size in 0..=most {
        let mut best: Option<Vec<i64>> = None;
        for set in 0_u32..1 << old.len() {
            if set.count_ones() as usize != size {
                continue;
            }
            let is_held = |i: &usize| holds && set & 1 << i == 0;
            let held = (0..old.len()).filter(is_held);
            let held: Vec<&str> = held.map(|i| old[i].as_str()).collect();
            match world.best(&held, MOST_STATES) {
                Answer::Capped => return Err(TooMany),
                Answer::Impossible => {}
                Answer::Best(costs) => {
                    best = Some(best.map_or(costs.clone(), |best| best.min(costs)));
                }
            }
        }
        if let Some(best) = best {
            return Ok(Some((size, best)));
        }
    }
    Ok(None)
}

/// What differs between an answer and the oracle.
fn difference(
    objective: &[String],
    method: &MethodAnswer,
    known: Option<&(usize, Vec<i64>)>,
) -> Option<String> {
    let result = &method.result;
    let told = |what: &str| Some(format!("{what}: the oracle has {known:?}, not {method:?}"));
    match (result.status, known) {
        (Status::Impossible, None) => None,
        (Status::Impossible, Some((_, costs))) => match result.reach.within() {
            Some(within) if costs[0] > i64::from(within) => None,
            _ => told("impossible"),
        },
        (Status::Optimal, None) => told("optimal"),
        (Status::Optimal, Some((freed, costs))) => {
            let names: Vec<_> = objective.iter().map(|name| name.parse().unwrap()).collect();
            let objective = Objective::new(names).unwrap();
            let own = result.costs.unwrap().vector(&objective);
            let own: Vec<i64> = own.into_iter().map(i64::from).collect();
            if own != *costs {
                told("costs")
            } else if method.freed.len() != *freed || !method.fewest {
                told("freed")
            } else {
                let mut bounds = result.bounds.iter();
                let differs = bounds.any(|(&cost, &n)| result.costs.unwrap().get(cost) != n);
                differs.then(|| told("bounds")).flatten()
            }
        }
        // The budget is small.
        (Status::Unknown | Status::Feasible, _) => match result.ended {
            Some(Ended::Conflicts) => None,
            _ => told("open"),
        },
    }
}

/// Compares changes of so many plans; how many could be gone on with, and how many not.
fn agree(seed: u64, count: u64, kinds: impl Fn(u64) -> Vec<&'static str>) -> [u32; 3] {
    let (mut found, mut none, mut freed, mut differ) = (0, 0, 0, 0);
    for number in 0..count {
        let kinds = kinds(number);
        let Some(case) = Case::random(seed, number, &kinds) else {
            continue;
        };
        let methods = [Method::Revise, Method::Replan];
        let Some(answer) = go_on(&case.instance, &case.plan, &case.read, &methods) else {
            continue;
        };
        let at = answer.at.unwrap();
        let mut world = ChangedRules::new(&case.scene, &case.plan, at, &case.changes);
        for (method, holds) in [(Method::Revise, true), (Method::Replan, false)] {
            let Ok(known) = fewest(&mut world, holds) else {
                continue;
            };
            let answer = answer.methods.get(method).unwrap();
            let mut told = difference(world.objective(), answer, known.as_ref());
            if let Some(plan) = &answer.result.plan {
                let report = check_changes(&case.instance, &case.read, plan).unwrap();
                if !report.is_valid() || report.costs != answer.result.costs {
                    told = Some(format!("judge: {report:?}"));
                }
            }
            match &known {
                Some((0, _)) => found += 1,
                Some(_) => freed += 1,
                None => none += 1,
            }
            if let Some(told) = told {
                differ += 1;
                println!("{} {method}: {told}\n", case.text);
            }
        }
    }
    println!("{found} found, {freed} freed, {none} impossible, {differ} differ");
    assert_eq!(differ, 0, "they are printed above");
    [found, freed, none]
}

fn count(usual: u64) -> u64 {
    environment::number("GIVEWAY_RULE_CHANGES", usual)
}

#[test]
fn a_rule_that_begins_has_the_best_rest_of_the_oracle() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 5);
    let kinds = |number: u64| vec![KINDS[number as usize % KINDS.len()]];
    let [found, freed, none] = agree(seed, count(560), kinds);
    assert!(found > 300 && freed > 30 && none > 30);
}

#[test]
fn rules_in_force_have_the_best_rest_of_the_oracle() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 6);
    let kinds = |number: u64| {
        let number = number as usize;
        let (i, k) = (number % KINDS.len(), number / KINDS.len() % KINDS.len());
        vec![KINDS[i], KINDS[k]]
    };
    let [found, freed, none] = agree(seed, count(784), kinds);
    assert!(found > 300 && freed > 30 && none > 30);
}

#[test]
fn several_rules_in_force_have_the_best_rest_of_the_oracle() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 7);
    let kinds = |number: u64| {
        let number = number as usize;
        let kind = |which: usize| KINDS[which % KINDS.len()];
        vec![kind(number), kind(number / 14 + number), kind(number / 3)]
    };
    let [found, freed, none] = agree(seed, count(300), kinds);
    assert!(found > 80 && freed > 5 && none > 5);
}

/// Plans that heed no rule after the change: the judge says what the oracle says.
#[test]
fn the_judge_agrees_on_plans_that_heed_no_rule() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 8);
    let (mut kept, mut broken, mut differ) = (0, 0, 0);
    for number in 0..count(900) {
        let k = number as usize;
        let kinds = [KINDS[k % KINDS.len()], KINDS[k / KINDS.len() % KINDS.len()]];
        let Some(case) = Case::random(seed, number, &kinds) else {
            continue;
        };
        let mut scene = case.instance.to_scene();
        scene.constraints.clear();
        let free = Instance::new(scene).unwrap();
        let is_of_rules = |change: &Value| change["change"].as_str().unwrap().ends_with("straint");
        let mut others = case.changes.clone();
        others.retain(|change| !is_of_rules(change));
        if others.is_empty() {
            // Something has to change for the plan to go on.
            others
                .push(json!({ "change": "set-normal", "at": case.changes[0]["at"], "cells": [] }));
        }
        let file = json!({ "giveway": 1, "changes": others }).to_string();
        let others = native::read_changes(&file).unwrap();
        let Some(answer) = go_on(&free, &case.plan, &others, &[Method::Replan]) else {
            continue;
        };
        let method = answer.methods.get(Method::Replan).unwrap();
        let Some(plan) = &method.result.plan else {
            continue;
        };
        // What contradicts the world is refused.
        let Ok(report) = check_changes(&case.instance, &case.read, plan) else {
            continue;
        };
        let at = answer.at.unwrap();
        let world = ChangedRules::new(&case.scene, &case.plan, at, &case.changes);
        let is_allowed = world.allows(plan);
        *(if is_allowed { &mut kept } else { &mut broken }) += 1;
        if report.is_valid() != is_allowed {
            differ += 1;
            let plan = serde_json::to_string(plan).unwrap();
            println!(
                "{} judge: {is_allowed} but {:?}\n{plan}\n",
                case.text, report.violations
            );
        }
    }
    println!("{kept} kept, {broken} broken, {differ} differ");
    assert_eq!(differ, 0, "they are printed above");
    assert!(kept > 200 && broken > 100);
}

/// Two times of changes, one after the other: what is told of each plan is what the judge
/// says of it, and no plan that is found is none.
#[test]
fn plans_that_go_on_twice_are_what_they_are_told_to_be() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 9);
    let (mut twice, mut plans) = (0, 0);
    for number in 0..count(500) {
        let k = number as usize;
        let kind = |which: usize| KINDS[which % KINDS.len()];
        let kinds = [kind(k), kind(k / 14 + k), kind(k / 3)];
        let (mut scene, later) = scene_to_change(seed, number, &kinds);
        let rule = scene["constraints"].as_array_mut().unwrap().pop().unwrap();
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1) as u32 - 1;
        let first = changes_of_rules(seed, 2 * number, (&scene, &rule), longest / 2);
        let mut second = changes_of_rules(seed, 2 * number + 1, (&scene, &later), longest);
        for change in &mut second {
            let since = first[0]["at"].as_u64().unwrap() + 1;
            change["at"] = json!(change["at"].as_u64().unwrap() + since);
        }
        let both = [first, second].concat();
        let file = json!({ "giveway": 1, "changes": both }).to_string();
        let read = native::read_changes(&file).unwrap();
        let methods = [Method::Revise, Method::Tunnel(1), Method::Replan];
        let Some(answer) = go_on(&instance, &plan, &read, &methods) else {
            continue;
        };
        twice += u32::from(!answer.history.is_empty());
        let earlier = answer
            .history
            .iter()
            .map(|step| (Some(step.at), &step.methods));
        for (at, methods) in earlier.chain([(answer.at, &answer.methods)]) {
            let mut known = read.clone();
            known.changes.retain(|change| Some(change.at) <= at);
            for (method, found) in &methods.0 {
                let what = format!("{number} {method} at {at:?}\n{scene}\n{file}\n{found:?}");
                assert_ne!(found.result.ended, Some(Ended::Fault), "{what}");
                if let Some(plan) = &found.result.plan {
                    let report = check_changes(&instance, &known, plan).unwrap();
                    assert_eq!(report.violations, [], "{what}");
                    assert_eq!(report.costs, found.result.costs, "{what}");
                    plans += 1;
                }
            }
        }
    }
    println!("{twice} went on twice, {plans} plans");
    assert!(twice > 100 && plans > 400);
}

/// The rest of a plan is judged by itself as it is behind the past.
#[test]
fn the_rest_is_judged_as_the_whole_is() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 10);
    let (mut valid, mut broken) = (0, 0);
    for number in 0..count(900) {
        let k = number as usize;
        let kinds = [KINDS[k % KINDS.len()], KINDS[k / KINDS.len() % KINDS.len()]];
        let Some(case) = Case::random(seed, number, &kinds) else {
            continue;
        };
        let past = History::new(&case.instance);
        let Ok(history) = History::of(&case.instance, &case.read, &case.plan) else {
            continue;
        };
        let at = case.read.changes[0].at;
        let snapshot = Snapshot::new(at, &case.instance, (&past, &history), &case.plan);
        let rest = snapshot.rest();
        if rest.paths.len() < snapshot.instance.agents().len() {
            continue; // one joins, and has no path yet
        }
        let whole = snapshot.check(&rest);
        let own = check(&snapshot.instance, &rest);
        let told = format!(
            "{}\n{:?}\n{:?}",
            case.text, whole.violations, own.violations
        );
        assert_eq!(whole.is_valid(), own.is_valid(), "{told}");
        if own.is_valid() {
            let costs = own.costs.map(|costs| snapshot.whole_costs(costs, &rest));
            assert_eq!(costs, whole.costs, "{told}");
        }
        *(if own.is_valid() {
            &mut valid
        } else {
            &mut broken
        }) += 1;
    }
    println!("{valid} valid, {broken} broken");
    assert!(valid > 200 && broken > 100);
}
