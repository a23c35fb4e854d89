//! Plans get calmer, stay plans, and cost what they cost before.

use giveway_model::{Cell, Cost, Costs, Instance, Objective, Plan, check::check};

use super::{Driving, calm};
use crate::{
    budget::Unlimited,
    first::first_plan,
    local::apart,
    problem::Problem,
    tests::{instance, random},
    walk::{Walk, to_plan, walks_of_plan},
};

fn objective(costs: &[Cost]) -> Objective {
    Objective::new(costs.to_vec()).unwrap()
}

fn names(instance: &Instance) -> Vec<String> {
    let agents = instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}

fn problem(instance: &Instance) -> Problem {
    Problem::new(instance, &Unlimited::default()).ok().unwrap()
}

/// The costs by the judge, which must find nothing wrong.
fn judged(instance: &Instance, problem: &Problem, walks: &[Walk]) -> Costs {
    let report = check(instance, &to_plan(problem, &names(instance), walks));
    assert!(report.violations.is_empty(), "{:?}", report.violations);
    report.costs.unwrap()
}

/// Walks of paths with a text for each agent: cells as `xy`, `--` half way along a slow arc.
fn walks(instance: &Instance, problem: &Problem, paths: &[&str]) -> Vec<Walk> {
    let mut plan = Plan::default();
    for (name, path) in names(instance).into_iter().zip(paths) {
        let cell = |text: &str| {
            let number: u32 = text.parse().ok()?;
            Some(Cell::new(number / 10, number % 10))
        };
        plan.paths.insert(name, path.split(' ').map(cell).collect());
    }
    walks_of_plan(problem, &names(instance), &plan).unwrap()
}

/// A calmed plan in the place of the paths; no cost of the objective is higher.
struct Calmed {
    before: Driving,
    after: Driving,
    walks: Vec<Walk>,
    expected: Vec<Walk>,
}

/// Calms paths; the expected ones are those of the calmest plan.
fn calmed(picture: &str, costs: &[Cost], paths: &[&str], expected: &[&str]) -> Calmed {
    let instance = instance(picture);
    let problem = problem(&instance);
    let (objective, before) = (objective(costs), walks(&instance, &problem, paths));
    let old = judged(&instance, &problem, &before);
    let after = calm(&problem, &before, &objective, |_| true);
    let new = judged(&instance, &problem, &after);
    for &cost in costs {
        assert!(new.get(cost) <= old.get(cost), "{cost:?}");
    }
    Calmed {
        before: Driving::of_all(&problem, &before),
        after: Driving::of_all(&problem, &after),
        walks: after,
        expected: walks(&instance, &problem, expected),
    }
}

const DEFAULT: [Cost; 3] = [Cost::Makespan, Cost::SumOfCosts, Cost::Charges];

#[test]
fn driving_counts_motion_waits_and_turns() {
    let instance = instance("a . ~ A");
    let problem = problem(&instance);
    let of = |path: &str| Driving::of(&problem, &walks(&instance, &problem, &[path])[0]);
    let there = of("00 10 -- 20 -- 30");
    assert_eq!((there.motion, there.waits, there.turns), (5, 0, 0));
    let and_back = of("00 10 10 00 00 10 -- 20 -- 30");
    assert_eq!((and_back.motion, and_back.waits, and_back.turns), (7, 2, 2));
    let (early, late) = (of("00 00 10 -- 20 -- 30"), of("00 10 10 -- 20 -- 30"));
    assert!(late < early);
}

#[test]
fn an_agent_waits_in_a_bay_instead_of_driving_ahead_and_back() {
    let calmed = calmed(
        "#   .   #   #   #   #   #   #
         aB  .   .   .   .   .   .   bA",
        &DEFAULT,
        &[
            "01 11 21 31 21 11 10 11 21 31 41 51 61 71",
            "71 61 51 41 31 21 11 01",
        ],
        &[
            "01 11 10 10 10 10 10 11 21 31 41 51 61 71",
            "71 61 51 41 31 21 11 01",
        ],
    );
    assert_eq!((calmed.before.motion, calmed.after.motion), (20, 16));
    assert_eq!(calmed.walks, calmed.expected);
}

#[test]
fn agents_that_flee_from_each_other_both_get_calm() {
    let calmed = calmed(
        "a   .   .   A
         .   .   .   .
         b   .   .   B",
        &[Cost::Makespan],
        &["00 00 00 01 00 10 20 30", "02 01 11 10 20 21 22 32"],
        &["00 10 20 30", "02 12 22 32"],
    );
    assert_eq!(calmed.walks, calmed.expected);
}

#[test]
fn a_slow_move_counts_two() {
    let calmed = calmed(
        "a   ~   ~   ~   ~   A
         .   .   .   .   .   .",
        &[Cost::Makespan],
        &["00 10 -- 20 -- 30 -- 40 50"],
        &["00 10 11 21 31 41 40 50"],
    );
    assert_eq!((calmed.before.motion, calmed.after.motion), (8, 7));
    assert_eq!(calmed.walks, calmed.expected);
}

#[test]
fn waypoints_are_visited_and_batteries_charged() {
    let visits = calmed(
        "a   .   A
         #   a!  #",
        &[Cost::Makespan],
        &["00 10 00 10 11 10 20"],
        &["00 10 11 10 20"],
    );
    assert_eq!(visits.walks, visits.expected);
    // The charger is off the shortest way, and the battery does not last without it.
    let charges = calmed(
        "a   .   .   .   A
         #   +   #   #   #
         battery a 3/5",
        &[Cost::Charges, Cost::Makespan],
        &["00 10 11 10 20 10 20 30 40"],
        &["00 10 11 10 20 30 40"],
    );
    assert_eq!(charges.walks, charges.expected);
}

#[test]
fn an_agent_that_vanishes_gives_its_goal_free() {
    let calmed = calmed(
        "b   .   A   .   B
         #   #   a   #   #
         vanish",
        &[Cost::Makespan],
        &["21 20", "00 10 00 10 20 30 40"],
        &["21 20", "00 10 20 30 40"],
    );
    assert_eq!(calmed.walks, calmed.expected);
}

#[test]
fn waits_are_as_late_as_they_can_be() {
    let calmed = calmed(
        "#   #   b   #
         #   #   .   #
         a   .   .   A
         #   #   B   #",
        &DEFAULT,
        &["02 02 12 22 32", "20 21 22 23"],
        &["02 12 12 22 32", "20 21 22 23"],
    );
    assert_eq!(calmed.walks, calmed.expected);
}

#[test]
fn agents_that_may_not_change_keep_their_walks() {
    let instance = instance("a . A\n b . B");
    let problem = problem(&instance);
    let before = walks(&instance, &problem, &["00 10 00 10 20", "01 11 01 11 21"]);
    let after = calm(&problem, &before, &objective(&[Cost::Makespan]), |agent| {
        agent == 1
    });
    assert_eq!((&after[0], after[1].len()), (&before[0], 3));
}

#[test]
fn random_plans_get_calmer_and_no_worse_and_stay_plans() {
    let (mut plans, mut calmer) = (0, 0);
    for seed in 0..800 {
        let instance = random(seed, 2 + seed as usize % 4);
        let budget = Unlimited::default();
        let Ok(problem) = Problem::new(&instance, &budget) else {
            continue;
        };
        let apart = apart(&problem, &budget).unwrap();
        let Some((before, _)) = first_plan(&problem, apart, 60, &budget).unwrap() else {
            continue;
        };
        let first = [
            Cost::Makespan,
            Cost::SumOfCosts,
            Cost::Moves,
            Cost::Waits,
            Cost::Charges,
        ];
        let first = first[seed as usize % first.len()];
        let last = [Cost::Makespan, Cost::Charges, Cost::Waits][seed as usize % 3];
        let costs: &[Cost] = if first == last {
            &[first]
        } else {
            &[first, last]
        };
        let objective = objective(costs);
        let after = calm(&problem, &before, &objective, |_| true);
        let (old, new) = (
            judged(&instance, &problem, &before),
            judged(&instance, &problem, &after),
        );
        assert!(
            costs.iter().all(|&cost| new.get(cost) <= old.get(cost)),
            "seed {seed}"
        );
        let driving = |walks: &[Walk]| Driving::of_all(&problem, walks);
        assert!(driving(&after) <= driving(&before), "seed {seed}");
        assert_eq!(
            after,
            calm(&problem, &before, &objective, |_| true),
            "seed {seed}"
        );
        plans += 1;
        calmer += u32::from(driving(&after) < driving(&before));
    }
    assert!(plans > 200 && calmer > 50, "{plans} plans, {calmer} calmer");
}
