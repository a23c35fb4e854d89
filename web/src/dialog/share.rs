//! The link that holds the scene with its plan and its question.

use giveway_model::tr;
use giveway_page::{Action, FileAction, link::embed};
use yew::prelude::*;

use super::frame::Frame;
use crate::{copy, icon};

/// From so many characters on, a link is too long for some programs.
const LONG: usize = 8000;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ShareProps {
    /// The link.
    pub(crate) link: AttrValue,
    /// The scene's name.
    pub(crate) name: String,
    /// Takes what the browser refuses.
    pub(crate) send: Callback<Action>,
    /// Opens the editor of lessons.
    pub(crate) on_lesson: Callback<MouseEvent>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The link, to be copied, by itself or as HTML.
#[component]
pub(crate) fn Share(props: &ShareProps) -> Html {
    let told = use_state_eq(|| "");
    let press = |what: &'static str, text: AttrValue, done_so: &'static str| {
        let (send, told) = (props.send.clone(), told.clone());
        Callback::from(move |_: MouseEvent| {
            let (send, told) = (send.clone(), told.clone());
            copy::text(what, &text, move |done| match done {
                Ok(()) => told.set(done_so),
                Err(notice) => send.emit(Action::File(FileAction::Refuse(notice))),
            });
        })
    };
    let link = press(tr!("link"), props.link.clone(), tr!("Link copied."));
    let html = embed(&props.link, &props.name).into();
    let code = press(tr!("embed code"), html, tr!("Embed code copied."));
    let length = props.link.len();
    html! {
        <Frame title={tr!("Share")} on_close={props.on_close.clone()}>
            <p>{ tr!("Whoever opens this link sees the scene and its plan at the time shown; a question \
                  that is open is asked again. Nothing is sent anywhere: all of it is in the link.") }</p>
            if length > LONG {
                <p>{ tr!("It has {length} characters, which some programs cut: a file is safer.", length) }</p>
            }
            <div class="ask-number">
                <label for="link">{ tr!("Link") }</label>
                <input id="link" class="field" type="text" readonly=true value={props.link.clone()} />
            </div>
            <div class="dialog-foot">
                <span class="grow" role="status">{ *told }</span>
                <button class="btn ghost" onclick={props.on_lesson.clone()}>{ tr!("Make a lesson") }</button>
                <button class="btn outline" title={tr!("HTML that shows the plan inside another page")}
                    onclick={code}>{ tr!("Copy embed code") }</button>
                <button class="btn primary" onclick={link}>{ icon::show("copy") }{ tr!("Copy link") }</button>
            </div>
        </Frame>
    }
}
