//! Plans made better stay plans, and become no worse, whatever agents have to do.

use giveway_model::{Cost, Costs, Instance, Objective, check::check};

use super::{Effort, Lns, descend};
use crate::{
    budget::Unlimited,
    first::first_plan,
    local::{OtherAgents, Query, Reservations, apart},
    problem::Problem,
    tests::random,
    walk::{Walk, arrival, to_plan},
};

const EFFORT: Effort = Effort {
    states: 3_000,
    horizon: 60,
    enough: 0,
};

/// The costs by the judge, which must find nothing wrong.
fn judged(instance: &Instance, problem: &Problem, walks: &[Walk]) -> Costs {
    let agents = instance.agents().iter();
    let names: Vec<String> = agents.map(|agent| agent.name.clone()).collect();
    let report = check(instance, &to_plan(problem, &names, walks));
    assert!(report.violations.is_empty(), "{:?}", report.violations);
    report.costs.unwrap()
}

/// A first plan of a random instance.
fn planned(seed: u64) -> Option<(Instance, Problem, Vec<Walk>)> {
    planned_for(2 + seed as usize % 4, seed)
}

/// A first plan of a random instance with so many agents.
fn planned_for(agents: usize, seed: u64) -> Option<(Instance, Problem, Vec<Walk>)> {
    let instance = random(seed, agents);
    let budget = Unlimited::default();
    let problem = Problem::new(&instance, &budget).ok()?;
    let apart = apart(&problem, &budget).unwrap();
    let (walks, _) = first_plan(&problem, apart, EFFORT.horizon, &budget).unwrap()?;
    Some((instance, problem, walks))
}

fn improved(problem: &Problem, walks: &[Walk], objective: &Objective) -> Vec<Walk> {
    let mut walks = walks.to_vec();
    let budget = Unlimited::default();
    let mut lns = Lns::default();
    lns.improve(problem, &mut walks, EFFORT, objective, &budget)
        .unwrap();
    walks
}

#[test]
fn a_plan_becomes_no_worse_and_stays_a_plan() {
    let (mut plans, mut better) = (0, 0);
    for seed in 0..1_500 {
        let Some((instance, problem, walks)) = planned(seed) else {
            continue;
        };
        let costs = [Cost::SumOfCosts, Cost::Makespan, Cost::Moves];
        let first = costs[seed as usize % 3];
        let objective = Objective::new(vec![first, Cost::Waits]).unwrap();
        let before = judged(&instance, &problem, &walks).vector(&objective);
        let walks = improved(&problem, &walks, &objective);
        let after = judged(&instance, &problem, &walks).vector(&objective);
        assert!(after <= before, "{after:?} after {before:?}, seed {seed}");
        plans += 1;
        better += usize::from(after < before);
    }
    assert!(plans > 300 && better > 30, "{plans}, {better}");
}

#[test]
fn the_same_plan_is_made_twice() {
    for seed in 2_000..2_100 {
        let Some((_, problem, walks)) = planned(seed) else {
            continue;
        };
        let objective = Objective::new(vec![Cost::SumOfCosts]).unwrap();
        let twice = [0, 1].map(|_| improved(&problem, &walks, &objective));
        assert_eq!(twice[0], twice[1], "seed {seed}");
    }
}

#[test]
fn what_is_good_enough_is_left_alone() {
    let Some((_, problem, walks)) = (0..).find_map(planned) else {
        return;
    };
    let objective = Objective::new(vec![Cost::SumOfCosts]).unwrap();
    let mut same = walks.clone();
    let effort = Effort {
        enough: u32::MAX,
        ..EFFORT
    };
    let budget = Unlimited::default();
    let better = Lns::default().improve(&problem, &mut same, effort, &objective, &budget);
    assert!(!better.unwrap());
    assert_eq!(same, walks);
}

#[test]
fn after_the_descent_nobody_alone_could_arrive_sooner() {
    let budget = Unlimited::default();
    let objective = Objective::new(vec![Cost::SumOfCosts]).unwrap();
    let (mut plans, mut better) = (0, 0);
    for seed in 3_000..5_000 {
        let Some((instance, problem, mut walks)) = planned_for(6, seed) else {
            continue;
        };
        let before = judged(&instance, &problem, &walks).sum_of_costs;
        let gained = descend(&problem, &mut walks, &objective, u64::MAX, &budget);
        let after = judged(&instance, &problem, &walks).sum_of_costs;
        assert_eq!(gained, after < before, "seed {seed}");
        for (agent, walk) in walks.iter().enumerate() {
            let mut others = Reservations::of(&problem, &walks);
            others.remove(agent, walk);
            let query = Query {
                agent,
                latest: EFFORT.horizon,
                conflict_penalty: None,
                expansion_limit: 20_000,
            };
            let (sooner, _) = others.plan(query, &budget).unwrap().unwrap();
            assert!(arrival(&sooner) >= arrival(walk), "{agent}, seed {seed}");
        }
        plans += 1;
        better += usize::from(gained);
    }
    assert!(plans > 200 && better > 3, "{plans}, {better}");
}

#[test]
fn a_descent_within_few_states_leaves_a_plan() {
    let budget = Unlimited::default();
    let objective = Objective::new(vec![Cost::SumOfCosts]).unwrap();
    for seed in 3_000..3_200 {
        let Some((instance, problem, mut walks)) = planned(seed) else {
            continue;
        };
        let before = judged(&instance, &problem, &walks).sum_of_costs;
        descend(&problem, &mut walks, &objective, seed % 40, &budget);
        assert!(judged(&instance, &problem, &walks).sum_of_costs <= before);
    }
}
