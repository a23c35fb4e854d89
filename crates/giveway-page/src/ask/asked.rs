//! Questions that were answered: a report tells them when they are closed, too.

use std::rc::Rc;

use giveway_solve::explain::Part;

use crate::Asking;

/// At most so many are kept: the latest.
const MOST_KEPT: usize = 30;

/// Keeps a question with what is known of it, in the place of what was known of the same question
/// about the same plan.
pub(crate) fn remember(asked: &mut Vec<Rc<Asking>>, asking: &Rc<Asking>) {
    let is_same = |it: &Rc<Asking>| {
        let (one, other) = (&it.about, &asking.about);
        it.question() == asking.question()
            && Rc::ptr_eq(&one.draft, &other.draft)
            && one.plan() == other.plan()
    };
    match asked.iter().position(is_same) {
        Some(place) => asked[place] = Rc::clone(asking),
        None => asked.push(Rc::clone(asking)),
    }
    let more = asked.len().saturating_sub(MOST_KEPT);
    asked.drain(..more);
}

/// Whether a question has its verdict.
pub(crate) fn is_answered(asking: &Asking) -> bool {
    let told = asking.told.as_deref();
    told.is_some_and(|told| !told.pending.contains(&Part::Verdict))
}
