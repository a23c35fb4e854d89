//! The steps of the lesson that is written, as a list; the one that is shown can be
//! moved, copied and removed.

use giveway_course::author::{Action, Draft, Looked};
use giveway_course::lesson::read::MAX_STEPS;
use giveway_model::tr;
use yew::prelude::*;

use super::Notes;
use crate::icon;

/// The list.
pub(super) fn list(draft: &Draft, looked: &Looked, notes: &Notes, send: &Callback<Action>) -> Html {
    let (at, count) = (draft.at(), draft.steps().len());
    let row = |(index, step): (usize, &giveway_course::author::StepDraft)| {
        let title = match step.word("title").trim() {
            "" => tr!("Untitled"),
            title => title,
        };
        let mut faults = looked.of(Some(index)).into_iter();
        let has_fault = faults.any(|fault| notes.is_strict || !fault.is_missing())
            || notes.check.is_wrong(index);
        let onclick = send.reform(move |_: MouseEvent| Action::Go(index));
        let onkeydown = {
            let send = send.clone();
            move |event: KeyboardEvent| {
                let to = match event.key().as_str() {
                    "ArrowUp" if event.alt_key() => index.checked_sub(1),
                    "ArrowDown" if event.alt_key() => Some(index + 1).filter(|to| *to < count),
                    "Delete" => {
                        event.prevent_default();
                        return send.emit(Action::Remove(index));
                    }
                    _ => return,
                };
                event.prevent_default();
                if let Some(to) = to {
                    send.emit(Action::Move { from: index, to });
                }
            }
        };
        html! {
            <li key={step.key()}>
                <button type="button" class={classes!("as", (index == at).then_some("on"))} aria-current={(index == at).then_some("step")}
                    title={tr!("Alt with the arrow keys moves it, Delete removes it")} {onclick} {onkeydown}>
                    <b class="no">{ index + 1 }</b><span>{ title.to_owned() }</span>
                    if has_fault { { icon::show("warning") }<span class="vh">{ tr!("has something to mend") }</span> }
                </button>
            </li>
        }
    };
    let add = send.reform(|_: MouseEvent| Action::Add);
    html! {
        <nav class="asteps" aria-label={tr!("Steps")}>
            <ol>{ for draft.steps().iter().enumerate().map(row) }</ol>
            <button type="button" class="btn ghost" disabled={count >= MAX_STEPS} onclick={add}>
                { icon::show("plus") }<span>{ tr!("Add a step") }</span>
            </button>
        </nav>
    }
}

/// What is done with the step that is shown.
pub(super) fn tools(draft: &Draft, send: &Callback<Action>) -> Html {
    let (at, count) = (draft.at(), draft.steps().len());
    let button = |icon: &'static str,
                  class: &'static str,
                  name: &'static str,
                  can: bool,
                  action: Action| {
        let onclick = send.reform(move |_: MouseEvent| action.clone());
        html! {
            <button type="button" class={classes!("btn", "ghost", "round", "sm", class)} title={name} disabled={!can} {onclick}>
                { icon::show(icon) }<span class="vh">{ name }</span>
            </button>
        }
    };
    let moved = |to: usize| Action::Move { from: at, to };
    html! {
        <div class="atools">
            <h3>{ tr!("Step {number} of {count}", number = at + 1, count) }</h3>
            <span class="grow"></span>
            { button("down", "up", tr!("Move the step up"), at > 0, moved(at.saturating_sub(1))) }
            { button("down", "", tr!("Move the step down"), at + 1 < count, moved(at + 1)) }
            { button("copy", "", tr!("Copy the step"), count < MAX_STEPS, Action::Copy(at)) }
            { button("erase", "", tr!("Remove the step"), true, Action::Remove(at)) }
        </div>
    }
}
