//! The search with rules between agents left out.

use std::collections::BTreeMap;
use std::rc::Rc;

use fastrand::Rng;
use giveway_model::{Cost, Instance, Objective};

use crate::{
    Limits, SilentHost, Status,
    budget::Budget,
    explain::ask::{Ask, Found, any, at_most, best},
    joint,
    problem::{Problem, Relaxed},
    search::Proved,
    tests::{instance, random},
};

fn budget() -> Rc<Budget<'static>> {
    Rc::new(Budget::new(&SilentHost, Limits::default()))
}

fn ask<T>(
    instance: &Instance,
    relaxed: &Relaxed,
    objective: &str,
    with: impl FnOnce(&Ask) -> T,
) -> T {
    with(&Ask {
        instance,
        relaxed,
        conditions: &[],
        objective: &objective.parse().unwrap(),
        caps: &BTreeMap::new(),
        within: None,
        at_least_within: 0,
    })
}

fn by_any(instance: &Instance, relaxed: &Relaxed) -> Found {
    ask(instance, relaxed, "makespan", |ask| any(ask, &budget()))
}

#[test]
fn a_corridor_is_free_for_two_that_ignore_each_other() {
    let corridor = instance("aB . bA");
    let found = by_any(&corridor, &Relaxed::default());
    assert_eq!(
        (found.status, found.reach.is_some_and(Proved::is_complete)),
        (Status::Impossible, true)
    );
    let relaxed = Relaxed {
        ignored: [(0, 1)].into(),
        ..Relaxed::default()
    };
    let found = ask(&corridor, &relaxed, "makespan,waits", |ask| {
        best(ask, &budget())
    });
    assert_eq!(found.status, Status::Optimal);
    assert_eq!(found.costs.map(|c| (c.makespan, c.waits)), Some((2, 0)));
}

#[test]
fn one_that_is_gone_blocks_nobody() {
    let passage = instance("a b B A");
    let found = by_any(&passage, &Relaxed::default());
    assert_eq!(
        (found.status, found.reach.is_some_and(Proved::is_complete)),
        (Status::Impossible, true)
    );
    let relaxed = Relaxed {
        gone: [1].into(),
        ..Relaxed::default()
    };
    let found = ask(&passage, &relaxed, "makespan,sum-of-costs", |ask| {
        best(ask, &budget())
    });
    let costs = found.costs.map(|c| (c.makespan, c.sum_of_costs));
    assert_eq!((found.status, costs), (Status::Optimal, Some((3, 4))));
}

#[test]
fn relaxed_optima_are_those_of_the_joint_states() {
    let mut seen = BTreeMap::new();
    for seed in 0..100 {
        let instance = random(seed, 3);
        let mut rng = Rng::with_seed(seed);
        let pairs = [(0, 1), (0, 2), (1, 2)].into_iter();
        let relaxed = Relaxed {
            ignored: pairs.filter(|_| rng.bool()).collect(),
            gone: (0..3).filter(|_| rng.bool()).collect(),
        };
        let found = ask(&instance, &relaxed, "moves", |ask| best(ask, &budget()));
        let any = by_any(&instance, &relaxed);
        let problem = Problem::relaxed(&instance, relaxed.clone(), None, &budget()).ok();
        let all = [0, 1, 2];
        let least = problem.map(|p| joint::least(&p, &all, Cost::Moves, &budget()).unwrap());
        let found = match least {
            None | Some(joint::Exhaustion::None(_)) => {
                assert_eq!(any.status, Status::Impossible, "{seed}");
                (found.status, found.reach.is_some_and(Proved::is_complete))
            }
            Some(joint::Exhaustion::Best(least, _)) => {
                assert_eq!(any.status, Status::Feasible, "{seed}");
                assert!(any.plan.is_some(), "{seed}");
                assert_eq!(found.costs.map(|c| c.moves), Some(least), "{seed}");
                (found.status, true)
            }
            Some(joint::Exhaustion::TooMany) => continue,
        };
        *seen.entry(format!("{found:?}")).or_insert(0) += 1;
    }
    assert_eq!(
        seen.keys().collect::<Vec<_>>(),
        ["(Impossible, true)", "(Optimal, true)"]
    );
    assert!(seen.values().all(|&count| count > 20), "{seen:?}");
}

#[test]
fn at_most_is_met_by_the_optimum_and_by_nothing_less() {
    let objective: Objective = "makespan,sum-of-costs,charges".parse().unwrap();
    let mut missed = 0;
    for seed in 0..150 {
        let instance = random(seed, 3);
        let relaxed = Relaxed::default();
        let costs = "makespan,sum-of-costs,charges";
        let found = ask(&instance, &relaxed, costs, |ask| best(ask, &budget()));
        let Some(optimum) = found.costs else { continue };
        let vector = optimum.vector(&objective);
        let met = ask(&instance, &relaxed, costs, |ask| {
            at_most(ask, vector.clone(), &budget())
        });
        assert_eq!(met.status, Status::Feasible, "{seed}");
        let met = met.costs.map(|c| c.vector(&objective));
        assert_eq!(met, Some(vector.clone()), "{seed}");
        for i in 0..3 {
            let mut less = vector.clone();
            let Some(one) = less[i].checked_sub(1) else {
                continue;
            };
            less[i] = one;
            less[i + 1..].fill(u32::MAX / 4);
            let none = ask(&instance, &relaxed, costs, |ask| {
                at_most(ask, less, &budget())
            });
            assert_eq!(none.status, Status::Impossible, "{seed}");
            assert!(none.reach.is_some_and(Proved::is_complete), "{seed}");
            missed += 1;
        }
    }
    assert!(missed > 70, "{missed}");
}
