//! The head of the editor: what is kept, what can be undone, other lessons.

use giveway_course::author::Action;
use giveway_model::tr;
use gloo::file::File;
use gloo::file::futures::read_as_text;
use web_sys::HtmlInputElement;
use yew::platform::spawn_local;
use yew::prelude::*;

use super::desk::DeskProps;
use super::{AuthorMsg, Notes};
use crate::icon;

/// The head.
pub(super) fn show(props: &DeskProps, write: &Callback<AuthorMsg>) -> Html {
    let close = write.reform(|_: MouseEvent| AuthorMsg::Close);
    let fresh = write.reform(|_: MouseEvent| AuthorMsg::Act(Action::New));
    let undo = write.reform(|_: MouseEvent| AuthorMsg::Act(Action::Undo));
    let take = write.reform(|_: MouseEvent| AuthorMsg::TakeElsewhere);
    let chosen = {
        let write = write.clone();
        move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let file = input.files().and_then(|files| files.get(0));
            // So that the same file can be opened again.
            input.set_value("");
            let (Some(file), write) = (file, write.clone()) else {
                return;
            };
            spawn_local(async move {
                let read = read_as_text(&File::from(file)).await;
                write.emit(match read {
                    Ok(text) => AuthorMsg::File(text),
                    Err(error) => AuthorMsg::Told(error.to_string()),
                });
            });
        }
    };
    let line = match props.notes {
        Notes {
            is_unkept: true, ..
        } => {
            tr!("This browser does not keep what you write: save it as a file before you leave.")
        }
        _ => tr!("Kept in this browser while you write."),
    };
    html! {
        <>
        <header class="sh">
            <div><h2 id="author-title">{ tr!("Write a lesson") }</h2><p>{ line }</p></div>
            <span class="grow"></span>
            if let Some(undo_what) = props.draft.can_undo() {
                <span class="quiet">{ undo_what.sentence() }</span>
                <button type="button" class="btn ghost" onclick={undo}>{ icon::show("undo") }<span>{ tr!("Undo") }</span></button>
            }
            <label class="btn ghost filed">{ icon::show("open") }<span>{ tr!("Open a file") }</span>
                <input class="vh" type="file" accept=".json,application/json" onchange={chosen} />
            </label>
            <button type="button" class="btn ghost" disabled={props.draft.is_empty()} onclick={fresh}>{ icon::show("plus") }<span>{ tr!("New lesson") }</span></button>
            <button type="button" class="btn ghost round" title={tr!("Close (Escape)")} onclick={close}>
                { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
            </button>
        </header>
        if props.notes.is_elsewhere {
            <p class="aside-note" role="status">{ tr!("This lesson was also changed in another tab. What is written last stays.") }
                <button type="button" class="link" onclick={take}>{ tr!("Take what is written there") }</button></p>
        }
        </>
    }
}
