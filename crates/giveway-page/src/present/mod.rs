//! The page before a room full of people: the board as large as it fits, what plays it,
//! and below them one question with its answer, or what a lesson says.

mod keys;
mod third;

use crate::{Action, State, Tool, ViewAction};

pub(crate) use keys::pressed;
pub use third::{Cause, Third, third};

/// Whether the page is shown to a room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presenting {
    /// It is not: all places are there.
    #[default]
    Off,
    /// The board with its headline, and below it the question with its answer.
    Told,
    /// The board with the plan that plays; nothing of any answer.
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

    /// Whether all answers are hidden from the room: the headline with its costs, claims,
    /// marks of reasons, and other plans.
    pub fn hides_answers(&self) -> bool {
        self.view.presenting == Presenting::Bare
    }
}

/// Begins, ends, or hides the answers. A hand on the board only points then.
pub(crate) fn present(state: &mut State, to: Presenting) {
    state.view.presenting = to;
    state.view.tool = Tool::Select;
    state.view.find = None;
    if state.inside.is_open {
        state.inside.is_open = false;
        let time = state.inside.time_before.take();
        state.view.playback.time = time.unwrap_or(state.view.playback.time);
    }
    // The other plan of an answer may take longer than the one that is left.
    state.view.playback.time = state.view.playback.time.min(state.last_time());
}
