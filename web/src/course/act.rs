//! What a learner does, and what must be done outside of the reducer then.

use giveway_course::learner::{Action, Effect, Judge, Open, reduce};
use giveway_course::lesson::Id;
use giveway_course::port::ToPage;
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use super::address;
use super::contents::Page;
use super::sight::focus;
use super::tutor::{Msg, Tutor};

/// How long the judge may look before that is said, in milliseconds.
const LATE_MS: u32 = 300;

impl Tutor {
    /// Sees to it that the solver is there when the first task is judged.
    pub(super) fn warm(&self) {
        self.asker.warm();
    }

    /// Says something to the page.
    pub(super) fn say(&self, message: &ToPage) {
        if let Some(line) = &self.line {
            line.say(message);
        }
    }

    /// Nothing but the lesson is shown, or what comes over it.
    pub(super) fn close_contents(&mut self) {
        self.page = None;
        self.missing = None;
    }

    pub(super) fn act(&mut self, ctx: &Context<Self>, action: Action) {
        if let Action::Open { .. } | Action::Try { .. } = action {
            // The lesson takes the place of the tour on the board.
            self.tour = None;
        }
        // What another tab has kept comes first: this may come to it.
        self.read_kept();
        let was_tried = self.learner.open.as_ref().is_some_and(Open::is_tried);
        let is_next = action == Action::Next;
        let is_left_there = matches!(action, Action::Page(_));
        let was = self.step();
        let said = self.learner.open.as_ref().map(|open| open.judge().clone());
        let (learner, effects) = reduce(std::mem::take(&mut self.learner), action);
        self.learner = learner;
        if let Some(Judge::Said(verdict)) = &said {
            self.before = Some(verdict.clone());
        }
        let now = self.learner.open.as_ref().map(|open| open.judge().clone());
        let has_said = now != said && matches!(now, Some(Judge::Said(_)));
        self.has_said |= has_said;
        if let Some(open) = &self.learner.open
            && has_said
        {
            self.author.tried(open);
        }
        let is = self.step();
        if is != was {
            self.put_away();
            self.order.clear();
            self.typed.clear();
            self.before = None;
            self.is_new = is.is_some();
            self.has_said = false;
            if is.is_none() {
                self.sheet = None;
            }
            // After the last step there is the next lesson to choose.
            if is.is_none() && was_tried && !is_left_there {
                self.author.back();
            } else if is.is_none() && is_next {
                self.show(Some(Page::Lessons));
            }
        }
        self.watch(ctx);
        for effect in effects {
            self.effect(effect);
        }
        if is != was {
            address::show(self.learner.open.as_ref());
        }
        if is.is_some() != was.is_some() {
            self.tell_lesson(is.is_some());
        }
    }

    /// Tells the page whether a lesson is open.
    pub(super) fn tell_lesson(&self, is_open: bool) {
        if let Some(line) = &self.line {
            line.tell_state(is_open);
        }
    }

    pub(super) fn effect(&mut self, effect: Effect) {
        match effect {
            Effect::Ask { number, request } => self.asker.ask(number, *request),
            Effect::Forget => self.asker.forget(),
            Effect::Page(message) => self.say(&message),
            Effect::Keep(_) => self.keep(),
            Effect::FocusNext => focus(&self.next),
        }
    }

    /// Says that the judge looks only where that takes long.
    fn watch(&mut self, ctx: &Context<Self>) {
        let judge = self.learner.open.as_ref().map(Open::judge);
        if matches!(judge, Some(Judge::Looking(_))) {
            if self.late.is_none() {
                let link = ctx.link().clone();
                let late = Timeout::new(LATE_MS, move || link.send_message(Msg::Late));
                self.late = Some(late);
            }
        } else {
            self.late = None;
            self.is_late = false;
        }
    }

    /// The lesson that is open, and its step.
    fn step(&self) -> Option<(Id, usize)> {
        let open = self.learner.open.as_ref()?;
        Some((open.id.clone(), open.index()))
    }
}
