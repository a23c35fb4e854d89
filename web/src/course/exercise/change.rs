//! The methods to go on after a change by.

use giveway_course::judge::Did;
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::task::Change;
use giveway_model::tr;
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
    html! { <ul class="opts" aria-label={tr!("Methods")}>{ for task.methods.iter().map(one) }</ul> }
}

/// A method, and what it keeps.
fn words(method: Method) -> (String, String) {
    let tunnel = |width: u32| tr!("Tunnel {width}", width);
    let (name, keeps) = match method {
        Method::Revise => (tr!("Revise").to_owned(), tr!("Same paths, new times.")),
        Method::Tunnel(0) => (tunnel(0), tr!("On the cells of the old paths.")),
        Method::Tunnel(width) => {
            let within =
                tr!("Within {n} step of the old paths."
                    | "Within {n} steps of the old paths." % width);
            return (tunnel(width), within);
        }
        Method::Replan => (tr!("Replan").to_owned(), tr!("Everyone plans freely.")),
    };
    (name, keeps.to_owned())
}
