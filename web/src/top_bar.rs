//! The top bar: the scene's name and size, and what is done to it as a whole.

use giveway_page::{Action, words};
use yew::prelude::*;

use crate::{Icon, Shown};

/// The state and where actions go.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct TopBarProps {
    /// The state.
    pub state: Shown,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// The top bar.
#[component]
pub(crate) fn TopBar(props: &TopBarProps) -> Html {
    let TopBarProps { state, send } = props;
    let scene = state.draft.scene();
    let grid = state.draft.grid();
    let name = match scene.name.as_str() {
        "" => "Untitled",
        name => name,
    };
    let agents = words::count(scene.agents.len(), "agent");
    let undo = send.reform(|_| Action::Undo);
    let redo = send.reform(|_| Action::Redo);
    html! {
        <header class="bar">
            <span class="brand">
                <svg viewBox="0 0 24 24" aria-hidden="true">
                    <path d="M3.6 5.2h16.8L12 19.6Z" />
                </svg>
                <b>{ "Giveway" }</b>
            </span>
            <span class="scene">
                <span>{ name.to_owned() }</span>
                <small>{ format!("{} \u{d7} {}, {agents}", grid.width(), grid.height()) }</small>
            </span>
            <span class="grow"></span>
            <div class="acts">
                <button class="btn ghost ph" title="Undo (Ctrl Z)" onclick={undo}
                    disabled={!state.history.can_undo()}>
                    <Icon name="undo" /><span class="vh">{ "Undo" }</span>
                </button>
                <button class="btn ghost ph" title="Redo (Ctrl Shift Z)" onclick={redo}
                    disabled={!state.history.can_redo()}>
                    <Icon name="redo" /><span class="vh">{ "Redo" }</span>
                </button>
            </div>
        </header>
    }
}
