//! The glossary as one page, to be searched.

use std::rc::Rc;

use giveway_course::lesson::Term;
use giveway_model::tr;
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::language::small;
use super::shelf::Shelf;
use super::term::{about, still};
use super::tutor::Msg;
use crate::board::ThumbProps;
use crate::board::{Film, Thumb};
use crate::part::part;

#[derive(Clone, Properties)]
pub(super) struct TermsProps {
    /// The glossary.
    pub(super) shelf: Rc<Shelf>,
    /// Takes a lesson that is chosen.
    pub(super) send: Callback<Msg>,
}

impl PartialEq for TermsProps {
    fn eq(&self, other: &Self) -> bool {
        self.send == other.send && Rc::ptr_eq(&self.shelf, &other.shelf)
    }
}

/// All terms, or those that hold what is typed.
#[component]
pub(super) fn Terms(props: &TermsProps) -> Html {
    let typed = use_state_eq(String::new);
    let oninput = {
        let typed = typed.clone();
        move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typed.set(input.value());
        }
    };
    let shelf = &props.shelf;
    let pairs = shelf.glossary.terms.iter().zip(&shelf.term_pictures);
    let found: Vec<_> = pairs.filter(|(term, _)| has(term, &typed)).collect();
    let none = found.is_empty();
    html! {
        <div class="terms">
            <label class="find"><span class="vh">{ tr!("Find a term") }</span>
                <input class="field" type="search" placeholder={tr!("Find a term")} autocomplete="off" value={(*typed).clone()} {oninput} />
            </label>
            <p class="missing" role="status">{ if none { tr!("No term has that in it.") } else { "" } }</p>
            <dl>{ for found.into_iter().map(|(term, film)| entry(term, film.as_ref(), props)) }</dl>
        </div>
    }
}

/// Whether what is typed is in a term, in another word for it, or in its text.
fn has(term: &Term, typed: &str) -> bool {
    let typed = small(typed.trim());
    let text = term.text.plain();
    let mut words = [&term.name, &text].into_iter().chain(&term.also);
    words.any(|words| small(words).contains(&typed))
}

fn entry(term: &Term, film: Option<&Rc<Film>>, props: &TermsProps) -> Html {
    html! {
        <div class="entry" key={term.term.to_string()}>
            <dt>{ term.name.clone() }</dt>
            <dd>
                <p>{ for term.text.spans().iter().map(still) }</p>
                if let Some(source) = &term.source {
                    <small>{ format!("{}: {}, {}", source.authors, source.title, source.year) }</small>
                }
                if let Some(lesson) = &term.lesson { { about(lesson, &props.shelf, &props.send) } }
            </dd>
            if let Some(film) = film {
                <dd class="thumb2" aria-hidden="true">{ part::<Thumb>(ThumbProps { film: Rc::clone(film), plays: false }) }</dd>
            }
        </div>
    }
}
