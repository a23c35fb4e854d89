//! What is pasted anywhere but into a field: it is opened as a file is.

use giveway_model::{tr, tr_data};
use giveway_page::area::AreaAction;
use giveway_page::files::{Pasted, pasted};
use giveway_page::robots::RobotsAction;
use giveway_page::{Action, FileAction, IntakeAction, Notice, State};
use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use wasm_bindgen_futures::JsFuture;
use web_sys::ClipboardEvent;
use yew::platform::spawn_local;
use yew::prelude::*;

use crate::dialog::Panel;
use crate::keys::{FIELDS, dialog_is_open, is_in};
use crate::newest::Newest;
use crate::{Shown, files, support};

/// Listens for what is pasted; not inside another page, where nothing is edited.
#[hook]
pub(crate) fn use_paste(
    newest: &Newest,
    send: &Callback<Action>,
    show: &Callback<Panel>,
    is_embedded: bool,
) {
    let (newest, send, show) = (newest.clone(), send.clone(), show.clone());
    use_effect_with((), move |()| {
        let window = gloo::utils::window();
        let options = EventListenerOptions::enable_prevent_default();
        let listen = move |event: &web_sys::Event| {
            let Some(data) = wanted(event).and_then(ClipboardEvent::clipboard_data) else {
                return;
            };
            let text = data.get_data("text/plain").unwrap_or_default();
            let copied = data.files().filter(|files| files.length() > 0);
            if copied.is_some() {
                let state = newest.get();
                files::open(&state, copied, send.clone(), show.clone());
            } else if !text.trim().is_empty() {
                let in_table = is_in(event, ".rgrid");
                take(&newest.get(), &text, in_table, &send, &show);
            } else {
                return;
            }
            event.prevent_default();
        };
        let listening = (!is_embedded)
            .then(|| EventListener::new_with_options(&window, "paste", options, listen));
        move || drop(listening)
    });
}

/// Opens a text; what the page does not read by itself is left to the reader.
fn take(
    state: &State,
    text: &str,
    in_table: bool,
    send: &Callback<Action>,
    show: &Callback<Panel>,
) {
    if giveway_page::area::is_copied(state, text) {
        return send.emit(Action::Area(AreaAction::Paste));
    }
    if in_table || state.takes_robots(text) {
        let robots = RobotsAction::Paste(text.to_owned(), in_table);
        return send.emit(Action::Robots(robots));
    }
    match pasted(state, text) {
        Ok(Pasted::File(files)) => send.emit(Action::Intake(IntakeAction::Read(files))),
        Ok(Pasted::Read(reading)) => files::take(Ok(reading), send, show),
        Err(notice) => files::take(Err(notice), send, show),
    }
}

fn wanted(event: &web_sys::Event) -> Option<&ClipboardEvent> {
    if event.default_prevented() || dialog_is_open() || is_in(event, FIELDS) {
        return None;
    }
    event.dyn_ref()
}

/// Asks the browser for what was copied, and opens it.
pub(crate) fn ask(state: &Shown, send: Callback<Action>, show: Callback<Panel>) {
    let refused = Notice::refusal(tr_data!(
        "The browser did not let the page read what was copied."
    ))
    .with([tr!("Press Ctrl V instead.").to_owned()]);
    let Some(clipboard) = support::clipboard("readText") else {
        return send.emit(Action::File(FileAction::Tell(refused)));
    };
    let read = clipboard.read_text();
    let state: State = (**state).clone();
    spawn_local(async move {
        match JsFuture::from(read).await {
            Ok(text) => {
                let text = text.as_string().unwrap_or_default();
                take(&state, &text, false, &send, &show);
            }
            Err(_) => send.emit(Action::File(FileAction::Tell(refused))),
        }
    });
}
