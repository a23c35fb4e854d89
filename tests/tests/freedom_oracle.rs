//! What all best plans share, against all of them one by one.
//!
//! `GIVEWAY_RANDOM_FREEDOM` sets of how many random instances (200 by default), and
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_FREEDOM=2000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test freedom_oracle -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cost, Instance};
use giveway_tests::freedom::{Compared, compare};
use giveway_tests::{environment, random};

#[test]
fn all_best_plans() {
    let count = environment::number("GIVEWAY_RANDOM_FREEDOM", 200);
    let kinds = all(random::small, count);
    let least = count / 50;
    assert!(kinds.iter().all(|&kind| kind >= least), "{kinds:?}");
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
