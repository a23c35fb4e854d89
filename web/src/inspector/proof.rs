//! The check of a proof: its button, what it is at, what came of it, and what saves its
//! certificate.

use giveway_model::tr;
use giveway_page::certificate;
use giveway_page::proof::{Line, Outcome, Proof, proof};
use giveway_page::{Action, SolveAction, State};
use yew::prelude::*;

use crate::icon;

pub(super) fn show(state: &State, send: &Callback<Action>) -> Html {
    match proof(state) {
        None => html! {},
        Some(Proof::Offered) => html! {
            <button type="button" class="btn outline more" onclick={send.reform(|_| Action::Solve(SolveAction::CheckProof))}>
                { icon::show("proved") }{ tr!("Check the proof") }
            </button>
        },
        Some(Proof::Running(doing)) => running(&doing),
        Some(Proof::Done(outcome)) => html! { <>{ done(&outcome) }{ save(state, send) }</> },
    }
}

/// What saves certificates of what is told.
pub(super) fn save(state: &State, send: &Callback<Action>) -> Html {
    let Some(words) = certificate::offer(state) else {
        return Html::default();
    };
    html! {
        <button type="button" class="btn outline more" title={tr!("Files with which anyone can check it")}
            onclick={send.reform(|_| Action::Solve(SolveAction::SaveProof))}>
            { icon::show("save") }{ words }
        </button>
    }
}

/// What is being checked or saved, where it is about what must be so.
pub(super) fn saving(state: &State, send: &Callback<Action>) -> Html {
    match proof(state) {
        Some(Proof::Running(doing)) => running(&doing),
        _ => save(state, send),
    }
}

fn running(doing: &str) -> Html {
    html! { <ul class="pending proof-at"><li>{ doing.trim_end_matches('.').to_owned() }</li></ul> }
}

fn done(outcome: &Outcome) -> Html {
    let badge = outcome.badge;
    html! {
        <section class="proof-at" aria-label={tr!("Proof")}>
            <div class={classes!("verdict", badge.class)} aria-live="polite">
                <p class="vb">{ icon::show(badge.icon) }<b>{ badge.word }</b></p>
                <p class="vs">{ outcome.sentence.clone() }</p>
            </div>
            <ul class="proofs">{ for outcome.claims.iter().map(line) }</ul>
        </section>
    }
}

fn line(line: &Line) -> Html {
    html! {
        <li>{ icon::show(line.icon) }<span>{ line.text.clone() }<small>{ line.rests_on.clone() }</small></span></li>
    }
}
