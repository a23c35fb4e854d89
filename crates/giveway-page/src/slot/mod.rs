//! What the page says without being asked, one thing at a time, in the row under
//! the board: that something was kept, could not be kept, or was changed elsewhere; and
//! on a first visit, what this page is.

mod differ;
mod message;
mod waiting;
mod welcome;

use std::rc::Rc;

use crate::{Action, By, Draft, FileAction, State};

pub(crate) use differ::difference;
pub use message::{Button, Kind, Message, Press, Weight};
pub use waiting::{Elsewhere, Lost, Other, SlotAction, Unkept, Waiting};

use giveway_model::tr;
use message::button;

/// What is to be said now, if there is anything: kept data first, then a link, then
/// another tab, a link that cannot be checked, and last a welcome.
pub fn message(state: &State) -> Option<Message> {
    let waiting = &state.view.waiting;
    if state.is_embedded() {
        return None;
    }
    let lost = waiting.lost.map(lost);
    let unkept = || waiting.unkept.map(unkept);
    let other = || waiting.other.as_ref().map(|other| elsewhere(state, other));
    lost.or_else(unkept)
        .or_else(|| displaced(state))
        .or_else(other)
        .or_else(|| waiting.unchecked.then(|| unchecked(state)))
        .or_else(|| waiting.welcome.then(welcome::message))
}

fn lost(why: Lost) -> Message {
    let (title, text) = match why {
        Lost::Newer => (
            tr!("We could not read what was kept"),
            tr!(
                "A newer version of this page has written it. Nothing was deleted: that version can \
             still read it. What you see now is an example."
            ),
        ),
        Lost::Damaged => (
            tr!("We could not read what was kept"),
            tr!(
                "Nothing was deleted. Download it, and a later version may read it. What you see now \
             is an example."
            ),
        ),
        Lost::Breaks => (
            tr!("The page broke down when it opened what was kept"),
            tr!(
                "Nothing was deleted. Download it, and a later version may open it. What you see now \
             is an example."
            ),
        ),
    };
    Message {
        kind: Kind::Alert,
        title,
        text: text.to_owned(),
        boards: None,
        buttons: vec![
            Button {
                weight: Weight::Filled,
                ..button(tr!("Download it"), Some("save"), Press::Download)
            },
            button(tr!("Start afresh"), None, Press::StartAfresh),
        ],
        close: None,
    }
}

fn unkept(why: Unkept) -> Message {
    let text = match why {
        Unkept::Full => {
            tr!(
                "This browser has no room left for it. Download it, or forget scenes that you no \
             longer need."
            )
        }
        Unkept::Refused => {
            tr!("This browser does not let the page keep anything. Download it before you leave.")
        }
    };
    Message {
        kind: Kind::Alert,
        title: tr!("Your work is not being kept"),
        text: text.to_owned(),
        boards: None,
        buttons: vec![Button {
            weight: Weight::Filled,
            ..button(tr!("Download it"), Some("save"), Press::Save)
        }],
        close: Some(Action::Slot(SlotAction::Close)),
    }
}

fn displaced(state: &State) -> Option<Message> {
    let displaced = state.displaced.as_ref()?;
    let name = quoted(&displaced.moment.document.draft);
    let (title, mut text) = match displaced.by {
        By::Link => (
            tr!("Your own scene is kept"),
            tr!(
                "This one came with the link. Yours, {name}, is where you left it.",
                name
            ),
        ),
        By::Own => (
            tr!("The scene of the link is kept"),
            tr!(
                "You are back at your own scene. The one of the link is {name}.",
                name
            ),
        ),
    };
    if state.view.waiting.unchecked {
        text.push(' ');
        text += &no_check(state);
    }
    let back = Press::Act(Box::new(Action::File(FileAction::Back)));
    Some(Message {
        kind: Kind::Kept,
        title,
        text,
        boards: None,
        buttons: vec![button(tr!("Back to it"), Some("back"), back)],
        close: Some(Action::File(FileAction::Keep)),
    })
}

fn unchecked(state: &State) -> Message {
    Message {
        kind: Kind::Unchecked,
        title: tr!("Is this the whole link?"),
        text: no_check(state),
        boards: None,
        buttons: Vec::new(),
        close: Some(Action::Slot(SlotAction::Close)),
    }
}

/// What is known of a link without a check.
fn no_check(state: &State) -> String {
    let robots = tr!("{n} robot" | "{n} robots" % state.document.draft.agents().len());
    tr!(
        "The link is of an earlier version and carries no check sum, so the page cannot see \
         whether it was cut. {robots} arrived.",
        robots
    )
}

fn elsewhere(state: &State, other: &Other) -> Message {
    let act = |name, action| button(name, None, Press::Act(Box::new(action)));
    let close = Action::Slot(SlotAction::Close);
    let (text, boards, buttons, close) = match other {
        Other::Apart { moment, .. } => (
            tr!(
                "{difference} Undo brings back the one you do not take.",
                difference = difference(&state.document, &moment.document)
            ),
            Some([
                Rc::clone(&state.document.draft),
                Rc::clone(&moment.document.draft),
            ]),
            vec![
                act(tr!("Take theirs"), Action::Slot(SlotAction::TakeTheirs)),
                act(tr!("Keep mine"), Action::Slot(SlotAction::KeepMine)),
            ],
            None,
        ),
        Other::Taken { change } => (
            tr!(
                "{change} It is shown here, too. Undo brings back what was here.",
                change
            ),
            None,
            vec![act(tr!("Undo it here"), Action::Undo)],
            Some(close),
        ),
    };
    Message {
        kind: Kind::Changed,
        title: tr!("Another tab changed this scene"),
        text,
        boards,
        buttons,
        close,
    }
}

/// The name of a scene in a sentence.
fn quoted(draft: &Draft) -> String {
    match draft.scene().name.as_str() {
        "" => tr!("which has no name yet").to_owned(),
        name => tr!("“{name}”", name),
    }
}
