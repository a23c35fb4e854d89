//! How many agents of a scenario are wanted.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::{Action, FileAction, files::Choice};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::frame::Frame;

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
    let open = {
        let (choice, send, on_close) = (Rc::clone(choice), send.clone(), on_close.clone());
        let typed = typed.clone();
        Callback::from(move |()| {
            let agents = typed.trim().parse::<usize>().unwrap_or(choice.proposed());
            let agents = agents.clamp(1, choice.most());
            on_close.emit(());
            send.emit(match choice.scene(agents) {
                Ok(scene) => Action::File(FileAction::Open(Box::new(scene))),
                Err(notice) => Action::File(FileAction::Refuse(notice)),
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
            </div>
            <div class="dialog-foot">
                <button class="btn outline" onclick={on_close.reform(|_| ())}>{ tr!("Back") }</button>
                <button class="btn primary" onclick={open.reform(|_| ())}>{ tr!("Open scene") }</button>
            </div>
        </Frame>
    }
}
