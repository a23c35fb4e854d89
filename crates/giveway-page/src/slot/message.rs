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
}

impl Kind {
    /// The icon beside it.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Alert => "warning",
            Self::Kept | Self::Changed => "kept",
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
    /// Whether it is the one next step.
    pub is_filled: bool,
    /// What it does.
    pub press: Press,
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
}

/// A button that is not the one next step.
pub(super) fn button(name: &'static str, icon: Option<&'static str>, press: Press) -> Button {
    Button {
        name,
        icon,
        is_filled: false,
        press,
    }
}
