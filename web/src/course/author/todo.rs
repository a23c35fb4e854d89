//! The list of all that is still to do in a lesson; each line leads to its field.

use giveway_course::author::{Action, Draft, Looked, ToDo, Whose};
use giveway_model::tr;
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast as _;
use web_sys::HtmlElement;
use yew::prelude::*;

use super::check::Checked;
use super::fields;

/// The list, closed at first; nothing where nothing is left to do.
pub(super) fn list(
    draft: &Draft,
    looked: &Looked,
    check: &Checked,
    act: &Callback<Action>,
) -> Html {
    let mut all = looked.to_do(draft);
    all.extend(check.to_do());
    if all.is_empty() {
        return html! {};
    }
    let count = all.len();
    html! {
        <details class="atodo">
            <summary>{ tr!("{n} thing is still to do." | "{n} things are still to do." % count) }</summary>
            <ul>{ for all.into_iter().map(|line| item(draft.at(), line, act)) }</ul>
        </details>
    }
}

fn item(at: usize, line: ToDo, act: &Callback<Action>) -> Html {
    let ToDo { step, field, text } = line;
    let onclick = act.reform(move |_: MouseEvent| {
        let whose = step.map_or(Whose::Lesson, |_| Whose::Step);
        let id = field.as_ref().map(|field| fields::id(whose, field));
        // The field is there once the step is shown.
        Timeout::new(0, move || focus(id.as_deref())).forget();
        Action::Go(step.unwrap_or(at))
    });
    html! { <li><button type="button" class="link" {onclick}>{ text }</button></li> }
}

/// Brings the focus to a field; to the button that takes a board, where there is none.
fn focus(id: Option<&str>) {
    let document = gloo::utils::document();
    let element = match id {
        Some(id) => document.get_element_by_id(id),
        None => document
            .query_selector(".astep .arow button")
            .ok()
            .flatten(),
    };
    if let Some(element) = element.and_then(|element| element.dyn_into::<HtmlElement>().ok()) {
        let _ = element.focus();
    }
}
