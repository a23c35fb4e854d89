//! The proof of a plan in the lesson: checked, damaged by a byte, checked again.

use giveway_course::learner::{Action, Held, Open, Proof};
use giveway_model::tr;
use yew::prelude::*;

use super::tutor::Msg;
use crate::icon;

pub(super) fn show(open: &Open, send: &Callback<Msg>) -> Html {
    let Some(proof) = open.proof() else {
        return html! {};
    };
    let button = |word: &'static str, action: Action| {
        let onclick = send.reform(move |_: MouseEvent| Msg::Do(action.clone()));
        html! { <button type="button" class="btn outline" {onclick}><span>{ word }</span></button> }
    };
    let check = || button(tr!("Check the proof"), Action::CheckProof);
    // What is said is read aloud: its place is there from the start.
    html! {
        <section class="ex checks" aria-label={tr!("The proof")}>
            <div role="status">{ said(proof) }</div>
            <div class="exa">
                { match proof {
                    Proof::Unasked | Proof::Missing => check(),
                    // It keeps the focus while nothing can be done.
                    Proof::Asked(_) => html! {
                        <button type="button" class="btn outline" aria-disabled="true"><span>{ tr!("Check the proof") }</span></button>
                    },
                    Proof::Held(held) if held.changed().is_some() => button(tr!("Change it back"), Action::ChangeByte),
                    Proof::Held(_) => button(tr!("Change one byte"), Action::ChangeByte),
                } }
            </div>
        </section>
    }
}

fn said(proof: &Proof) -> Html {
    match proof {
        Proof::Unasked => html! {},
        Proof::Asked(_) => {
            html! { <p class="quiet">{ tr!("The solver writes the proof\u{2026}") }</p> }
        }
        Proof::Missing => html! { <p>{ tr!("There was no proof in this time.") }</p> },
        Proof::Held(held) => checked(held),
    }
}

fn checked(held: &Held) -> Html {
    let (class, name, words) = if held.is_accepted() {
        let words = tr!("Accepted: the proof shows that no plan is better.");
        ("judge", "proved", words)
    } else {
        let words = tr!("Refused: this proof shows nothing.");
        ("judge not", "collision", words)
    };
    let detail = match held.changed() {
        Some(changed) => {
            let (was, is) = changed.figures;
            let (at, file) = (changed.at + 1, &changed.file);
            tr!(
                "Byte {at} of {file} was {was}, and is {is} now.",
                at,
                file,
                was,
                is
            )
        }
        None => tr!("{n} byte, each as it was written."
            | "{n} bytes, each as it was written."
                % u32::try_from(held.bytes()).unwrap_or(u32::MAX)),
    };
    html! {
        <div {class}>{ icon::show(name) }<div><p><b>{ words }</b></p><small>{ detail }</small></div></div>
    }
}
