//! A term within a text, and what the glossary says of it.

use std::rc::Rc;

use giveway_course::lesson::{Id, Span, Term};
use giveway_model::tr;
use web_sys::{Element, HtmlElement};
use yew::prelude::*;

use super::place::Place;
use super::shelf::Shelf;
use super::tutor::Msg;
use crate::dialog::use_dismiss;
use crate::icon;

/// How far the card stays from the edge of the window, and from its word, in pixels.
const MARGIN: f64 = 16.0;
const GAP: f64 = 10.0;

#[derive(Clone, Properties)]
pub(super) struct TermLinkProps {
    /// The term.
    pub(super) id: Id,
    /// The words of the text.
    pub(super) label: String,
    /// The glossary.
    pub(super) shelf: Rc<Shelf>,
    /// Takes a lesson that is chosen.
    pub(super) send: Callback<Msg>,
}

impl PartialEq for TermLinkProps {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
            && self.label == other.label
            && self.send == other.send
            && Rc::ptr_eq(&self.shelf, &other.shelf)
    }
}

/// The words of a term; pressed, they open a card.
#[component]
pub(super) fn TermLink(props: &TermLinkProps) -> Html {
    let is_open = use_state_eq(|| false);
    let (around, card) = (use_node_ref(), use_node_ref());
    let close = use_callback(is_open.setter(), |(), is_open| is_open.set(false));
    use_dismiss(&around, *is_open, &close);
    {
        let (around, card) = (around.clone(), card.clone());
        use_effect_with(*is_open, move |_| put(&around, &card));
    }
    let toggle = {
        let is_open = is_open.clone();
        move |_: MouseEvent| is_open.set(!*is_open)
    };
    let Some(term) = props.shelf.term(&props.id) else {
        return html! { { props.label.clone() } };
    };
    let name = format!("term-{}", props.id);
    html! {
        <span class="term-at" ref={around}>
            <button type="button" class={classes!("term", is_open.then_some("on"))} aria-expanded={is_open.to_string()}
                aria-controls={is_open.then(|| name.clone())} onclick={toggle}>{ props.label.clone() }</button>
            if *is_open {
                <span class="gloss" ref={card} id={name} role="dialog" aria-label={term.name.clone()}>
                    <i class="tip"></i>
                    { said(term, &props.shelf, &close, &props.send) }
                </span>
            }
        </span>
    }
}

fn said(term: &Term, shelf: &Shelf, close: &Callback<()>, send: &Callback<Msg>) -> Html {
    let close = close.reform(|_: MouseEvent| ());
    html! {
        <>
            <span class="gt">
                <b>{ term.name.clone() }</b>
                <button type="button" class="btn ghost round sm" title={tr!("Close")} onclick={close}>
                    { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
                </button>
            </span>
            <span class="gx">{ for term.text.spans().iter().map(still) }</span>
            if let Some(lesson) = &term.lesson { { about(lesson, shelf, send) } }
        </>
    }
}

/// Terms within the text of a term are words.
pub(super) fn still(span: &Span) -> Html {
    match span {
        Span::Emphasis(words) => html! { <em>{ words.clone() }</em> },
        span => html! { { span.words().to_owned() } },
    }
}

/// The way to the lesson about a term.
pub(super) fn about(lesson: &Id, shelf: &Shelf, send: &Callback<Msg>) -> Html {
    let Some((number, entry)) = shelf.entry(lesson) else {
        return html! {};
    };
    let place = Place {
        lesson: lesson.clone(),
        step: None,
    };
    let onclick = send.reform(move |_: MouseEvent| Msg::Enter(place.clone()));
    html! {
        <button type="button" class="link" {onclick}>{ tr!("Lesson {number}: {title}", number, title = entry.title) }</button>
    }
}

/// Puts the card above its word, or below where there is no room; the tip points at it.
fn put(around: &NodeRef, card: &NodeRef) {
    let (Some(around), Some(card)) = (around.cast::<Element>(), card.cast::<HtmlElement>()) else {
        return;
    };
    let Some(word) = around.first_element_child() else {
        return;
    };
    let window = gloo::utils::window();
    let width = window.inner_width().ok().and_then(|width| width.as_f64());
    let (word, size) = (
        word.get_bounding_client_rect(),
        card.get_bounding_client_rect(),
    );
    let middle = word.left() + word.width() / 2.0;
    // Within its column, so that the board stays in sight.
    let column = around.closest("aside").ok().flatten();
    let column = column.map(|column| column.get_bounding_client_rect().left());
    let least = column.unwrap_or_default() + MARGIN;
    let most = width.unwrap_or_default() - size.width() - MARGIN;
    let left = (middle - size.width() / 2.0).min(most).max(least);
    let above = word.top() - size.height() - GAP;
    let is_below = above < MARGIN / 2.0;
    let top = if is_below { word.bottom() + GAP } else { above };
    let style = card.style();
    for (name, value) in [("left", left), ("top", top), ("--x", middle - left)] {
        // It fails for a name that is none.
        let _ = style.set_property(name, &format!("{value:.1}px"));
    }
    let _ = card.toggle_attribute_with_force("data-below", is_below);
}
