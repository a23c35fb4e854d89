//! The link that holds the scene with its plan.

use giveway_page::Action;
use yew::prelude::*;

use super::frame::Frame;
use crate::{Icon, copy};

/// From so many characters on, a link is too long for some programs.
const LONG: usize = 8000;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ShareProps {
    /// The link.
    pub(crate) link: AttrValue,
    /// Takes what the browser refuses.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The link, to be copied.
#[component]
pub(crate) fn Share(props: &ShareProps) -> Html {
    let is_copied = use_state_eq(|| false);
    let press = {
        let (props, is_copied) = (props.clone(), is_copied.clone());
        Callback::from(move |_: MouseEvent| {
            let (send, is_copied) = (props.send.clone(), is_copied.clone());
            copy::text("link", &props.link, move |done| match done {
                Ok(()) => is_copied.set(true),
                Err(notice) => send.emit(Action::Refuse(notice)),
            });
        })
    };
    let length = props.link.len();
    html! {
        <Frame title="Share" on_close={props.on_close.clone()}>
            <p>{ "Whoever opens this link sees the scene and its plan at the time shown. \
                  Nothing is sent anywhere: all of it is in the link." }</p>
            if length > LONG {
                <p>{ format!("It has {length} characters, which some programs cut: a file is safer.") }</p>
            }
            <div class="ask-number">
                <label for="link">{ "Link" }</label>
                <input id="link" class="field" type="text" readonly=true value={props.link.clone()} />
            </div>
            <div class="dialog-foot">
                <span class="grow" role="status">{ if *is_copied { "Copied." } else { "" } }</span>
                <button class="btn primary" onclick={press}><Icon name="copy" />{ "Copy link" }</button>
            </div>
        </Frame>
    }
}
