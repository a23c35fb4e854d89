//! What the course fetches, and what is opened once it is there.

use std::rc::Rc;

use giveway_course::learner::{Action, Onward};
use giveway_course::lesson::Lesson;
use giveway_model::tr;
use yew::platform::spawn_local;
use yew::prelude::*;

use super::contents::Page;
use super::language;
use super::place::{Place, Wanted};
use super::shelf::Shelf;
use super::tutor::{Msg, Tutor};

/// A link names a lesson that there is not: the contents show those that there are.
pub(super) fn no_lesson(name: &str) -> String {
    tr!(
        "There is no lesson named {name} here. The link may be damaged; these are the lessons.",
        name
    )
}

impl Tutor {
    /// Fetches index and glossary, where they are neither there nor on their way.
    pub(super) fn fetch(&mut self, ctx: &Context<Self>) {
        if self.fetched.is_some() || self.is_fetching {
            return;
        }
        self.is_fetching = true;
        let link = ctx.link().clone();
        spawn_local(async move {
            let shelf = Shelf::fetch().await;
            link.send_message(Msg::Shelved(shelf.map(Rc::new)));
        });
    }

    /// Shows a page of the contents, or closes them.
    pub(super) fn show(&mut self, page: Option<Page>) {
        if self.page.is_none() {
            self.forget_removed();
        }
        self.page = page;
        self.missing = None;
        if page.is_some() {
            self.read_own();
        }
    }

    /// Index and glossary are there, or are not.
    pub(super) fn shelved(&mut self, ctx: &Context<Self>, shelf: Result<Rc<Shelf>, String>) {
        self.is_fetching = false;
        match shelf {
            Ok(shelf) => {
                self.fetched = Some(shelf);
                // Nobody is to read English first.
                if !language::is_coming() {
                    self.reword(ctx);
                }
                self.arrive_late(ctx);
                self.class_late(ctx);
                self.read_own();
            }
            Err(sentence) => self.miss(sentence),
        }
    }

    /// A lesson is there, or is not.
    pub(super) fn fetched(
        &mut self,
        ctx: &Context<Self>,
        place: Place,
        lesson: Result<Rc<Lesson>, String>,
    ) {
        match lesson {
            Ok(lesson) => {
                self.lessons.insert(place.lesson.clone(), lesson);
                if self.wanted == Some(Wanted::Place(place.clone())) {
                    self.enter(ctx, place);
                }
            }
            Err(sentence) => {
                self.wanted = None;
                self.miss(sentence);
            }
        }
    }

    /// Something did not arrive. A tour needs nothing of it.
    fn miss(&mut self, sentence: String) {
        if self.tour.is_none() {
            self.missing = Some(sentence);
            self.page = Some(Page::Lessons);
        }
    }

    /// Opens the lesson that comes next, as soon as the index is there.
    pub(super) fn begin(&mut self, ctx: &Context<Self>) {
        let Some(shelf) = self.shelf.clone() else {
            self.warm();
            self.missing = None;
            self.wanted = Some(Wanted::Next);
            return self.fetch(ctx);
        };
        match Onward::of(&shelf.course, &self.learner.progress) {
            Some(next) => {
                let lesson = next.entry().lesson.clone();
                self.enter(ctx, Place { lesson, step: None });
            }
            None => self.show(Some(Page::Lessons)),
        }
    }

    /// Opens a place, as soon as what it takes is there.
    pub(super) fn enter(&mut self, ctx: &Context<Self>, place: Place) {
        self.warm();
        self.missing = None;
        let Some(shelf) = self.shelf.clone() else {
            self.wanted = Some(Wanted::Place(place));
            return self.fetch(ctx);
        };
        if place.lesson.is_own()
            && let Some(lesson) = self.own(&place.lesson)
        {
            self.begin_lesson();
            return self.open_own(ctx, lesson, place.step);
        }
        if shelf.entry(&place.lesson).is_none() {
            self.show(Some(Page::Lessons));
            self.missing = Some(no_lesson(&place.lesson.to_string()));
            return;
        }
        if let Some(lesson) = self.lessons.get(&place.lesson) {
            let action = Action::Open {
                id: place.lesson,
                lesson: Rc::new(language::said(&**lesson)),
                at: place.step,
            };
            self.begin_lesson();
            return self.act(ctx, action);
        }
        self.wanted = Some(Wanted::Place(place.clone()));
        let link = ctx.link().clone();
        spawn_local(async move {
            let lesson = shelf.lesson(&place.lesson).await;
            link.send_message(Msg::Fetched(place, lesson.map(Rc::new)));
        });
    }

    /// A lesson opens: nothing else is wanted, and the contents close.
    fn begin_lesson(&mut self) {
        self.wanted = None;
        self.page = None;
    }
}
