//! A lesson of one's own that begins as a copy of another one.

use std::rc::Rc;

use giveway_course::author::Action;
use giveway_course::learner;
use giveway_model::tr;
use yew::prelude::*;

use super::super::tutor::Tutor;

impl Tutor {
    /// Begins a lesson of one's own as a copy of the one that is open; there is a way back to what
    /// was written before.
    pub(super) fn adapt(&mut self, ctx: &Context<Self>) {
        let open = self.learner.open.as_ref();
        let (Some(lesson), Some(shelf)) = (open.map(|open| Rc::clone(&open.lesson)), &self.shelf)
        else {
            return;
        };
        let glossary = Rc::clone(shelf);
        self.act(ctx, learner::Action::Close);
        let author = &mut self.author;
        author.open(&glossary.glossary);
        let copy = Action::Open(Box::new((*lesson).clone()));
        author.act(copy, &glossary.glossary);
        author.told = tr!(
            "This is a copy of \u{201c}{title}\u{201d}. What you change is yours.",
            title = lesson.title
        );
    }
}
