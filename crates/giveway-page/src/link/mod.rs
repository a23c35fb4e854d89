//! A document as one line of text: for a link, and for what the browser keeps.
//! Short, bounded, and read with distrust.
//!
//! ```text
//! giveway=1&check=231.9ae0daaf&map=10.2f6s2f...&name=warehouse&rules=0.0&costs=012&agents=A1.0.0.9.2!10.10;...
//! &plan=2rR...;...&knows=4&slept=1.4;&time=7&ask=wait;A2!at.3.1
//! ```

mod answers;
mod arrived;
mod ask;
mod audit;
mod book;
mod change;
mod claim;
mod document;
mod found;
mod kin;
mod knowledge;
mod preferences;
mod read;
mod share;
mod steering;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;

use giveway_model::format::link::{
    lesson as link_lesson, message, plan, repair, scene, seal, text,
};
use giveway_model::{Question, tr_data};
use giveway_solve::Status;

use crate::{Action, Document, FileAction, Notice, State};

pub use book::{keep, keep_moment, kept, kept_elsewhere, kept_moment};
pub use kin::{Kin, is_newer, is_touched, kin, title};
pub use preferences::{are_newer, prefer, preferences};
pub(crate) use read::{changing, judged};
pub use share::{Sharing, embed, language, whole_page, without_language};

pub use giveway_model::format::link::LONGEST;

/// The verdict that a link tells: no plan exists.
const IMPOSSIBLE: &str = "impossible";

/// What a link holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Linked {
    /// The document; its plan was judged.
    pub(crate) document: Document,
    /// The time shown, in steps.
    pub(crate) time: u32,
    /// The question to be asked: of the plan, or why there is none.
    pub(crate) question: Option<Question>,
    /// Whether whoever made it had the verdict that no plan exists; it is not believed, but
    /// found again.
    pub(crate) was_impossible: bool,
    /// Where it came from.
    pub(crate) source: Source,
    /// Whether a check shows that all of it arrived; links of earlier versions have none.
    pub(crate) is_checked: bool,
}

/// Where a document came from that takes the place of another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A link: whoever follows one need not know that it replaces anything.
    Link,
    /// A file, which a person chose.
    File,
}

/// Whose text it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    /// From anywhere: what it claims of a plan is not believed.
    Anywhere,
    /// From this browser, which kept it for the page.
    Here,
}

/// The state as the part of a link after `#`.
///
/// ```
/// use giveway_page::{Draft, State, link};
/// let text = link::write(&State::new(Draft::default()));
/// assert_eq!(text, "giveway=1&check=35.035698fb&map=1.f&rules=0.0&costs=012&agents=");
/// assert!(link::read(&text, link::From::Anywhere).is_ok());
/// ```
pub fn write(state: &State) -> String {
    let document = &state.document;
    let mut text = document::write(document, From::Anywhere);
    if state.view.playback.time > 0 && document.plan().is_some() {
        // Writing to a string cannot fail.
        let _ = write!(text, "&time={}", state.view.playback.time);
    }
    let answer = document.fresh_answer();
    if answer.is_some_and(|answer| answer.solved.status == Status::Impossible) {
        text += "&verdict=";
        text += IMPOSSIBLE;
    }
    if let Some(asking) = document.mode.asking() {
        text += "&ask=";
        text += &ask::write(asking.question());
    }
    seal::write(&text)
}

/// Reads what [`write()`] wrote. What programs did to a link from anywhere is undone; a
/// link that was cut or changed is refused.
///
/// # Errors
/// Why it cannot be read, in sentences.
pub fn read(text: &str, from: From) -> Result<Linked, Notice> {
    let read = match from {
        From::Anywhere => arrived::read(text),
        From::Here => read::Reader::default()
            .read(text, from)
            .map_err(|why| vec![why]),
    };
    read.map_err(|details| {
        Notice::refusal(tr_data!(
            "The link cannot be opened. Your scene stays as it is."
        ))
        .with(details)
    })
}

/// Whether a text is a link of the page or seems to be one, perhaps cut or encoded: it is
/// opened, or it is said why not.
pub fn is_link(text: &str) -> bool {
    repair::seems_link(text)
}

/// The lesson that a text names as a link does, `lesson=room-to-pass.2`.
pub fn lesson(text: &str) -> Option<String> {
    link_lesson::named(text)
}

/// What happens when a link is opened.
pub fn open(text: &str) -> Action {
    Action::File(match read(text, From::Anywhere) {
        Ok(linked) => FileAction::OpenLink(Box::new(linked)),
        Err(notice) => FileAction::RefuseLink(notice),
    })
}
