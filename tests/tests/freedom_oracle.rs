//! What all best plans share, against all of them one by one.
//!
//! `GIVEWAY_RANDOM_FREEDOM` sets of how many random instances (200 by default), and
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_FREEDOM=2000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test freedom_oracle -- --nocapture
//! ```
//!
//! `GIVEWAY_RULE_FREEDOM` sets of how many scenes with rules each test compares the answers.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cost, Instance};
use giveway_tests::freedom::{Compared, Latest, compare, compare_latest, compare_ruled};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use giveway_tests::{environment, random};

#[test]
fn all_best_plans() {
    let count = environment::number("GIVEWAY_RANDOM_FREEDOM", 200);
    let kinds = all(random::small, count);
    let least = count / 50;
    assert!(kinds.iter().all(|&kind| kind >= least), "{kinds:?}");
}

#[test]
fn all_best_plans_of_scenes_with_each_kind_of_rule() {
    ruled("GIVEWAY_RULE_FREEDOM", 140, |number| {
        vec![KINDS[number as usize % KINDS.len()]]
    });
}

#[test]
fn all_best_plans_of_scenes_with_two_kinds_of_rules() {
    ruled("GIVEWAY_RULE_FREEDOM", 98, |number| {
        let number = number as usize;
        let other = number / KINDS.len() + number + 1;
        vec![KINDS[number % KINDS.len()], KINDS[other % KINDS.len()]]
    });
}

#[test]
fn no_best_plan_is_later_than_its_proof_leaves() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let (mut said, mut exact) = (0, 0);
    for number in 0..environment::number("GIVEWAY_RANDOM_FREEDOM", 200) {
        match compare_latest(&random::small(seed, number), None) {
            Latest::TooLarge => {}
            Latest::Agreed {
                said: more,
                exact: same,
            } => {
                said += more;
                exact += same;
            }
            Latest::Differ(fault) => panic!("{number} of seed {seed}: {fault}"),
        }
    }
    println!("{said} latest arrivals, {exact} of them exact");
    assert!(exact > said / 2 && said > 30, "{exact} of {said}");
}

/// Compares the answers about scenes with rules.
fn ruled(variable: &str, usual: u64, kinds: impl Fn(u64) -> Vec<&'static str>) {
    let (seed, count) = (
        environment::number("GIVEWAY_RANDOM_SEED", 1),
        environment::number(variable, usual),
    );
    let (mut agreed, mut differ, mut too_large, mut several) = (0, 0, 0, 0);
    for number in 0..count {
        let kinds = kinds(number);
        let scene = scene_with_rules(seed, number, &kinds);
        let within = (number % 5 == 0).then_some((number % 9) as u32 + 2);
        match compare_ruled(&scene, within) {
            Compared::TooLarge => too_large += 1,
            Compared::Agreed(answer) => {
                agreed += 1;
                let plans = answer.plans.as_ref();
                several += u64::from(plans.is_some_and(|it| it.number.number() > 1));
            }
            Compared::Differ(faults) => {
                differ += 1;
                println!("scene {number} of seed {seed}, {kinds:?}, within {within:?}: {scene}");
                for fault in faults {
                    println!("  {fault}");
                }
            }
        }
    }
    println!(
        "{agreed} agreed, {several} with several plans, {differ} differ, {too_large} were too large"
    );
    assert_eq!(differ, 0, "the scenes and both answers are printed above");
    assert!(agreed >= count / 2 && several >= count / 8);
}

/// Compares the answers about the instances of all numbers; how many were of each kind.
fn all(instance_of: fn(u64, u64) -> Instance, count: u64) -> [u64; 8] {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let (mut agreed, mut differ, mut too_large) = (0, 0, 0);
    let mut kinds = [0; 8];
    for number in 0.. {
        if agreed + differ >= count || too_large > 2 * count + 50 {
            break;
        }
        let instance = instance_of(seed, number);
        let within = (number % 3 == 0).then_some((number % 11) as u32);
        match compare(&instance, within) {
            Compared::TooLarge => too_large += 1,
            Compared::Agreed(answer) => {
                agreed += 1;
                let agents = instance.agents();
                let first = instance.objective().costs().first();
                let in_kind = [
                    answer
                        .plans
                        .as_ref()
                        .is_some_and(|it| it.number.number() > 1),
                    answer.plan.is_some() && agents.iter().any(|a| a.battery.is_some()),
                    answer.plan.is_some() && agents.iter().any(|a| !a.waypoints.is_empty()),
                    answer.plan.is_some() && instance.stays(),
                    answer.plan.is_some() && !instance.stays(),
                    answer.plan.is_some() && agents.len() == 3,
                    answer.plan.is_some() && first == Some(&Cost::SumOfCosts),
                    answer.plan.is_some() && !answer.reach.is_complete(),
                ];
                for (kind, is_in) in kinds.iter_mut().zip(in_kind) {
                    *kind += u64::from(is_in);
                }
            }
            Compared::Differ(faults) => {
                differ += 1;
                let scene = serde_json::to_string(&instance.to_scene()).unwrap();
                println!("instance {number} of seed {seed}, within {within:?}: {scene}");
                for fault in faults {
                    println!("  {fault}");
                }
            }
        }
    }
    println!("{agreed} agreed, {differ} differ, {too_large} were too large; kinds {kinds:?}");
    assert_eq!(differ, 0, "the scenes and both answers are printed above");
    assert!(agreed >= count, "too many are too large for the oracle");
    kinds
}
