//! The state as components get it.

use std::ops::Deref;
use std::rc::Rc;

use giveway_page::{Action, BoardAction, State, reduce};

/// The state that is shown. Two are equal if they are the same object, so that
/// to compare them takes no time: every action makes a new one.
#[derive(Clone, Debug)]
pub struct Shown {
    state: Rc<State>,
    /// The state before the stroke went on to where it is.
    settled: Rc<State>,
}

impl Shown {
    /// Takes a state in.
    pub fn new(state: State) -> Self {
        let state = Rc::new(state);
        Self {
            settled: Rc::clone(&state),
            state,
        }
    }

    /// The next state.
    #[must_use]
    pub fn reduced(&self, action: Action) -> Self {
        let goes_on = matches!(action, Action::Board(BoardAction::Drag(_)));
        let is_same_elsewhere = goes_on && self.state.has_stroke();
        let next = Self::new(reduce(&self.state, action));
        if is_same_elsewhere {
            return Self {
                settled: Rc::clone(&self.settled),
                ..next
            };
        }
        next
    }

    /// The state for places that show nothing of a stroke on its way: it stays the
    /// same while a stroke goes on from cell to cell.
    #[must_use]
    pub fn settled(&self) -> Self {
        Self {
            state: Rc::clone(&self.settled),
            settled: Rc::clone(&self.settled),
        }
    }
}

impl PartialEq for Shown {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.state, &other.state)
    }
}

impl Deref for Shown {
    type Target = State;

    fn deref(&self) -> &State {
        &self.state
    }
}
