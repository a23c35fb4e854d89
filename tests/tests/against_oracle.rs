//! The solver, the judge and the oracle on random small instances.
//!
//! `GIVEWAY_RANDOM_INSTANCES` sets how many (300 by default),
//! `GIVEWAY_RANDOM_CERTIFICATES` of how many the answer is certified (100), and
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_INSTANCES=10000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test against_oracle -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Instance, Objective};
use giveway_solve::CertifyRequest;
use giveway_tests::certified::Tally;
use giveway_tests::compare::{self, Comparison};
use giveway_tests::oracle::{Question, Verdict};
use giveway_tests::{ask, environment, random, recount};

/// Compares as many instances as asked for, or a share of them, made by `prepare`
/// from the random instance of a number; `None` passes a number over.
fn compare_all(percent: u64, prepare: impl Fn(u64, Instance) -> Option<(Instance, Comparison)>) {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_INSTANCES", 300);
    let count = (count * percent).div_ceil(100);
    let (mut agreed, mut too_large, mut differ) = (0, 0, 0);
    for number in 0.. {
        if agreed + differ >= count || too_large > count {
            break;
        }
        let Some((instance, comparison)) = prepare(number, random::small(seed, number)) else {
            continue;
        };
        match comparison {
            Comparison::Agreed => agreed += 1,
            Comparison::TooLarge => too_large += 1,
            Comparison::Differ(faults) => {
                differ += 1;
                let scene = serde_json::to_string(&instance.to_scene()).unwrap();
                println!("instance {number} of seed {seed}: {scene}");
                for fault in faults {
                    println!("  {fault}");
                }
            }
        }
    }
    println!("{agreed} agreed, {differ} differ, {too_large} were too large for the oracle");
    assert_eq!(differ, 0, "the scenes and both answers are printed above");
    assert!(
        too_large * 10 <= count,
        "too many instances are too large for the oracle"
    );
}

#[test]
fn the_best_plan() {
    compare_all(100, |_, instance| {
        let comparison = compare::best(&instance, None);
        Some((instance, comparison))
    });
}

/// Agents without a goal may rest at any cell, and stay there under both rules.
#[test]
fn the_best_plan_of_agents_without_goals() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    compare_all(150, |number, instance| {
        let instance = random::goalless(&instance, seed, number);
        let within = (number % 4 == 0).then_some((number % 9) as u32);
        let comparison = compare::best(&instance, within);
        Some((instance, comparison))
    });
}

#[test]
fn pareto_fronts_of_agents_without_goals() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    compare_all(15, |number, instance| {
        let mut costs = instance.objective().costs().to_vec();
        costs.truncate(3);
        if costs.len() < 2 {
            return None;
        }
        let instance = random::goalless(&instance, seed, number);
        let instance = instance.with_objective(Objective::new(costs).unwrap());
        let comparison = compare::front(&instance, None);
        Some((instance, comparison))
    });
}

#[test]
fn the_best_plan_within_a_horizon() {
    compare_all(40, |number, instance| {
        let within = (number % 9) as u32;
        let comparison = compare::best(&instance, Some(within));
        Some((instance, comparison))
    });
}

#[test]
fn pareto_fronts() {
    compare_all(20, |_, instance| {
        let two_or_three: Vec<_> = instance
            .objective()
            .costs()
            .iter()
            .take(3)
            .copied()
            .collect();
        if two_or_three.len() < 2 {
            return None;
        }
        let instance = instance.with_objective(Objective::new(two_or_three).unwrap());
        let comparison = compare::front(&instance, None);
        Some((instance, comparison))
    });
}

#[test]
fn pareto_fronts_within_a_horizon() {
    compare_all(10, |number, instance| {
        let two_or_three: Vec<_> = instance
            .objective()
            .costs()
            .iter()
            .take(3)
            .copied()
            .collect();
        if two_or_three.len() < 2 {
            return None;
        }
        let instance = instance.with_objective(Objective::new(two_or_three).unwrap());
        let comparison = compare::front(&instance, Some((number % 12) as u32));
        Some((instance, comparison))
    });
}

/// The judge was written apart from the oracle: what one finds, the other passes.
#[test]
fn the_judge_passes_the_plans_of_the_oracle() {
    compare_all(100, |_, instance| {
        let question = Question {
            instance: &instance,
            within: None,
            cap: 200_000,
        };
        let comparison = match question.best() {
            Verdict::Impossible => Comparison::Agreed,
            Verdict::Capped => Comparison::TooLarge,
            Verdict::Best(point) => {
                let costs = recount::costs(&point.plan);
                let mut faults = compare::judge(&instance, &point.plan, &costs);
                if costs.vector(instance.objective()) != point.vector {
                    faults.push(format!("the oracle has {:?} for {costs:?}", point.vector));
                }
                if faults.is_empty() {
                    Comparison::Agreed
                } else {
                    faults.push(serde_json::to_string(&point.plan).unwrap());
                    Comparison::Differ(faults)
                }
            }
        };
        Some((instance, comparison))
    });
}

/// Whatever is answered can be shown: each answer is certified, and checked.
fn certify_all(percent: u64, within: impl Fn(u64) -> Option<u32>) -> Tally {
    certify_made(percent, within, |_, instance| instance)
}

/// The same of instances made from the random ones.
fn certify_made(
    percent: u64,
    within: impl Fn(u64) -> Option<u32>,
    make: impl Fn(u64, Instance) -> Instance,
) -> Tally {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_CERTIFICATES", 100);
    let mut tally = Tally::default();
    for number in 0..(count * percent).div_ceil(100) {
        let instance = make(number, random::small(seed, number));
        let answer = ask::best(&instance, within(number));
        let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer);
        let name = format!("instance {number} of seed {seed}");
        tally.add(&name, &instance, &request);
    }
    println!("{:?}", tally.last_lines);
    tally.end();
    tally
}

#[test]
fn every_answer_is_certified() {
    let tally = certify_all(100, |_| None);
    assert!(tally.last_lines.len() >= 2, "{:?}", tally.last_lines);
}

#[test]
fn every_answer_with_agents_without_goals_is_certified() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let within = |number: u64| number.is_multiple_of(3).then_some((number % 9) as u32);
    let make = |number, instance| random::goalless(&instance, seed, number);
    let tally = certify_made(100, within, make);
    assert!(tally.last_lines.contains_key("Proved"));
}

#[test]
fn every_answer_within_a_horizon_is_certified() {
    let tally = certify_all(100, |number| Some((number % 9) as u32));
    assert!(tally.last_lines.contains_key("Proved"));
}
