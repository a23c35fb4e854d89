//! The conflicts that were marked in a plan.

use giveway_course::judge::{Did, Mark, Why};
use giveway_course::learner::{Action, Open};
use giveway_model::words::and;
use yew::prelude::*;

use super::super::prose::Reader;
use super::super::tutor::Msg;
use crate::icon;

pub(super) fn show(open: &Open, reader: Reader<'_>) -> Html {
    let marks = match open.did() {
        Did::Marked(marks) => marks.as_slice(),
        _ => &[],
    };
    let wrong = open
        .judge()
        .verdict()
        .and_then(|verdict| match &verdict.why {
            Why::NoConflict(mark) => Some(mark),
            _ => None,
        });
    html! {
        <>
            if !marks.is_empty() {
                <ul class="marks" aria-label="Marked">{ for marks.iter().map(|mark| one(mark, wrong == Some(mark), reader)) }</ul>
            }
            if let Some(pick) = open.pointed() {
                <p class="pointed">
                    { for pick.robots.iter().map(|name| reader.robot(name)) }
                    { format!(" at time {}, and who else?", pick.time) }
                </p>
            }
        </>
    }
}

/// A mark; it goes to its time.
fn one(mark: &Mark, is_wrong: bool, reader: Reader<'_>) -> Html {
    let time = mark.time;
    let onclick = reader
        .send
        .reform(move |_: MouseEvent| Msg::Do(Action::Time(time)));
    let name = if is_wrong { "question" } else { "collision" };
    html! {
        <li><button type="button" class="choice" {onclick} aria-label={format!("{} at time {time}, go there", and(&mark.robots))}>
            { icon::show(name) }
            <span>{ for mark.robots.iter().map(|name| reader.robot(name)) }</span>
            <span class="tt">{ format!("time {time}") }</span>
        </button></li>
    }
}
