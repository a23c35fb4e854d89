//! The page before a room: above the board its name and costs, below it the steps, what
//! is said, and large buttons that play. What only that takes, a script fetches when it
//! begins first (`static/present.js`): the style sheet, the full screen, buttons that fade.

use std::cell::Cell;

use giveway_model::{tr, tr_data};
use giveway_page::lesson::Lesson;
use giveway_page::present::{END, third};
use giveway_page::{Action, FileAction, Notice, State};
use yew::prelude::*;

use crate::embed::{slider, title};
use crate::status::sentence;
use crate::timeline::{clock, play_keys};
use crate::{icon, script};

/// The script's name in the head of the page.
const SCRIPT: &str = "giveway-present";

/// Fetches what it takes, when it begins.
#[hook]
pub(crate) fn use_presenting(is_presented: bool, send: &Callback<Action>) {
    let send = send.clone();
    // A script that failed is another one when it is tried again.
    let failures = use_memo((), |()| Cell::new(0));
    use_effect_with(is_presented, move |&is_presented| {
        if !is_presented {
            return;
        }
        let number = failures.get();
        let missing = move |why| {
            failures.set(number + 1);
            send.emit(END);
            send.emit(Action::File(FileAction::Tell(
                Notice::refusal(tr_data!(
                    "The presentation could not be loaded. Try again when the network is back."
                ))
                .with([why]),
            )));
        };
        let failed = missing.clone();
        if let Err(why) = script::start(SCRIPT, number, failed) {
            missing(why);
        }
    });
}

/// What stands above the board.
pub(crate) fn head(state: &State, send: &Callback<Action>) -> Html {
    let lesson = state.lesson();
    let name = if lesson.is_none() {
        title(state)
    } else {
        state.document.draft.scene().name.clone()
    };
    html! {
        <header class="present-head">
            <h1>{ name }</h1>
            // A plan that is to be guessed is not told.
            if !state.hides_answers() && !lesson.is_some_and(Lesson::hides_plan) { { sentence(state) } }
            <button type="button" class="btn ghost round" id="present-end" title={tr!("End the presentation (Escape)")}
                onclick={send.reform(|_| END)}>
                { icon::show("cancel") }<span class="vh">{ tr!("End the presentation") }</span>
            </button>
        </header>
    }
}

/// What stands below it.
pub(crate) fn foot(state: &State, has_plan: bool, send: &Callback<Action>) -> Html {
    let third = third(state);
    html! {
        <section class="present-foot" aria-label={tr!("Presentation")}>
            if has_plan {
                <div class="steps">{ slider(state, send) }{ steps(state) }</div>
                <div class="large">{ clock(state, send) }{ play_keys(state, send) }</div>
            }
            <div class="third" aria-live="polite">
                if let Some(third) = third {
                    <h2>{ third.question }</h2>
                    <p>if let Some(verdict) = third.verdict { <b>{ verdict }</b>{ " " } }{ third.text }</p>
                    if !third.causes.is_empty() {
                        <ol>{ for third.causes.iter().map(|cause| html! { <li><b>{ cause.numbers.clone() }</b><span>{ cause.text.clone() }</span></li> }) }</ol>
                    }
                }
            </div>
        </section>
    }
}

/// The steps of the plan, those up to the time shown filled.
fn steps(state: &State) -> Html {
    let (time, last) = (state.view.playback.time, state.last_time());
    html! {
        <svg viewBox={format!("0 0 {last} 1")} preserveAspectRatio="none" aria-hidden="true">
            <path d={format!("M0 .5H{last}")} /><path d={format!("M0 .5H{time}")} />
        </svg>
    }
}
