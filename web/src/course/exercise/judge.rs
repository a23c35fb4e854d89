//! The line of the judge: it answers each thing that is done.

use giveway_course::judge::words::{made, said};
use giveway_course::judge::{Kind, Verdict, Why};
use giveway_course::learner::{Action, Judge, Open};
use giveway_course::lesson::{Task, Text};
use giveway_course::port::Evidence;
use giveway_model::tr;
use yew::prelude::*;

use super::super::prose::Reader;
use super::super::tutor::{Msg, Tutor};
use crate::icon;

/// What the judge says now. The place is there from the start, so that it is read aloud
/// when something comes into it.
pub(super) fn show(tutor: &Tutor, open: &Open, reader: Reader<'_>) -> Html {
    html! { <div class="judge-at" role="status">{ bare(tutor, open, reader) }</div> }
}

/// The same within another place that is read aloud.
pub(super) fn bare(tutor: &Tutor, open: &Open, reader: Reader<'_>) -> Html {
    match open.judge() {
        Judge::Waiting => html! {},
        Judge::Looking(_) if tutor.is_late => html! {
            <div class="judge">{ icon::show("search") }<p><b>{ tr!("Looking\u{2026}") }</b></p></div>
        },
        // What was said stays for a moment, so that nothing flickers.
        Judge::Looking(_) => match &tutor.before {
            Some(verdict) => verdict_line(verdict, open, reader),
            None => html! {},
        },
        Judge::Said(verdict) => verdict_line(verdict, open, reader),
    }
}

fn verdict_line(verdict: &Verdict, open: &Open, reader: Reader<'_>) -> Html {
    let Some(step) = open.step() else {
        return html! {};
    };
    let said = said(verdict, step);
    let (class, name) = match verdict.kind {
        Kind::NotYet => ("judge not", "clock"),
        Kind::NotLikeThis => ("judge not", "undo"),
        Kind::Solved => ("judge", "proved"),
    };
    let is_reply = matches!(verdict.why, Why::Reply(_));
    html! {
        <div {class}>
            { icon::show(name) }
            <div>
                if is_reply {
                    <p>{ reader.show(&said.text) }</p>
                } else {
                    <p><b>{ format!("{}: ", said.head) }{ reader.show(&said.text) }</b></p>
                }
                if let Some(made) = made_words(open) { <small>{ reader.show(&made) }</small> }
                { evidence(&verdict.evidence, reader.send) }
            </div>
        </div>
    }
}

/// What was changed, where that is the task.
fn made_words(open: &Open) -> Option<Text> {
    let task = open.step()?.task.as_ref()?;
    matches!(task, Task::Paint(_)).then(|| made(open.start(), open.scene()))?
}

/// What shows it, one press away.
pub(super) fn evidence(evidence: &Evidence, send: &Callback<Msg>) -> Html {
    if evidence.is_empty() {
        return html! {};
    }
    let word = if evidence.has_plan() {
        tr!("Show me the plan")
    } else {
        tr!("Show me where")
    };
    html! {
        <button type="button" class="link" onclick={send.reform(|_: MouseEvent| Msg::Do(Action::ShowEvidence))}>{ word }</button>
    }
}
