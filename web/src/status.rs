//! The status sentence, and the button that solves.

use giveway_page::{Action, Phase, words};
use yew::prelude::*;

use crate::{Icon, Shown};

/// The state and where actions go.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct StatusBarProps {
    /// The state.
    pub state: Shown,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// The status sentence with its badge, and `Solve` or `Cancel`.
#[component]
pub(crate) fn StatusBar(props: &StatusBarProps) -> Html {
    let StatusBarProps { state, send } = props;
    let words::Standing { badge, sentence } = words::standing(state);
    html! {
        <section class="status">
            <p class="status-line" role="status">
                <span class={classes!("badge", badge.class())}>
                    <Icon name={badge.icon()} />{ badge.word() }
                </span>
                { " " }
                <span class="say">{ sentence }</span>
            </p>
            <div class="solve">{ solve_button(state.phase(), send) }</div>
        </section>
    }
}

/// The one next step is dark: to cancel, or to solve where nothing fits the
/// scene.
fn solve_button(phase: Phase, send: &Callback<Action>) -> Html {
    if phase == Phase::Solving {
        let cancel = send.reform(|_| Action::Cancel);
        return html! {
            <button class="btn primary" title="Cancel (Escape)" onclick={cancel}>
                <Icon name="cancel" /><span>{ "Cancel" }</span>
            </button>
        };
    }
    let look = match phase {
        Phase::Editing => "primary",
        _ => "outline",
    };
    let solve = send.reform(|_| Action::Solve);
    html! {
        <button class={classes!("btn", "slv", look)} title="Solve (Ctrl Enter)" onclick={solve}>
            { "Solve" }
        </button>
    }
}
