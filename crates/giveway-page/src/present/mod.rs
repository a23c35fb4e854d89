//! The page before a room full of people: the board as large as it fits, what plays it,
//! and below them one question with its answer, or what a lesson says.

mod keys;
mod third;

use crate::{Action, State, Tool, ViewAction};

pub(crate) use keys::pressed;
pub use third::{Third, third};

/// Whether the page is shown to a room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presenting {
    /// It is not: all places are there.
    #[default]
    Off,
    /// The board, and below it what is said of it.
    Told,
    /// The board alone.
    Bare,
}

/// Begins it.
pub const BEGIN: Action = Action::View(ViewAction::Present(Presenting::Told));
/// Ends it.
pub const END: Action = Action::View(ViewAction::Present(Presenting::Off));

impl State {
    /// Whether the page is shown to a room.
    pub fn is_presented(&self) -> bool {
        self.view.presenting != Presenting::Off
    }
}

/// Begins, ends, or hides what is said. A hand on the board only points then.
pub(crate) fn present(state: &mut State, to: Presenting) {
    state.view.presenting = to;
    state.view.tool = Tool::Select;
    state.view.find = None;
    state.inside.is_open = false;
}
