//! A lesson that is written goes out: as a file, as a link, onto the page.

use std::rc::Rc;

use giveway_course::author::Draft;
use giveway_course::lesson::{Lesson, link, write_lesson};
use giveway_model::format::link::{plan, scene, seal};
use giveway_model::{Fault, tr};
use gloo::file::Blob;
use yew::prelude::*;

use super::AuthorMsg;
use crate::dialog::Frame;
use crate::{copy, files};

/// From so many characters on, a link is too long for some programs.
const LONG: usize = 8000;
/// The most faults that are told.
const TOLD: usize = 8;
/// The most characters of a file's name.
const LONGEST_NAME: usize = 40;

/// Hands the lesson to the browser as a file; tells its name, and where its tasks were not
/// checked.
pub(super) fn save(lesson: &Lesson, is_checked: bool) -> String {
    let name = format!("{}.json", short(&lesson.title));
    let text = write_lesson(lesson);
    files::save_as(
        &name,
        Blob::new_with_options(text.as_str(), Some("application/json")),
    );
    if is_checked {
        tr!("Saved as {name}.", name)
    } else {
        tr!(
            "Saved as {name}. The solver has not tried all of its tasks; {button} has it try them.",
            name,
            button = tr!("Copy link")
        )
    }
}

/// A name of a file: small letters, digits and hyphens.
fn short(title: &str) -> String {
    let mut name = String::new();
    for c in title.to_lowercase().chars().take(LONGEST_NAME) {
        if c.is_alphanumeric() {
            name.push(c);
        } else if !name.is_empty() && !name.ends_with('-') {
            name.push('-');
        }
    }
    let name = name.trim_end_matches('-');
    if name.is_empty() { "lesson" } else { name }.to_owned()
}

/// Copies the link of a lesson, then tells how that went.
pub(super) fn copy(lesson: &Lesson, tell: Callback<String>) {
    let location = gloo::utils::window().location();
    let origin = location.origin().unwrap_or_default();
    let path = location.pathname().unwrap_or_default();
    let text = format!("{origin}{path}#lesson={}", link::write(lesson, None));
    let length = text.len();
    copy::text(tr!("link"), &text, move |done| {
        tell.emit(match done {
            Ok(()) if length > LONG => tr!(
                "Link copied. It has {length} characters, which some programs cut: a file is safer.",
                length
            ),
            Ok(()) => tr!("Link copied.").to_owned(),
            Err(notice) => {
                let details = notice.details().join(" ");
                format!("{} {details}", notice.sentence())
            }
        });
    });
}

/// Puts the board of the step onto the page, as a link to it would; whether there is
/// one.
pub(super) fn show_on_page(draft: &Draft) -> bool {
    let Some(board) = draft.scene(draft.at()) else {
        return false;
    };
    let mut text = scene::write(board);
    let shown = draft.step().and_then(|step| step.plan());
    if let Some(written) = shown.and_then(|shown| plan::write(&board.agents, shown)) {
        text += "&plan=";
        text += &written;
    }
    let location = gloo::utils::window().location();
    location.set_hash(&seal::write(&text)).is_ok()
}

/// A lesson that came and cannot be opened. Each has a number, and a dialog of its own.
#[derive(Clone, PartialEq)]
pub(in crate::course) struct Refusal {
    pub(super) number: u32,
    /// What is wrong.
    pub(super) faults: Rc<[Fault]>,
}

#[derive(Clone, PartialEq, Properties)]
pub(in crate::course) struct RefusedProps {
    pub(super) refusal: Refusal,
    /// Takes that it was read.
    pub(super) send: Callback<AuthorMsg>,
}

/// What is wrong with a lesson that came as a file or in a link.
#[component]
pub(in crate::course) fn Refused(props: &RefusedProps) -> Html {
    let Refusal { number, faults } = props.refusal.clone();
    let close = props.send.reform(move |()| AuthorMsg::Dismiss(number));
    let more = faults.len().saturating_sub(TOLD);
    html! {
        <Frame title={tr!("This lesson cannot be opened")} reads=true on_close={close}>
            <p>{ tr!("Your own scene stays as it is.") }</p>
            <ul class="wrongs" role="alert">
                { for faults.iter().take(TOLD).map(|fault| html! { <li>{ fault.to_string() }</li> }) }
                if more > 0 { <li>{ tr!("and {n} more fault" | "and {n} more faults" % more) }</li> }
            </ul>
        </Frame>
    }
}
