//! The contents of the course: its chapters and lessons, or its glossary.

use std::rc::Rc;

use giveway_course::learner::{Action, Onward, Progress, Stage};
use giveway_course::lesson::{Chapter, Course, Entry};
use giveway_model::tr;
use gloo::events::EventListener;
use web_sys::HtmlDialogElement;
use yew::prelude::*;

use super::author::AuthorMsg;
use super::card::{Card, bar};
use super::class::ClassMsg;
use super::glossary::Terms;
use super::language_button::use_language_button;
use super::own::{self, Own};
use super::place::Place;
use super::shelf::Shelf;
use super::sight::{focus, is_again, once};
use super::tutor::Msg;
use crate::course::card::CardProps;
use crate::course::glossary::TermsProps;
use crate::icon;
use crate::part::part;

/// What the contents show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Page {
    /// Chapters and lessons.
    Lessons,
    /// The glossary.
    Terms,
}

#[derive(Clone, Properties)]
pub(super) struct ContentsProps {
    /// What is shown.
    pub(super) page: Page,
    /// The tag of the language that is spoken; empty for English.
    pub(super) spoken: String,
    /// The course, once it is there.
    pub(super) shelf: Option<Rc<Shelf>>,
    /// How far each lesson has come.
    pub(super) progress: Progress,
    /// The lessons that came as a file or in a link.
    pub(super) own: Own,
    /// Why something is not there.
    pub(super) missing: Option<String>,
    /// Takes what is chosen.
    pub(super) send: Callback<Msg>,
}

impl PartialEq for ContentsProps {
    fn eq(&self, other: &Self) -> bool {
        let shelf = |props: &Self| props.shelf.as_ref().map(Rc::as_ptr);
        self.page == other.page
            && self.spoken == other.spoken
            && self.progress == other.progress
            && self.own == other.own
            && self.missing == other.missing
            && self.send == other.send
            && shelf(self) == shelf(other)
    }
}

/// The contents, over the page; open as long as they are there.
#[component]
pub(super) fn Contents(props: &ContentsProps) -> Html {
    let node = use_node_ref();
    // The button that goes on.
    let onward = use_node_ref();
    let close = use_callback(props.send.clone(), |(), send| send.emit(Msg::Show(None)));
    // Whether it is asked if progress is to be forgotten.
    let asks = use_state_eq(|| false);
    use_modal(&node, &close);
    let tongue = use_language_button(&node, &props.spoken, &props.send);
    // A press on the dialog itself, and not in it, is one beside it.
    let beside = {
        let (node, close) = (node.clone(), close.clone());
        move |event: MouseEvent| {
            if !is_again(&event) && event.target() == node.get().map(Into::into) {
                close.emit(());
            }
        }
    };
    html! {
        <dialog ref={node} class="sheet" aria-labelledby="course-title" onmousedown={beside}>
            <div class="sheet-in">
                { head(props, &close, &onward, tongue) }
                <div class="sbody">{ body(props) }</div>
                if let Some(shelf) = &props.shelf { { foot(props, &shelf.course, &asks, &onward) } }
            </div>
        </dialog>
    }
}

/// Opens a dialog over the page; Escape closes it, and the focus goes back.
#[hook]
pub(super) fn use_modal(node: &NodeRef, close: &Callback<()>) {
    let (node, close) = (node.clone(), close.clone());
    use_effect_with((), move |()| {
        let dialog = node.cast::<HtmlDialogElement>();
        let listening = dialog.as_ref().map(|dialog| {
            // It can only fail for a dialog that is open or not on the page.
            let _ = dialog.show_modal();
            EventListener::new(dialog, "close", move |_| close.emit(()))
        });
        move || {
            drop(listening);
            if let Some(dialog) = dialog {
                dialog.close();
            }
        }
    });
}

fn head(props: &ContentsProps, close: &Callback<()>, node: &NodeRef, tongue: Html) -> Html {
    let close = close.reform(|_: MouseEvent| ());
    let course = props.shelf.as_ref().map(|shelf| &shelf.course);
    let (title, line) = match (props.page, course) {
        (Page::Lessons, Some(course)) => (course.title.clone(), sum(course)),
        (Page::Lessons, None) => (tr!("Course").to_owned(), String::new()),
        (Page::Terms, _) => (
            tr!("Glossary").to_owned(),
            tr!("The words of the field, a sentence or two each.").to_owned(),
        ),
    };
    html! {
        <header class="sh">
            <div><h2 id="course-title">{ title }</h2><p>{ line }</p></div>
            <span class="grow"></span>
            if let Some(course) = course { { onward(course, props, node) } }
            { tongue }
            <button type="button" class="btn ghost round" title={tr!("Close (Escape)")} onclick={close}>
                { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
            </button>
        </header>
    }
}

fn sum(course: &Course) -> String {
    let lessons = course.lessons().count();
    let minutes = course.minutes();
    tr!(
        "{n} short lesson, {minutes} minutes in all. Try things on the board: every answer is judged at once."
            | "{n} short lessons, {minutes} minutes in all. Try things on the board: every answer is judged at once."
                % lessons,
        minutes
    )
}

/// The one button that goes on.
fn onward(course: &Course, props: &ContentsProps, node: &NodeRef) -> Html {
    let Some(onward) = Onward::of(course, &props.progress) else {
        return html! {};
    };
    let entry = onward.entry();
    let (class, text) = match onward {
        Onward::Start(_) => ("btn primary", tr!("Start: {title}", title = entry.title)),
        Onward::GoOn(_) => ("btn primary", tr!("Go on: {title}", title = entry.title)),
        Onward::Again(_) => ("btn outline", tr!("Again from the start").to_owned()),
    };
    let place = Place {
        lesson: entry.lesson.clone(),
        step: None,
    };
    let onclick = once(&props.send, move || Msg::Enter(place.clone()));
    html! {
        <button type="button" {class} ref={node.clone()} {onclick}>{ icon::show("play") }<span>{ text }</span></button>
    }
}

fn body(props: &ContentsProps) -> Html {
    let missing = props.missing.as_ref().map(|sentence| {
        html! { <p class="missing" role="alert">{ sentence.clone() }</p> }
    });
    let Some(shelf) = &props.shelf else {
        let loading = || html! { <p class="missing">{ tr!("Loading\u{2026}") }</p> };
        let again = props
            .send
            .reform(|_: MouseEvent| Msg::Show(Some(Page::Lessons)));
        return match missing {
            Some(missing) => html! {
                <>{ missing }<p><button type="button" class="btn outline" onclick={again}>{ tr!("Try again") }</button></p></>
            },
            None => loading(),
        };
    };
    if props.page == Page::Terms {
        return html! { { part::<Terms>(TermsProps { shelf: Rc::clone(shelf), send: props.send.clone() }) } };
    }
    let next = Onward::of(&shelf.course, &props.progress).map(|next| next.entry().lesson.clone());
    let mut first = 0;
    let chapters = shelf.course.chapters.iter().enumerate();
    let chapters = chapters.map(|(index, chapter)| {
        let shown = self::chapter(index, chapter, first, shelf, next.as_ref(), props);
        first += chapter.lessons.len();
        shown
    });
    let chapters: Vec<Html> = chapters.collect();
    html! { <>{ missing.unwrap_or_default() }{ chapters }{ own::show(&props.own, &props.progress, &props.send) }</> }
}

fn chapter(
    index: usize,
    chapter: &Chapter,
    first: usize,
    shelf: &Shelf,
    next: Option<&giveway_course::lesson::Id>,
    props: &ContentsProps,
) -> Html {
    let card = |(place, entry): (usize, &giveway_course::lesson::Entry)| {
        let film = shelf.pictures.get(first + place).cloned().flatten();
        html! {
            <li key={entry.lesson.to_string()}>
                { part::<Card>(CardProps { entry: entry.clone(), film, stage: props.progress.stage(&entry.lesson), is_next: next == Some(&entry.lesson), send: props.send.clone() }) }
            </li>
        }
    };
    let title = format!("chapter-{index}");
    html! {
        <section class="chap" aria-labelledby={title.clone()}>
            <header>
                <b class="no" aria-hidden="true">{ index + 1 }</b>
                <div><h3 id={title}>{ chapter.title.clone() }</h3><p>{ chapter.about.plain() }</p></div>
            </header>
            <ol class="less">{ for chapter.lessons.iter().enumerate().map(card) }</ol>
        </section>
    }
}

fn foot(
    props: &ContentsProps,
    course: &Course,
    asks: &UseStateHandle<bool>,
    next: &NodeRef,
) -> Html {
    let is_done = |entry: &&Entry| props.progress.stage(&entry.lesson) == Stage::Done;
    let (done, all) = (
        course.lessons().filter(is_done).count(),
        course.lessons().count(),
    );
    let is_new = props.progress.is_empty();
    let (page, word, name) = match props.page {
        Page::Lessons => (Page::Terms, tr!("Glossary"), "course"),
        Page::Terms => (Page::Lessons, tr!("All lessons"), "back"),
    };
    let turn = once(&props.send, move || Msg::Show(Some(page)));
    let write = once(&props.send, || Msg::Author(AuthorMsg::Open));
    let class = once(&props.send, || Msg::Class(ClassMsg::Open));
    html! {
        <footer class="sf">
            <span class="prog"><b>{ done }</b>{ tr!("behind a number" => " of {n} lesson done" | " of {n} lessons done" % all) }</span>
            <span class="pb-at">{ bar(done as u64, all as u64) }</span>
            if !is_new { { forget(props, asks, next) } }
            <span class="grow"></span>
            <button type="button" class="btn outline" onclick={turn}>{ icon::show(name) }<span>{ word }</span></button>
            <button type="button" class="btn ghost" title={tr!("What your class has handed in, judged anew")} onclick={class}>{ icon::show("table") }<span>{ tr!("Hand-ins") }</span></button>
            <button type="button" class="btn outline" onclick={write}>{ icon::show("edit") }<span>{ tr!("Write your own") }</span></button>
        </footer>
    }
}

/// Forgets all progress, once that was asked. The button that asks then keeps it: a
/// second press of the same key does no harm.
fn forget(props: &ContentsProps, asks: &UseStateHandle<bool>, next: &NodeRef) -> Html {
    let is_asked = **asks;
    let turn = {
        let asks = asks.clone();
        move |_: MouseEvent| asks.set(!is_asked)
    };
    let reset = {
        let (send, asks, next) = (props.send.clone(), asks.clone(), next.clone());
        move |_: MouseEvent| {
            asks.set(false);
            // This button goes.
            focus(&next);
            send.emit(Msg::Do(Action::Reset));
        }
    };
    let word = if is_asked {
        tr!("Keep it")
    } else {
        tr!("Forget my progress")
    };
    html! {
        <>
            <span class="prog" role="status">{ is_asked.then(|| tr!("Forget how far you came in all lessons?")) }</span>
            <button type="button" class={if is_asked { "btn outline" } else { "btn ghost" }} onclick={turn}><span>{ word }</span></button>
            if is_asked {
                <button type="button" class="btn outline" onclick={reset}><span>{ tr!("Reset progress") }</span></button>
            }
        </>
    }
}
