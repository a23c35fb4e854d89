//! The course turns to another language, with the lesson that is open.

use std::rc::Rc;

use giveway_course::learner::Action;
use yew::platform::spawn_local;
use yew::prelude::*;

use super::language;
use super::place::Wanted;
use super::tutor::{Msg, Tutor};

impl Tutor {
    /// Turns to the language that the page told.
    pub(super) fn turn(ctx: &Context<Self>, told: String) {
        let link = ctx.link().clone();
        spawn_local(async move {
            if language::hear(told).await {
                link.send_message(Msg::Spoken);
            }
        });
    }

    /// Puts all into the words of the language that is spoken, and opens what waited.
    pub(super) fn reword(&mut self, ctx: &Context<Self>) {
        self.shelf = self.fetched.as_ref().map(|shelf| Rc::new(shelf.said()));
        let open = self.learner.open.as_ref().map(|open| open.id.clone());
        if let Some(id) = open
            && let Some(lesson) = self.lessons.get(&id)
        {
            let lesson = Rc::new(language::said(&**lesson));
            self.act(ctx, Action::Reword { id, lesson });
        }
        self.reword_class();
        if self.shelf.is_some()
            && let Some(wanted) = self.wanted.take()
        {
            match wanted {
                Wanted::Place(place) => self.enter(ctx, place),
                Wanted::Next => self.begin(ctx),
            }
        }
    }
}
