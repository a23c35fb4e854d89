//! The course: its contents, the lesson that is open, its glossary.
//!
//! What a person does in a lesson, and what is judged of it, is decided in
//! `giveway-course`, and so is the tour of the page; here it becomes elements and events. The course is a program of
//! its own, beside the page: they talk in messages
//! (`line`).

mod act;
mod address;
mod asker;
mod author;
mod card;
mod class;
mod contents;
mod enter;
mod exercise;
mod glossary;
mod handin;
mod kept;
mod keys;
mod language;
mod language_button;
mod lesson;
mod line;
mod msg;
mod own;
mod place;
mod print;
mod proof;
mod prose;
mod rules;
mod shelf;
mod sight;
mod term;
mod third;
mod tour;
mod turn;
mod tutor;

use yew::prelude::*;

use tutor::Tutor;

/// Where the page has a place for the course.
const PLACE: &str = "course";

/// Puts the course into its place on the page, which hears of it; nothing where there
/// is no such place.
pub fn mount() {
    let document = gloo::utils::document();
    let Some(place) = place() else {
        return;
    };
    // Yew tells its events apart by the number of the root that they come from, and
    // each program counts from 1: the page has that number. So this program's first
    // root is one that nobody sees.
    if let Ok(unseen) = document.create_element("div") {
        yew::Renderer::<Unseen>::with_root(unseen)
            .render()
            .destroy();
    }
    yew::Renderer::<Tutor>::with_root(place).render();
}

/// The place on the page.
fn place() -> Option<web_sys::Element> {
    gloo::utils::document().get_element_by_id(PLACE)
}

/// Nothing.
#[component]
fn Unseen() -> Html {
    html! {}
}
