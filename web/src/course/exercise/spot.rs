//! The conflicts that were marked in a plan.

use giveway_course::judge::{Did, Mark, Why};
use giveway_course::learner::{Action, Open};
use giveway_model::tr;
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
                <ul class="marks" aria-label={tr!("Marked")}>{ for marks.iter().map(|mark| one(mark, wrong == Some(mark), reader)) }</ul>
            }
            if marks.is_empty() && open.pointed().is_none() {
                <p class="quiet">{ tr!("Show the time of a conflict, then press its robots on the board.") }</p>
            }
            if let Some(pick) = open.pointed() {
                <p class="pointed">
                    { for pick.robots.iter().map(|name| reader.robot(name)) }
                    { tr!("behind a robot" => " at time {time}, and who else?", time = pick.time) }
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
        <li><button type="button" class="choice" {onclick} aria-label={tr!("{robots} at time {time}, go there", robots = and(&mark.robots), time)}>
            { icon::show(name) }
            <span>{ for mark.robots.iter().map(|name| reader.robot(name)) }</span>
            <span class="tt">{ tr!("time {time}", time) }</span>
        </button></li>
    }
}
