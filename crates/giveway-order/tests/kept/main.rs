//! Orders of random plans, carried out in an independent simulation.
//!
//! `GIVEWAY_RANDOM_ORDERS` says how many plans (300 by default), `GIVEWAY_SEED` the first seed.

#![allow(clippy::unwrap_used, reason = "a test may panic")]
#![allow(
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "times are small, and from 0 on"
)]

mod circular;
mod compare;
mod dress;
#[path = "../messages/mod.rs"]
mod messages;
mod simulate;
mod walks;

use giveway_model::Instance;
use giveway_model::change::History;
use giveway_model::check::check_changes;
use giveway_order::OrderGraph;
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use compare::Tally;
use dress::Case;
use messages::{Schemas, messages};

fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| text.parse().unwrap())
}

/// A random plan that the judge accepts.
fn case(rng: &mut ChaCha8Rng) -> Case {
    loop {
        let case = if rng.random_ratio(1, 30) {
            Some(circular::random(rng))
        } else {
            dress::random(rng)
        };
        let Some(case) = case else {
            continue;
        };
        let Ok(instance) = Instance::new(case.scene.clone()) else {
            continue;
        };
        if check_changes(&instance, &case.changes, &case.plan).is_ok_and(|it| it.is_valid()) {
            return case;
        }
    }
}

#[test]
fn orders_are_safe_and_lateness_is_told_as_it_is() {
    let mut tally = Tally::default();
    let schemas = Schemas::published();
    let first = number("GIVEWAY_SEED", 0);
    for seed in first..first + number("GIVEWAY_RANDOM_ORDERS", 300) {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let case = case(&mut rng);
        let instance = Instance::new(case.scene.clone()).unwrap();
        let history = History::of(&instance, &case.changes, &case.plan).unwrap();
        let simulated = simulate::World::new(&history, &case.changes, &case.plan);
        tally.plans += 1;
        let graph = match OrderGraph::new(&history, &case.changes, &case.plan) {
            Ok(graph) => graph,
            Err(none) => {
                assert!(!none.moves.is_empty(), "seed {seed}");
                assert!(
                    simulated.waits_for_itself(),
                    "seed {seed}: it does not wait"
                );
                tally.none += 1;
                continue;
            }
        };
        let order = graph.order();
        tally.count(&case, &order);
        compare::without_lateness(seed, &case, &simulated, (&graph, &order), &instance);
        compare::released(seed, &order);
        schemas.accept(&messages(&instance, &order));
        for _ in 0..3 {
            compare::stalled(seed, &simulated, &mut rng);
            let late = compare::latenesses(&order, &mut rng);
            let outcome = graph.late(&instance, &late).unwrap();
            compare::late(seed, &case, &simulated, (&order, &outcome), &mut tally);
        }
    }
    println!("{tally:?}");
    tally.has_all();
}
