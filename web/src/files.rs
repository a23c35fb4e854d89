//! Files from a person's disk and from beside the page, and files to save.

use std::rc::Rc;

use giveway_model::{tr, tr_data};
use giveway_page::files::{
    Opened, Reading, Saved, are_hand_ins, picture_name, read_beside, robots_file, sizing_file,
    too_large,
};
use giveway_page::floor_plan::brought;
use giveway_page::{Action, FileAction, IntakeAction, Notice, State};
use gloo::file::{Blob, File, ObjectUrl, futures::read_as_bytes};
use gloo::net::http::Request;
use gloo::timers::callback::Timeout;
use js_sys::Array;
use wasm_bindgen::JsCast as _;
use web_sys::{FileList, HtmlAnchorElement};
use yew::Callback;
use yew::platform::spawn_local;

use crate::Shown;
use crate::board;
use crate::dialog::Panel;
use crate::floor_plan;

/// Where the examples are, from the page on.
const EXAMPLES: &str = "static/examples";

/// Where the maps of the standard benchmark are.
const MAPS: &str = "static/maps";

/// Where the catalogues of languages are.
const LANGUAGES: &str = "static/languages";

/// So many bytes of a file are told to the course: more than a hand-in or a lesson may have.
const MOST_FOR_COURSE: usize = 1_100_000;

/// How long a saved file's text is kept for the browser, in milliseconds.
const KEPT_MS: u32 = 60_000;

/// The text of a file among the examples.
///
/// # Errors
/// Why it did not arrive, as a sentence.
pub(crate) async fn fetch(file: &str) -> Result<String, String> {
    fetch_text(&format!("{EXAMPLES}/{file}")).await
}

/// The text of a file of the page.
pub(crate) async fn fetch_text(address: &str) -> Result<String, String> {
    let response = Request::get(address).send().await;
    let response = response.map_err(|error| error.to_string())?;
    if !response.ok() {
        return Err(tr!(
            "{address}: status {status}",
            address,
            status = response.status()
        ));
    }
    response.text().await.map_err(|error| error.to_string())
}

/// The PO file of a language.
///
/// # Errors
/// Why it did not arrive, as a sentence.
pub(crate) async fn fetch_language(tag: &str) -> Result<String, String> {
    fetch_text(&format!("{LANGUAGES}/{tag}.po")).await
}

/// Those of the page's maps and scenarios that are there.
pub(crate) async fn fetch_maps(names: Vec<String>) -> Vec<Opened> {
    let mut files = Vec::new();
    for name in names {
        if let Ok(text) = fetch_text(&format!("{MAPS}/{name}")).await {
            let bytes = text.into_bytes();
            files.push(Opened { name, bytes });
        }
    }
    files
}

/// Reads the files that a person chose or dropped, and opens what they hold; what they
/// lack is taken from the board.
pub(crate) fn open(
    state: &Shown,
    files: Option<FileList>,
    send: Callback<Action>,
    show: Callback<Panel>,
) {
    let Some(files) = files.filter(|files| files.length() > 0) else {
        return;
    };
    let files: Vec<File> = gloo::file::FileList::from(files).to_vec();
    let state = state.clone();
    spawn_local(async move {
        match read_all(&files).await {
            Ok(opened) if are_hand_ins(&opened) => {
                show.emit(Panel::Course(for_course(&opened, &files)));
            }
            Ok(opened) => match brought(&opened) {
                Some(picture) => floor_plan::lay(picture, &send).await,
                None => read(&state, opened, &send, &show),
            },
            Err(notice) => take(Err(notice), &send, &show),
        }
    });
}

/// Files as the course takes them: a list of name, time in milliseconds, and text, as JSON. Of a
/// file that is longer than any hand-in a part tells so.
fn for_course(opened: &[Opened], files: &[File]) -> String {
    let list = Array::new();
    for (opened, file) in opened.iter().zip(files) {
        let bytes = opened.bytes.get(..MOST_FOR_COURSE);
        let text = String::from_utf8_lossy(bytes.unwrap_or(&opened.bytes));
        let time = AsRef::<web_sys::File>::as_ref(file).last_modified();
        list.push(&Array::of3(
            &opened.name.as_str().into(),
            &time.into(),
            &(&*text).into(),
        ));
    }
    js_sys::JSON::stringify(&list).map_or_else(|_| String::new(), String::from)
}

/// Opens files; those that the page does not read by itself are left to the reader.
pub(crate) fn read(
    state: &Shown,
    opened: Vec<Opened>,
    send: &Callback<Action>,
    show: &Callback<Panel>,
) {
    match read_beside(state, &opened) {
        Some(reading) => take(reading, send, show),
        None => send.emit(Action::Intake(IntakeAction::Read(opened))),
    }
}

/// Opens what was read, or tells why it cannot be.
pub(crate) fn take(
    reading: Result<Reading, Notice>,
    send: &Callback<Action>,
    show: &Callback<Panel>,
) {
    match reading {
        Ok(Reading::Scene(scene)) => send.emit(Action::File(FileAction::Open(scene))),
        Ok(Reading::Linked(together)) => {
            send.emit(Action::File(FileAction::OpenLink(Box::new(
                together.linked,
            ))));
        }
        Ok(Reading::Scenario(choice)) => show.emit(Panel::Agents(Rc::new(*choice))),
        Ok(Reading::Lesson(text)) => show.emit(Panel::Course(text)),
        Ok(Reading::Illegal(files)) => send.emit(Action::Intake(IntakeAction::Read(files))),
        Err(notice) => send.emit(Action::File(FileAction::Tell(notice))),
    }
}

async fn read_all(files: &[File]) -> Result<Vec<Opened>, Notice> {
    if let Some(notice) = files
        .iter()
        .find_map(|file| too_large(&file.name(), file.size()))
    {
        return Err(notice);
    }
    let mut opened = Vec::new();
    for file in files {
        let name = file.name();
        let bytes = read_as_bytes(file).await.map_err(|error| {
            Notice::refusal(tr_data!(
                "{name} cannot be read; the scene stays as it is.",
                name = &name
            ))
            .with([error.to_string()])
        })?;
        opened.push(Opened { name, bytes });
    }
    Ok(opened)
}

/// Hands a file to the browser to be saved.
pub(crate) fn save(saved: &Saved) {
    let blob = Blob::new_with_options(saved.text.as_str(), Some("application/json"));
    save_as(&saved.name, blob);
}

/// Hands the robots as a table to the browser to be saved.
pub(crate) fn save_robots(state: &State) {
    if let Some(saved) = robots_file(state) {
        let blob = Blob::new_with_options(saved.text.as_str(), Some("text/csv"));
        save_as(&saved.name, blob);
    }
}

/// Hands what is known of how many robots the floor bears to the browser, as a table.
pub(crate) fn save_sizing(state: &State) {
    if let Some(saved) = sizing_file(state) {
        let blob = Blob::new_with_options(saved.text.as_str(), Some("text/csv"));
        save_as(&saved.name, blob);
    }
}

/// Hands the board as it looks now to the browser to be saved, as SVG or PNG;
/// tells where that fails.
pub(crate) fn save_picture(state: &State, is_png: bool, send: Callback<Action>) {
    let name = picture_name(state, if is_png { "png" } else { "svg" });
    let title = tr!(
        "{scene}, time {time}",
        scene = state.document.draft.scene().name,
        time = state.view.playback.time
    );
    let picture = board::picture(state.world().grid(), &title);
    spawn_local(async move {
        let blob = async {
            let picture = picture?;
            if is_png {
                return picture.png().await.map(Blob::from);
            }
            let svg = picture.svg.as_str();
            Ok(Blob::new_with_options(svg, Some("image/svg+xml")))
        };
        match blob.await {
            Ok(blob) => save_as(&name, blob),
            Err(_) => send.emit(Action::File(FileAction::Tell(Notice::refusal(tr_data!(
                "The browser could not make the picture."
            ))))),
        }
    });
}

/// Hands bytes to the browser to be saved.
pub(crate) fn save_as(name: &str, blob: Blob) {
    let url = ObjectUrl::from(blob);
    let link = gloo::utils::document().create_element("a").ok();
    if let Some(link) = link.and_then(|link| link.dyn_into::<HtmlAnchorElement>().ok()) {
        link.set_href(&url);
        link.set_download(name);
        link.click();
    }
    // The browser reads it after this returns.
    Timeout::new(KEPT_MS, move || drop(url)).forget();
}
