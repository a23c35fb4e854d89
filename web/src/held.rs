//! What a component holds from one rendering to the next, and what the page's
//! parts hold between two events.
//!
//! It is handed out whole and never lent: while the browser is called, no borrow
//! is open. A browser may lack what is called, and an exception leaves Rust without
//! ending borrows: one that was open then would stay open, and the next event
//! would find what it needs locked for ever. `web/clippy.toml` forbids to borrow
//! from a `RefCell` anywhere else.

use std::cell::RefCell;
use std::rc::Rc;

use yew::prelude::*;

/// A value that is taken, set and copied, but never borrowed.
#[derive(Default)]
pub(crate) struct Held<T>(RefCell<T>);

impl<T> Held<T> {
    /// Holds a value.
    pub(crate) const fn new(value: T) -> Self {
        Self(RefCell::new(value))
    }

    /// Holds this from now on; what was held is dropped afterwards.
    pub(crate) fn set(&self, value: T) {
        drop(self.0.replace(value));
    }
}

impl<T: Clone> Held<T> {
    /// A copy of what is held. To copy must not call the browser.
    #[expect(
        clippy::disallowed_methods,
        reason = "the borrow ends before this returns"
    )]
    pub(crate) fn get(&self) -> T {
        self.0.borrow().clone()
    }
}

impl<T: Default> Held<T> {
    /// What is held; from now on that is nothing.
    pub(crate) fn take(&self) -> T {
        self.0.take()
    }
}

/// Holds a value for a component, from its first rendering on.
#[hook]
pub(crate) fn use_held<T: 'static>(first: impl FnOnce() -> T) -> Rc<Held<T>> {
    use_memo((), |()| Held::new(first()))
}
