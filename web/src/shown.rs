//! The state as components get it.

use std::ops::Deref;
use std::rc::Rc;

use giveway_page::State;

/// The state that is shown. Two are equal if they are the same object, so that
/// to compare them takes no time: every action makes a new one.
#[derive(Clone, Debug)]
pub struct Shown(Rc<State>);

impl Shown {
    /// Takes a state in.
    pub fn new(state: State) -> Self {
        Self(Rc::new(state))
    }
}

impl PartialEq for Shown {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }
}

impl Deref for Shown {
    type Target = State;

    fn deref(&self) -> &State {
        &self.0
    }
}
