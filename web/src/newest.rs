//! The state as it is when an event comes.
//!
//! On a slow machine Yew lets the browser handle events between two steps of a rendering: what
//! was rendered last is then older than what the reducer holds. A key or a file that was pasted
//! is meant for the state that the event before it left behind.

use yew::prelude::*;

use crate::Shown;

/// Reads what the reducer holds now, whether or not it was rendered.
#[derive(Clone, PartialEq)]
pub(crate) struct Newest(UseReducerHandle<Shown>);

impl Newest {
    /// Of the reducer of the page.
    pub(crate) fn new(shown: &UseReducerHandle<Shown>) -> Self {
        Self(shown.clone())
    }

    /// The state now.
    pub(crate) fn get(&self) -> Shown {
        // A handle keeps each state that it has read; a copy of it is gone afterwards.
        let read = self.0.clone();
        (*read).clone()
    }
}
