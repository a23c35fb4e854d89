//! How many agents of a scenario are wanted.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::{Action, FileAction, files::Choice, number};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::frame::Frame;
use crate::field::possible;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct AgentsProps {
    /// The map and the scenario.
    pub(crate) choice: Rc<Choice>,
    /// Takes the scene, or why there is none.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The question how many agents are wanted.
#[component]
pub(crate) fn Agents(props: &AgentsProps) -> Html {
    let AgentsProps {
        choice,
        send,
        on_close,
    } = props;
    // Kept here: the page may be rendered anew while somebody types.
    let typed = use_state_eq(|| choice.proposed().to_string());
    let input = {
        let typed = typed.clone();
        Callback::from(move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typed.set(input.value());
        })
    };
    let range = (1, u32::try_from(choice.most()).unwrap_or(u32::MAX));
    let agents = number::read(&typed, range);
    let open = {
        let (choice, send, on_close) = (Rc::clone(choice), send.clone(), on_close.clone());
        Callback::from(move |()| {
            let Some(agents) = agents else { return };
            on_close.emit(());
            send.emit(match choice.scene(agents as usize) {
                Ok(scene) => Action::File(FileAction::Open(Box::new(scene))),
                Err(notice) => Action::File(FileAction::Tell(notice)),
            });
        })
    };
    let enter = {
        let open = open.clone();
        Callback::from(move |event: KeyboardEvent| {
            if event.key() == "Enter" {
                event.prevent_default();
                open.emit(());
            }
        })
    };
    let there_are = tr!("{n} robot" | "{n} robots" % choice.most());
    html! {
        <Frame title={tr!("How many robots?")} narrow=true on_close={on_close.clone()}>
            <p>{ tr!("{file} has {there_are}. The first of them are taken.", file = choice.file(), there_are) }</p>
            <div class="ask-number">
                <label for="agents">{ tr!("Robots") }</label>
                <input id="agents" class="field" type="number" inputmode="numeric"
                    min="1" max={choice.most().to_string()} value={(*typed).clone()}
                    oninput={input} onkeydown={enter} autofocus=true />
                if agents.is_none() { { possible(range) } }
            </div>
            <div class="dialog-foot">
                <button class="btn outline" onclick={on_close.reform(|_| ())}>{ tr!("Back") }</button>
                <button class="btn primary" disabled={agents.is_none()} onclick={open.reform(|_| ())}>{ tr!("Open scene") }</button>
            </div>
        </Frame>
    }
}
