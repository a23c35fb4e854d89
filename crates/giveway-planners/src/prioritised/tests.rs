//! Orders that work and orders that do not, on scenes small enough to see why.

use super::{Ended, Order, Outcome, Planned, Stuck, prioritised};
use crate::{
    budget::{Budget, HeldBytes, Stop, Unlimited},
    problem::Problem,
    single::Place,
    tests::instance,
    walk::arrival,
};

fn planned(picture: &str, order: &Order) -> Outcome {
    let problem = Problem::new(&instance(picture), &Unlimited::default()).ok();
    prioritised(&problem.unwrap(), order, 30, true, &Unlimited::default())
}

/// a goes along the corridor from west to east; b has its goal in it.
const CORRIDOR: &str = "
    a . . B A
    # # # b #";

#[test]
fn who_arrives_first_in_the_corridor_blocks_the_other() {
    let stuck = planned(CORRIDOR, &Order::Given(vec![1, 0]));
    let expected = Stuck {
        agent: 0,
        around: vec![1],
    };
    assert_eq!(stuck.ended, Ended::NoOrderWorks(expected.clone()));
    let attempts = stuck.attempts.unwrap();
    assert_eq!(attempts.len(), 1);
    assert_eq!(attempts[0].order, [1, 0]);
    assert_eq!(attempts[0].stuck, Some(expected));
    let b = Planned {
        agent: 1,
        arrival: 1,
        alone: 1,
        around: Vec::new(),
        walk: attempts[0].planned[0].walk.clone(),
    };
    assert_eq!(attempts[0].planned, [b]);
}

/// How far the one that got stuck in the first order came, as columns.
fn came(picture: &str, order: &[usize]) -> Vec<u32> {
    let problem = Problem::new(&instance(picture), &Unlimited::default()).ok();
    let problem = problem.unwrap();
    let order = Order::Given(order.to_vec());
    let outcome = prioritised(&problem, &order, 30, true, &Unlimited::default());
    let furthest = &outcome.attempts.unwrap()[0].furthest;
    let column = |place: &Place| match *place {
        Place::At(v) => problem.terrain.cell(v).x,
        Place::Along(_) => panic!("no slow move"),
    };
    furthest.iter().map(column).collect()
}

#[test]
fn who_is_pushed_into_a_dead_end_lasts_until_there_is_no_cell_left() {
    // b runs to the end of the corridor, ahead of it a, which cannot pass.
    assert_eq!(came("A b . . a . B", &[1, 0]), [4, 5, 6, 6, 6]);
}

#[test]
fn who_can_wait_for_ever_goes_as_near_as_it_can() {
    assert_eq!(came(CORRIDOR, &[1, 0]), [0, 1, 2]);
}

#[test]
fn in_the_other_order_both_arrive() {
    let found = planned(CORRIDOR, &Order::Given(vec![0, 1]));
    assert!(matches!(found.ended, Ended::Found(_)), "{found:?}");
    assert_eq!(found.tried, 1);
}

#[test]
fn who_gets_stuck_moves_to_the_front() {
    let picture = "
        b . . A B
        # # # a #";
    let found = planned(picture, &Order::default());
    assert!(matches!(found.ended, Ended::Found(_)), "{found:?}");
    let orders: Vec<_> = found
        .attempts
        .unwrap()
        .into_iter()
        .map(|a| a.order)
        .collect();
    assert_eq!(orders, [[0, 1], [1, 0]]);
}

#[test]
fn who_goes_around_somebody_says_whom() {
    let picture = "
        . . b .
        a . . A
        . . B .";
    let found = planned(picture, &Order::Given(vec![0, 1]));
    let planned = &found.attempts.unwrap()[0].planned;
    assert_eq!((planned[1].arrival, planned[1].alone), (2, 2));
    let picture = "
        # b #
        a . A
        # B #";
    // Both would be in the middle at time 1.
    let found = self::planned(picture, &Order::Given(vec![0, 1]));
    let planned = &found.attempts.unwrap()[0].planned;
    let late = Planned {
        agent: 1,
        arrival: 3,
        alone: 2,
        around: vec![0],
        walk: planned[1].walk.clone(),
    };
    assert_eq!(arrival(&late.walk), 3);
    assert_eq!(planned[1], late);
}

#[test]
fn where_no_order_works_that_is_all_it_says() {
    // Two that have to pass each other in a corridor.
    let swap = "aB . bA";
    let outcome = planned(swap, &Order::default());
    assert!(
        matches!(outcome.ended, Ended::NoOrderWorks(_)),
        "{outcome:?}"
    );
    // There are but two orders, and each is tried once.
    assert_eq!(outcome.attempts.unwrap().len(), 2);
}

/// A budget that is spent at once.
#[derive(Default)]
struct Spent(HeldBytes);

impl Budget for Spent {
    fn check(&self) -> Result<(), Stop> {
        Err(Stop::Time)
    }

    fn tick(&self) -> Result<(), Stop> {
        Err(Stop::Time)
    }

    fn spend(&self, _states: u64) -> Result<(), Stop> {
        self.check()
    }

    fn held_bytes(&self) -> &HeldBytes {
        &self.0
    }
}

#[test]
fn without_a_budget_it_says_so() {
    let problem = Problem::new(&instance(CORRIDOR), &Unlimited::default()).ok();
    let order = Order::default();
    let outcome = prioritised(&problem.unwrap(), &order, 30, false, &Spent::default());
    assert_eq!(outcome.ended, Ended::Stopped(Stop::Time));
    assert!(outcome.attempts.is_none());
}
