//! A task that is solved: said calmly, with the reason.

use giveway_course::judge::Why;
use giveway_course::judge::words::said;
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::Task;
use giveway_model::tr;
use giveway_model::words::capital;
use yew::prelude::*;

use super::super::prose::Reader;
use super::super::tutor::Msg;
use super::judge::evidence;
use crate::{glyph, icon};

/// How many forms stand in the row.
const FORMS: usize = 6;

/// The card of a task that was solved before the step was opened.
pub(super) fn before(open: &Open, task: &Task, reader: Reader<'_>) -> Html {
    let reason = open.step().and_then(|step| step.reason.as_ref());
    let again = reader.send.reform(|_: MouseEvent| Msg::Do(Action::Afresh));
    html! {
        <>
            <p class="exw" id="ex-h">{ icon::show("proved") }<b>{ tr!("a verdict" => "Solved") }</b></p>
            <p class="exq">{ reader.show(task.say()) }</p>
            { super::before(open) }
            if let Some(reason) = reason { <p class="exq">{ reader.show(reason) }</p> }
            <div class="exa"><button type="button" class="btn ghost" onclick={again}>
                { icon::show("undo") }<span>{ tr!("Do it again") }</span>
            </button></div>
        </>
    }
}

/// What the card of a solved task holds.
pub(super) fn show(open: &Open, reader: Reader<'_>) -> Html {
    let (Some(verdict), Some(step)) = (open.judge().verdict(), open.step()) else {
        return html! {};
    };
    // The words of the lesson stand alone: those of the judge say less.
    let words = match (&verdict.why, &step.reason) {
        (Why::Reply(_) | Why::Guessed { .. }, _) | (_, None) => {
            let said = said(verdict, step).text;
            html! { { reader.show(&said) } }
        }
        (_, Some(_)) => {
            let said = said(verdict, step).text;
            html! { { capital(&said.plain()) } }
        }
    };
    html! {
        <>
            <div class="garland" aria-hidden="true">{ for (0..FORMS).map(|form| glyph::show(form, "garland-glyph")) }</div>
            <p class="exw" id="ex-h" role="status">{ icon::show("proved") }<b>{ tr!("a verdict" => "Solved") }</b></p>
            <p class="exq">{ words }</p>
            if let Some(reason) = &step.reason { <p class="exq">{ reader.show(reason) }</p> }
            { evidence(&verdict.evidence, reader.send) }
        </>
    }
}
