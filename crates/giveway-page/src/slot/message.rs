//! A message: what is said, and what can be done about it.

use std::rc::Rc;

use crate::{Action, Draft};

/// What is said.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Of what kind it is.
    pub kind: Kind,
    /// The heading.
    pub title: &'static str,
    /// One or two sentences.
    pub text: String,
    /// The scene here and the one elsewhere, to be seen side by side.
    pub boards: Option<[Rc<Draft>; 2]>,
    /// What can be done.
    pub buttons: Vec<Button>,
    /// What closes it; `None` where one of the buttons has to be pressed.
    pub close: Option<Action>,
}

/// Of what kind a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Something may be lost: it is read aloud at once.
    Alert,
    /// Something is kept.
    Kept,
    /// Something was changed.
    Changed,
    /// A link of which nobody can see whether all of it arrived.
    Unchecked,
    /// A first visit.
    Welcome,
}

impl Kind {
    /// The icon beside it, if it has one.
    pub const fn icon(self) -> Option<&'static str> {
        match self {
            Self::Alert | Self::Unchecked => Some("warning"),
            Self::Kept | Self::Changed => Some("kept"),
            Self::Welcome => None,
        }
    }
}

/// A button of a message.
#[derive(Clone, Debug, PartialEq)]
pub struct Button {
    /// What it is called.
    pub name: &'static str,
    /// The icon on it.
    pub icon: Option<&'static str>,
    /// What is said behind the name, more quietly.
    pub remark: Option<&'static str>,
    /// How much it asks to be pressed.
    pub weight: Weight,
    /// What it does.
    pub press: Press,
}

/// How much a button asks to be pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// It is the one next step.
    Filled,
    /// It is one of several.
    Outlined,
    /// It only closes the message.
    Quiet,
}

/// What a button does.
#[derive(Clone, Debug, PartialEq)]
pub enum Press {
    /// Downloads what could not be opened, as it is.
    Download,
    /// Leaves what could not be opened where it is.
    StartAfresh,
    /// Downloads the document.
    Save,
    /// An action of the page.
    Act(Box<Action>),
    /// Opens the course: its contents where this is empty, else what has this name.
    Learn(&'static str),
}

/// A button that is not the one next step.
pub(super) fn button(name: &'static str, icon: Option<&'static str>, press: Press) -> Button {
    Button {
        name,
        icon,
        remark: None,
        weight: Weight::Outlined,
        press,
    }
}
