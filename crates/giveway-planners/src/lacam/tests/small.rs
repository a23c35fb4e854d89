//! Instances so small that all configurations can be looked at.

use super::{OPTIONS, search};
use crate::{
    lacam::{Ended, Options},
    tests::{least_loss, plain},
};

#[test]
fn it_is_complete_and_in_the_end_loses_the_least() {
    let (mut with, mut without) = (0, 0);
    for seed in 0..800 {
        let size = [[5, 2], [3, 3], [9, 1], [4, 3]][seed as usize % 4];
        let instance = plain(seed, 1 + seed as usize % 3, size, 25);
        let least = least_loss(&instance);
        for guided in [true, false] {
            let Some(report) = search(&instance, Options { guided, ..OPTIONS }) else {
                assert_eq!(least, None);
                continue;
            };
            let found = report.best.map(|best| best.loss);
            let rows = instance.grid().rows();
            assert_eq!(
                found,
                least.map(u64::from),
                "{:?} {rows:#?}",
                instance.agents()
            );
            match report.ended {
                Ended::LeastLoss => with += 1,
                Ended::Exhausted(_) => without += 1,
                other => panic!("{other:?} after {} steps", report.steps),
            }
        }
    }
    assert!(
        with > 700 && without > 60,
        "{with} with a plan, {without} without"
    );
}

#[test]
fn plans_of_many_agents_are_legal() {
    let mut plans = 0;
    for seed in 0..500 {
        let instance = plain(seed, 4 + seed as usize % 20, [7, 6], 15);
        let options = Options {
            step_limit: 3_000,
            guided: seed % 3 > 0,
            first_only: seed % 2 == 0,
            ..OPTIONS
        };
        let report = search(&instance, options);
        plans += usize::from(report.is_some_and(|report| report.best.is_some()));
    }
    assert!(plans > 300, "{plans} plans");
}
