//! The methods to go on after a change by.

use giveway_course::judge::Did;
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::task::Change;
use giveway_solve::change::Method;
use yew::prelude::*;

use super::super::tutor::Msg;

pub(super) fn show(open: &Open, task: &Change, send: &Callback<Msg>) -> Html {
    let went = match open.did() {
        Did::Went(method) => Some(*method),
        _ => None,
    };
    let one = |&method: &Method| {
        let (name, detail) = words(method);
        let is_chosen = went == Some(method);
        let onclick = send.reform(move |_: MouseEvent| Msg::Do(Action::Went(method)));
        html! {
            <li><button type="button" class="opt" aria-pressed={is_chosen.to_string()} {onclick}>
                <span><b>{ name }</b><small>{ detail }</small></span>
            </button></li>
        }
    };
    html! { <ul class="opts" aria-label="Methods">{ for task.methods.iter().map(one) }</ul> }
}

/// A method, and what it keeps.
fn words(method: Method) -> (String, String) {
    match method {
        Method::Revise => ("Revise".to_owned(), "Same paths, new times.".to_owned()),
        Method::Tunnel(0) => (
            "Tunnel 0".to_owned(),
            "On the cells of the old paths.".to_owned(),
        ),
        Method::Tunnel(1) => (
            "Tunnel 1".to_owned(),
            "Within 1 step of the old paths.".to_owned(),
        ),
        Method::Tunnel(width) => (
            format!("Tunnel {width}"),
            format!("Within {width} steps of the old paths."),
        ),
        Method::Replan => ("Replan".to_owned(), "Everyone plans freely.".to_owned()),
    }
}
