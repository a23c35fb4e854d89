//! A better plan that a question found: it is kept when the question is left.

use std::rc::Rc;

use giveway_model::tr;

use super::Asking;
use crate::{Answer, State, words};

/// A better plan, and the one that it is better than.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Found {
    about: Rc<Answer>,
    better: Rc<Answer>,
}

impl Asking {
    /// The best other plan that is known, where it costs less than the one asked about.
    pub(crate) fn better(&self) -> Option<Found> {
        let better = self.best_other(self.told.as_deref()?)?;
        self.costs_less(&better, &self.about).then(|| Found {
            about: Rc::clone(&self.about),
            better,
        })
    }

    /// What is kept of this question and those before it: the better one of both.
    pub(crate) fn kept(&self, before: Option<Found>) -> Option<Found> {
        let before = before.filter(|it| Rc::ptr_eq(&it.about, &self.about));
        match (self.better(), before) {
            (Some(now), Some(before)) if !self.costs_less(&now.better, &before.better) => {
                Some(before)
            }
            (Some(now), _) => Some(now),
            (None, before) => before,
        }
    }
}

impl State {
    /// The better plan that a question about the plan on the board found, where neither was left.
    pub(crate) fn found_better(&self) -> Option<&Rc<Answer>> {
        let found = self.view.found.as_ref()?;
        let shown = self.document.fresh_answer()?;
        Rc::ptr_eq(shown, &found.about).then_some(&found.better)
    }
}

/// What a question found that is better than the plan on the board: its costs, in a sentence.
#[inline(never)]
pub fn found_better(state: &State) -> Option<String> {
    let better = state.found_better()?;
    let objective = &better.draft.scene().objective;
    let costs = words::values(objective, &better.solved.costs?);
    Some(tr!("A question found a better plan: {costs}.", costs))
}
