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

use giveway_model::change::Changes;
use giveway_model::check::check_changes;
use giveway_model::{Cost, Instance, Objective, Plan, Version};
use giveway_solve::change::{ChangeAnswer, ChangeRequest, Method, MethodAnswer};
use giveway_solve::{Limits, Refusal, Request, Response, SilentHost, SolveRequest, Status, serve};
use giveway_tests::loiter::loiter;
use giveway_tests::oracle::{Changed, Held, Known};
use giveway_tests::{environment, random, upheaval};

/// Joint states that the oracle may look at.
const CAP: usize = 30_000;

/// An optimal plan of an instance.
fn plan_of(instance: &Instance) -> Option<Plan> {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        limits: limits(),
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer.plan,
        other => panic!("{other:?}"),
    }
}

fn limits() -> Limits {
    Limits {
        conflicts: Some(20_000),
        ..Limits::default()
    }
}

/// How to go on; `None` where the changes contradict the world.
fn go_on(
    instance: &Instance,
    plan: &Plan,
    changes: &Changes,
    methods: &[Method],
) -> Option<ChangeAnswer> {
    let request = Request::Change(ChangeRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.clone(),
        since: None,
        methods: methods.to_vec(),
        objective: None,
        within: None,
        limits: limits(),
    });
    match serve(&request, &SilentHost) {
        Response::Changed(answer) => Some(*answer),
        Response::Refused(Refusal::Changes { .. }) => None,
        other => panic!("{other:?}"),
    }
}

fn costs(instance: &Instance) -> Vec<Cost> {
    let others = instance.objective().costs().iter().copied();
    let others = others.filter(|&cost| cost != Cost::Makespan);
    [Cost::Makespan].into_iter().chain(others).collect()
}

/// There were too many joint states.
struct TooMany;

/// The fewest agents freed with which there is a way, and the best of these.
fn oracle(changed: &mut Changed, held: Held) -> Result<Option<(usize, Vec<u32>)>, TooMany> {
    let old: Vec<String> = changed.old().into_iter().map(str::to_owned).collect();
    let most = if held == Held::Nothing { 0 } else { old.len() };
    for size in 0..=most {
        let mut best: Option<Vec<u32>> = None;
        for set in 0_u32..1 << old.len() {
            if set.count_ones() as usize != size {
                continue;
            }
            let freed: Vec<&str> = (0..old.len())
                .filter(|i| set & 1 << i != 0)
                .map(|i| old[i].as_str())
                .collect();
            match changed.best(held, &freed, CAP) {
                Known::Capped => return Err(TooMany),
                Known::None => {}
                Known::Best(vector) => {
                    best = Some(best.map_or(vector.clone(), |best| best.min(vector)));
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
    costs: &[Cost],
    method: &MethodAnswer,
    known: Option<&(usize, Vec<u32>)>,
) -> Option<String> {
    let result = &method.result;
    let told = |what: &str| Some(format!("{what}: the oracle has {known:?}, not {method:?}"));
    match (result.status, known) {
        (Status::Impossible, Some((_, vector))) => match result.within {
            Some(within) if vector[0] > within => None,
            _ => told("impossible"),
        },
        (Status::Optimal, Some((freed, vector))) => {
            let objective = Objective::new(costs.to_vec()).unwrap();
            let own = result.costs.unwrap().vector(&objective);
            let disturbed = method.retimed.len() + method.rerouted.len();
            if own != vector[..costs.len()] {
                told("costs")
            } else if method.freed.len() != *freed || !method.fewest {
                told("freed")
            } else if *freed == 0 && method.closest && disturbed as u32 != vector[costs.len()] {
                told("disturbed")
            } else if result
                .bounds
                .iter()
                .any(|(&cost, &bound)| result.costs.unwrap().get(cost) != bound)
            {
                told("bounds")
            } else {
                None
            }
        }
        (Status::Impossible, None) | (Status::Unknown | Status::Feasible, _) => None,
        (Status::Optimal, None) => told("optimal"),
    }
}

#[test]
fn the_oracle_agrees() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_CHANGES", 150);
    let methods = [
        (Method::Revise, Held::Path),
        (Method::Tunnel(1), Held::Tunnel(1)),
        (Method::Replan, Held::Nothing),
    ];
    let (mut agreed, mut freed, mut impossible, mut differ) = (0, 0, 0, 0);
    for number in 0.. {
        if agreed + differ >= 3 * count {
            break;
        }
        assert!(number < 100 * count, "too few of them can be compared");
        let instance = random::small(seed, number);
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
        let list = upheaval::changes(&instance, longest as u32 - 1, seed, number);
        let changes = Changes {
            giveway: Version,
            changes: list,
        };
        let asked: Vec<Method> = methods.iter().map(|&(method, _)| method).collect();
        let Some(answer) = go_on(&instance, &plan, &changes, &asked) else {
            continue;
        };
        let costs = costs(&instance);
        let at = answer.at.unwrap();
        let world = Changed::new(&instance, &costs, &plan, at, &changes.changes);
        let Some(mut world) = world else { continue };
        for (method, held) in methods {
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
    assert!(
        freed > 10 && impossible > 5,
        "freed {freed}, impossible {impossible}"
    );
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
