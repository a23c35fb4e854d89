//! The dialog that shares a link or an embed: with the plan or the scene alone, and in
//! which language.

use giveway_model::tr;
use giveway_page::link::{Sharing, embed};
use giveway_page::{Action, FileAction};
use web_sys::HtmlSelectElement;
use yew::prelude::*;

use super::frame::Frame;
use crate::{copy, icon, language};

/// From so many characters on, a link is too long for some programs.
const LONG: usize = 8000;
/// The value of the choice that hides the answer.
const SCENE: &str = "scene";

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ShareProps {
    /// The link that holds everything.
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
    let sharing = use_state_eq(Sharing::default);
    let press = |what: &'static str, text: AttrValue, done_so: &'static str| {
        let (send, told) = (props.send.clone(), told.clone());
        Callback::from(move |_: MouseEvent| {
            let (send, told) = (send.clone(), told.clone());
            copy::text(what, &text, move |done| match done {
                Ok(()) => told.set(done_so),
                Err(notice) => send.emit(Action::File(FileAction::Tell(notice))),
            });
        })
    };
    let choose = |with: fn(Sharing, &str) -> Sharing| {
        let (sharing, told) = (sharing.clone(), told.clone());
        Callback::from(move |event: Event| {
            let select: HtmlSelectElement = event.target_unchecked_into();
            sharing.set(with(*sharing, &select.value()));
            // What was copied is another link.
            told.set("");
        })
    };
    let shown = AttrValue::from(sharing.link(&props.link));
    let hidden = Sharing {
        hides_answer: true,
        language: "",
    };
    let has_answer = hidden.link(&props.link) != *props.link;
    let link = press(tr!("link"), shown.clone(), tr!("Link copied."));
    let html = embed(&shown, &props.name).into();
    let code = press(tr!("embed code"), html, tr!("Embed code copied."));
    let length = shown.len();
    html! {
        <Frame title={tr!("Share")} on_close={props.on_close.clone()}>
            if sharing.hides_answer {
                <p>{ tr!("Whoever opens this link sees the scene alone: its plan, the costs and all that was proved are not \
                      in the link. Nothing is sent anywhere.") }</p>
            } else {
                <p>{ tr!("Whoever opens this link sees the scene and its plan at the time shown; a question \
                      that is open is asked again. Nothing is sent anywhere: all of it is in the link.") }</p>
            }
            if length > LONG {
                <p>{ tr!("It has {length} characters, which some programs cut: a file is safer.", length) }</p>
            }
            if has_answer {
                <div class="ask-number">
                    <label for="share-what">{ tr!("What it shows") }</label>
                    <select id="share-what" class="field" onchange={choose(hide)}>
                        <option value="" selected={!sharing.hides_answer}>{ tr!("With its plan") }</option>
                        <option value={SCENE} selected={sharing.hides_answer}>{ tr!("Scene only: the answer stays hidden") }</option>
                    </select>
                </div>
            }
            <div class="ask-number">
                <label for="share-language">{ tr!("Language") }</label>
                <select id="share-language" class="field" onchange={choose(speak)}>
                    <option value="" selected={sharing.language.is_empty()}>{ tr!("Reader\u{2019}s own language") }</option>
                    { for language::all().map(|(tag, name)| html! {
                        <option value={tag} lang={tag} selected={sharing.language == tag}>{ name }</option>
                    }) }
                </select>
            </div>
            <div class="ask-number">
                <label for="link">{ tr!("Link") }</label>
                <input id="link" class="field" type="text" readonly=true value={shown} />
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

fn hide(sharing: Sharing, chosen: &str) -> Sharing {
    Sharing {
        hides_answer: chosen == SCENE,
        ..sharing
    }
}

fn speak(sharing: Sharing, chosen: &str) -> Sharing {
    let tag = language::all()
        .map(|(tag, _)| tag)
        .find(|tag| *tag == chosen);
    Sharing {
        language: tag.unwrap_or_default(),
        ..sharing
    }
}
