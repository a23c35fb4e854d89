//! Bounds by counting, on scenes whose optima are told by hand.

use giveway_model::{Cost, Instance};

use super::{Bottlenecks, Gate};
use crate::{budget::Unlimited, problem::Problem, tests::instance};

/// The bounds of makespan and sum of costs, and the cells of the passage that shows the first.
fn bounds(instance: &Instance) -> (Option<u32>, Option<u32>, usize) {
    let budget = Unlimited::default();
    let Ok(problem) = Problem::new(instance, &budget) else {
        panic!("each agent has a way");
    };
    let bottlenecks = Bottlenecks::of(&problem, 2, &budget).unwrap();
    let makespan = bottlenecks.bound(&problem, Cost::Makespan, None);
    let cells = makespan.map_or(0, |counted| match counted.bottleneck.gate() {
        Gate::Passage(cells) => cells.len(),
        Gate::Zone { .. } => 0,
    });
    let sum = bottlenecks.bound(&problem, Cost::SumOfCosts, None);
    let at_least = |counted: Option<super::Counted<'_>>| counted.map(|counted| counted.at_least);
    (at_least(makespan), at_least(sum), cells)
}

#[test]
fn agents_that_go_the_same_way_pass_one_after_the_other() {
    let queue = instance(
        "a . # . A
         b . . . B
         c . # . C",
    );
    // They are in the gap at times 2, 3 and 4, b with two steps to go then, a and c with three.
    assert_eq!(
        bounds(&queue),
        (Some(4 + 3), Some(2 + 2 + 3 + 3 + 4 + 3), 1)
    );
}

#[test]
fn agents_that_change_sides_have_to_let_each_other_out() {
    let swap = instance(
        "a . # . b
         . . . . .
         B . # . A",
    );
    let (makespan, _, cells) = bounds(&swap);
    // At the gap at times 3 and 6, and three steps more.
    assert_eq!((makespan, cells), (Some(9), 1));
}

#[test]
fn a_longer_passage_is_entered_when_who_comes_has_left_it() {
    let swap = instance(
        "a . # # # . b
         . . . . . . .
         B . # # # . A",
    );
    let (makespan, _, cells) = bounds(&swap);
    // The first enters it at time 3, the second five steps later, and needs five more.
    assert_eq!((makespan, cells), (Some(13), 3));
}

#[test]
fn a_map_without_passages_has_no_bottlenecks() {
    let open = instance(
        "a . . B
         b . . A
         c . . C",
    );
    assert_eq!(bounds(&open), (None, None, 0));
}
