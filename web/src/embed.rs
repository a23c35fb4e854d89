//! The page inside another page, at the address with `?embed`: a plan to be
//! watched. It edits nothing, keeps nothing, and takes only the keys that play.

use giveway_model::tr;
use giveway_page::link::Sharing;
use giveway_page::{Action, Notice, PlayAction, State};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::board::BoardProps;
use crate::board::Still;
use crate::part::part;
use crate::status::sentence;
use crate::timeline::play_keys;
use crate::{Shown, keep, language};

/// Whether the page is shown so; whoever embeds it may add to the address.
pub(crate) fn is_embedded() -> bool {
    let query = gloo::utils::window().location().search();
    query.is_ok_and(|query| query.split(['?', '&']).any(|part| part == "embed"))
}

/// The sentence, the board, what plays, and the way to the whole page.
pub(crate) fn show(state: &Shown, send: &Callback<Action>) -> Html {
    // The whole page opens in the language of the embed, where that has one.
    let language = language::linked().map_or("", |_| language::spoken());
    let sharing = Sharing {
        language,
        ..Sharing::default()
    };
    let link = sharing.link(&keep::address(state));
    if let Some(notice) = state
        .view
        .notice
        .as_ref()
        .filter(|_| state.view.waiting.refused)
    {
        return refused(notice);
    }
    html! {
        <>
            <header class="status">{ sentence(state) }</header>
            { part::<Still>(BoardProps { state: state.clone(), send: send.clone() }) }
            <footer class="dock">
                <h1>{ title(state) }</h1>
                <a href={link} target="_blank" rel="noopener">{ tr!("Open in Giveway") }</a>
                if state.plan().is_some() {
                    { play_keys(state, send) }
                    { slider(state, send) }
                }
            </footer>
        </>
    }
}

/// The link of the page around cannot be opened: nothing else is shown in its place.
fn refused(notice: &Notice) -> Html {
    let location = gloo::utils::window().location();
    let page = location.pathname().unwrap_or_default();
    html! {
        <div class="refused" role="alert">
            <p><b>{ tr!("This scene cannot be shown.") }</b></p>
            { for notice.details().into_iter().map(|line| html! { <p>{ line }</p> }) }
            <p><a href={page} target="_blank" rel="noopener">{ tr!("Open Giveway") }</a></p>
        </div>
    }
}

pub(crate) fn title(state: &State) -> String {
    match state.document.draft.scene().name.as_str() {
        "" => tr!("Untitled"),
        name => name,
    }
    .to_owned()
}

/// The time shown; the browser's own slider has its keys, too.
pub(crate) fn slider(state: &State, send: &Callback<Action>) -> Html {
    let (time, last) = (state.view.playback.time, state.last_time());
    let seek = send.reform(|event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        Action::Play(PlayAction::Seek(input.value().parse().unwrap_or(0)))
    });
    html! {
        <>
            <input type="range" aria-label={tr!("Time")} min="0" max={last.to_string()} step="1"
                value={time.to_string()} aria-valuetext={tr!("{time} of {last}", time, last)} oninput={seek} />
            <output aria-hidden="true">{ format!("{time} / {last}") }</output>
        </>
    }
}
