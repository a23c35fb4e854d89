//! The budgets of the many searches of one answer: brief ones, usual ones, and those that are
//! made again with more work.

use std::rc::Rc;

use crate::{Limits, budget::Budget};

/// Clauses that one of many searches may derive.
const DERIVED_EACH: u64 = 8_000;
/// Clauses that one of many searches may write.
const CLAUSES_EACH: u64 = 500_000;
/// Joint steps that it may look at.
const JOINT_STEPS_EACH: u64 = 150_000;
/// Bytes that it may hold: as many as the formula of so many clauses takes.
const HELD_EACH: u64 = 200_000_000;
/// So many times the work of a search, where it is made again.
const AGAIN: u64 = 10;
/// A brief search may derive so small a part of the clauses.
const BRIEFLY: u64 = 5;

/// The budget of one search of many.
pub(crate) fn one_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = CLAUSES_EACH.min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(DERIVED_EACH)
            .with_work(clauses, JOINT_STEPS_EACH)
            .with_held(HELD_EACH),
    )
}

/// The budget of a brief search of many, of which only those are made again that it does not
/// decide.
pub(crate) fn brief_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = CLAUSES_EACH.min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(DERIVED_EACH / BRIEFLY)
            .with_work(clauses, JOINT_STEPS_EACH)
            .with_held(HELD_EACH),
    )
}

/// The budget of a search of many that is made again with more work.
pub(crate) fn further_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = (AGAIN * CLAUSES_EACH).min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(AGAIN * DERIVED_EACH)
            .with_work(clauses, AGAIN * JOINT_STEPS_EACH),
    )
}

/// The budget of a search that may take all that is left.
pub(crate) fn long_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = budget.clauses_left();
    Rc::new(budget.part(Limits::default()).with_clauses(clauses))
}
