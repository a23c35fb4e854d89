//! The scenes that this browser keeps.

use giveway_model::{tr, tr_data};
use giveway_page::{Action, FileAction, Notice, link};
use yew::prelude::*;

use super::frame::Frame;
use crate::{Shown, app, icon, keep};

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ScenesProps {
    /// The state, whose scene can be kept.
    pub(crate) state: Shown,
    /// Takes the scene that was chosen.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The scenes by name: opened, forgotten, one more kept.
#[component]
pub(crate) fn Scenes(props: &ScenesProps) -> Html {
    let ScenesProps {
        state,
        send,
        on_close,
    } = props;
    let names = use_state_eq(keep::scenes);
    let others = {
        let state = state.clone();
        use_memo((), move |()| keep::others(&link::keep(&state)))
    };
    let open = |action: fn(&str) -> Action, name: &str| {
        let (send, on_close, name) = (send.clone(), on_close.clone(), name.to_owned());
        Callback::from(move |_: MouseEvent| {
            on_close.emit(());
            send.emit(action(&name));
        })
    };
    let one = |name: &String| {
        let forget = {
            let (names, name) = (names.clone(), name.clone());
            Callback::from(move |_: MouseEvent| {
                keep::forget_scene(&name);
                names.set(keep::scenes());
            })
        };
        let shown = title(name);
        html! {
            <li key={name.clone()} class="kept">
                <button class="pick" onclick={open(keep::scene, name)}>
                    <b>{ shown.clone() }</b>{ icon::show("chevron") }
                </button>
                <button class="btn ghost round" onclick={forget} title={tr!("Forget")}
                    aria-label={tr!("Forget {shown}", shown)}>{ icon::show("cancel") }</button>
            </li>
        }
    };
    let elsewhere = |(number, name): &(String, String)| {
        html! {
            <li key={number.clone()}>
                <button class="pick" onclick={open(keep::other, number)}>
                    <b>{ title(name) }</b>{ icon::show("chevron") }
                </button>
            </li>
        }
    };
    let keep = {
        let (state, send, names) = (state.clone(), send.clone(), names.clone());
        Callback::from(move |_: MouseEvent| {
            if keep::keep_scene(&state) {
                names.set(keep::scenes());
            } else {
                send.emit(Action::File(FileAction::Tell(Notice::refusal(tr_data!(
                    "This browser has no room for the scene: save it as a file."
                )))));
            }
        })
    };
    let own = title(&state.document.draft.scene().name);
    html! {
        <Frame title={tr!("Scenes")} on_close={on_close.clone()}>
            if names.is_empty() {
                <p>{ tr!("Scenes that you keep in this browser are listed here.") }</p>
            }
            <ul class="picks">{ for names.iter().map(one) }</ul>
            if !others.is_empty() {
                <h3>{ tr!("Left in other tabs") }</h3>
                <ul class="picks">{ for others.iter().map(elsewhere) }</ul>
            }
            <div class="dialog-foot">
                <button class="btn outline" onclick={open(|_| app::example(), "")}>{ tr!("Restore the example") }</button>
                <button class="btn primary" onclick={keep}>{ tr!("Keep “{own}”", own) }</button>
            </div>
        </Frame>
    }
}

fn title(name: &str) -> String {
    if name.is_empty() {
        tr!("Untitled")
    } else {
        name
    }
    .to_owned()
}
