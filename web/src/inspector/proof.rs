//! The check of a proof: its button, what it is at, what came of it.

use giveway_page::proof::{Line, Outcome, Proof, proof};
use giveway_page::{Action, SolveAction, State};
use yew::prelude::*;

use crate::icon;

pub(super) fn show(state: &State, send: &Callback<Action>) -> Html {
    match proof(state) {
        None => html! {},
        Some(Proof::Offered) => html! {
            <button type="button" class="btn outline more" onclick={send.reform(|_| Action::Solve(SolveAction::CheckProof))}>
                { icon::show("proved") }{ "Check the proof" }
            </button>
        },
        Some(Proof::Running(doing)) => html! {
            <ul class="pending proof-at"><li>{ doing.trim_end_matches('.').to_owned() }</li></ul>
        },
        Some(Proof::Done(outcome)) => done(&outcome),
    }
}

fn done(outcome: &Outcome) -> Html {
    let badge = outcome.badge;
    html! {
        <section class="proof-at" aria-label="Proof">
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
