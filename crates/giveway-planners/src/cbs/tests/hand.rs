//! Three constraint trees worked out by hand, a line a node.

use super::{problem, told::told};
use crate::{
    budget::Unlimited,
    cbs::{CbsCost, Ended, search},
};

/// The tree, and the arrivals of the best plan.
fn tree(picture: &str, aim: CbsCost) -> (Vec<String>, Vec<usize>) {
    let problem = problem(picture);
    let outcome = search(&problem, aim, 30, true, &Unlimited::default());
    let Ended::Best { walks, .. } = outcome.ended else {
        panic!("{outcome:?}");
    };
    let arrivals = walks.iter().map(|walk| walk.len() - 1).collect();
    (told(&problem, &outcome.tree.unwrap()), arrivals)
}

#[test]
fn two_that_cross() {
    // Both are in the middle at time 1 on their only shortest walk: whoever gives
    // way waits once. Both children are plans; the newer one is taken.
    let picture = "
        # b #
        a . A
        # B #";
    let (tree, arrivals) = tree(picture, CbsCost::SumOfCosts);
    let expected = [
        "0: root: cost 4, 1 conflicts; turn 0: Cardinal a and b at (1, 1) at 1, bypassed 0",
        "1 < 0: a not at (1, 1) at 1: cost 5, 0 conflicts; open",
        "2 < 0: a at (1, 1) at 1: cost 5, 0 conflicts; best in turn 1, bypassed 0",
    ];
    assert_eq!(tree, expected);
    assert_eq!(arrivals, [2, 3]);
}

#[test]
fn two_that_swap_beside_a_bay() {
    // They meet in the step from 1. Where b gives way (2), a pushes it back to
    // its start and further (3, 4). Where a gives way (1), they meet at (1, 1),
    // unless a is not there at time 2: it then is in the bay, and that is a plan
    // (5). It is one of three walks as short, and the one without a collision.
    let picture = "
        #  . # #
        aB . . bA";
    let (tree, arrivals) = tree(picture, CbsCost::SumOfCosts);
    let expected = [
        "0: root: cost 6, 1 conflicts; \
         turn 0: Cardinal a and b swap (1, 1)-(2, 1) from 1, bypassed 0",
        "1 < 0: a not along (1, 1)-(2, 1) from 1: cost 7, 1 conflicts; \
         turn 2: Cardinal a and b at (1, 1) at 2, bypassed 0",
        "2 < 0: a along (1, 1)-(2, 1) from 1: cost 7, 1 conflicts; \
         turn 1: Cardinal a and b at (2, 1) at 2, bypassed 0",
        "3 < 2: a not at (2, 1) at 2: no walks; dead",
        "4 < 2: a at (2, 1) at 2: cost 8, 1 conflicts; open",
        "5 < 1: a not at (1, 1) at 2: cost 8, 0 conflicts; best in turn 3, bypassed 0",
        "6 < 1: a at (1, 1) at 2: cost 8, 1 conflicts; open",
    ];
    assert_eq!(tree, expected);
    assert_eq!(arrivals, [5, 3]);
}

#[test]
fn one_that_rests_in_the_way() {
    // a would rest at (2, 0) from time 1, and b comes by at 2. Either a arrives
    // after that, or b goes around, which takes four steps more.
    let picture = "
        b . A . B
        . # a # .
        . . . . .";
    let (tree, arrivals) = tree(picture, CbsCost::SumOfCosts);
    let expected = [
        "0: root: cost 5, 1 conflicts; \
         turn 0: Cardinal b comes to resting a at (2, 0) at 2, bypassed 0",
        "1 < 0: a arrives after 2: cost 7, 0 conflicts; best in turn 1, bypassed 0",
        "2 < 0: a arrives by 2: cost 9, 0 conflicts; open",
    ];
    assert_eq!(tree, expected);
    assert_eq!(arrivals, [3, 4]);
}

#[test]
fn nobody_rests_in_the_way_where_all_vanish() {
    let picture = "
        b . A . B
        . # a # .
        . . . . .
        vanish";
    let (tree, arrivals) = tree(picture, CbsCost::SumOfCosts);
    let expected = ["0: root: cost 5, 0 conflicts; best in turn 0, bypassed 0"];
    assert_eq!(tree, expected);
    assert_eq!(arrivals, [1, 4]);
}

#[test]
fn in_a_slow_zone_they_meet_in_each_step_in_which_both_are_along() {
    // a is along the slow edge in the steps from 1 and 2, and so is b. Both are
    // conflicts, and the first is split: either a, or b, gets out of the way.
    let picture = "
        #  . # #
        aB ~ ~ bA";
    let (tree, arrivals) = tree(picture, CbsCost::SumOfCosts);
    let root = "0: root: cost 8, 2 conflicts; \
                turn 0: Cardinal a and b swap (1, 1)-(2, 1) from 1, bypassed 0";
    assert_eq!(tree[0], root);
    // b comes by at 3, while a is in the bay; a then needs four steps more.
    assert_eq!(arrivals, [7, 4]);
}
