//! Lessons that came as a file or in a link: the browser keeps the last of them, and the
//! contents show them.

use std::rc::Rc;

use giveway_course::learner::{Action, Progress};
use giveway_course::lesson::{Entry, Id, Lesson, OwnLessons};
use giveway_model::tr;
use yew::prelude::*;

use super::card::Card;
use super::tutor::{Msg, Tutor};
use crate::board::Film;
use crate::course::card::CardProps;
use crate::part::part;
use crate::{icon, keep};

/// Under which name they are kept.
const NAME: &str = "lessons";

/// Lessons that came as a file or in a link.
#[derive(Clone, Default)]
pub(super) struct Own {
    /// What the browser keeps, as it was read last.
    text: String,
    lessons: Rc<[Listed]>,
    /// The one that was removed last.
    removed: Option<Rc<Lesson>>,
}

/// A lesson that is kept, as the contents list it.
struct Listed {
    lesson: Rc<Lesson>,
    entry: Entry,
    film: Option<Rc<Film>>,
}

impl PartialEq for Own {
    fn eq(&self, other: &Self) -> bool {
        let removed = |own: &Self| own.removed.as_ref().map(Rc::as_ptr);
        Rc::ptr_eq(&self.lessons, &other.lessons) && removed(self) == removed(other)
    }
}

impl Tutor {
    /// Reads what is kept, where another tab has changed it.
    pub(super) fn read_own(&mut self) {
        let text = keep::load(NAME).unwrap_or_default();
        let Some(shelf) = self.shelf.as_ref().filter(|_| text != self.own.text) else {
            return;
        };
        let kept = |lesson: Lesson| {
            let entry = lesson.entry(lesson.own_id())?;
            Some(Listed {
                film: Film::of(&entry.picture),
                lesson: Rc::new(lesson),
                entry,
            })
        };
        let lessons = OwnLessons::read(&text).lessons(&shelf.glossary);
        self.own.lessons = lessons.into_iter().filter_map(kept).collect();
        self.own.text = text;
    }

    /// Changes what is kept. Where the browser keeps nothing more, all stays as it is.
    fn change_own(&mut self, change: impl FnOnce(&mut OwnLessons)) {
        let text = keep::load(NAME).unwrap_or_default();
        let mut own = OwnLessons::read(&text);
        change(&mut own);
        let _ = keep::store(NAME, &own.write());
        self.read_own();
    }

    /// Opens a lesson, and keeps it.
    pub(super) fn open_own(&mut self, ctx: &Context<Self>, lesson: Rc<Lesson>, at: Option<usize>) {
        self.warm();
        self.change_own(|own| own.add(&lesson));
        let id = lesson.own_id();
        self.act(ctx, Action::Open { id, lesson, at });
    }

    /// The lesson of this name, if it is kept.
    pub(super) fn own(&mut self, id: &Id) -> Option<Rc<Lesson>> {
        self.read_own();
        let mut lessons = self.own.lessons.iter();
        let kept = lessons.find(|kept| kept.entry.lesson == *id)?;
        Some(Rc::clone(&kept.lesson))
    }

    /// A lesson is kept no longer; the last one can come back.
    pub(super) fn remove_own(&mut self, id: &Id) {
        self.own.removed = self.own(id);
        self.change_own(|own| own.remove(id));
    }

    /// The lesson that was removed last is kept again.
    pub(super) fn bring_back(&mut self) {
        if let Some(lesson) = self.own.removed.take() {
            self.change_own(|own| own.add(&lesson));
        }
    }

    /// What was removed before the contents were opened does not come back.
    pub(super) fn forget_removed(&mut self) {
        self.own.removed = None;
    }
}

/// Their part of the contents; nothing where there are none.
pub(super) fn show(own: &Own, progress: &Progress, send: &Callback<Msg>) -> Html {
    if own.lessons.is_empty() && own.removed.is_none() {
        return html! {};
    }
    let card = |kept: &Listed| {
        let Entry { lesson, title, .. } = &kept.entry;
        let name = tr!("Remove {name}", name = title);
        let id = lesson.clone();
        let remove = send.reform(move |_: MouseEvent| Msg::Remove(id.clone()));
        html! {
            <li class="mine" key={lesson.to_string()}>
                { part::<Card>(CardProps { entry: kept.entry.clone(), film: kept.film.clone(), stage: progress.stage(lesson), is_next: false, send: send.clone() }) }
                <button type="button" class="btn ghost round sm" title={name.clone()} onclick={remove}>
                    { icon::show("erase") }<span class="vh">{ name }</span>
                </button>
            </li>
        }
    };
    let undo = send.reform(|_: MouseEvent| Msg::BringBack);
    html! {
        <section class="chap" aria-labelledby="chapter-own">
            <header>
                <b class="no" aria-hidden="true">{ icon::show("open") }</b>
                <div><h3 id="chapter-own">{ tr!("Lessons you opened") }</h3><p>{ tr!("From a file or a link. This browser keeps the last ones.") }</p></div>
            </header>
            <ol class="less">
                { for own.lessons.iter().map(card) }
                if let Some(lesson) = &own.removed {
                    <li class="mine gone" key="removed">
                        <span role="status">{ tr!("{name} is removed.", name = lesson.title) }</span>
                        <button type="button" class="btn ghost" onclick={undo}>{ icon::show("undo") }<span>{ tr!("Undo") }</span></button>
                    </li>
                }
            </ol>
        </section>
    }
}
