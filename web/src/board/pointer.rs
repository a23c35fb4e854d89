//! Where the pointer is on the board, for what follows it without a rendering of the page.

use std::cell::Cell as Value;
use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::Cell;
use yew::prelude::*;

use crate::held::Held;

/// What is under the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct At {
    pub(super) cell: Cell,
    /// The agent seen there, by its index on the board.
    pub(super) agent: Option<usize>,
}

/// The pointer: a mouse, a finger that rests, or the cell of the keyboard after a while.
#[derive(Default)]
pub(super) struct Pointer {
    now: Value<Option<At>>,
    listeners: Held<BTreeMap<u64, Callback<Option<At>>>>,
    next: Value<u64>,
    /// Whether a finger rests: when it goes up, nothing is selected.
    pub(super) rests: Value<bool>,
}

impl PartialEq for Pointer {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Pointer {
    /// It is there now, or nowhere.
    pub(super) fn set(&self, at: Option<At>) {
        if self.now.replace(at) != at {
            for listener in self.listeners.get().values() {
                listener.emit(at);
            }
        }
    }
}

/// What is under the pointer; the component is rendered anew when that changes.
#[hook]
pub(super) fn use_pointed(pointer: &Rc<Pointer>) -> Option<At> {
    let pointed = use_state_eq(|| None);
    {
        let setter = pointed.setter();
        use_effect_with(Rc::clone(pointer), move |pointer| {
            let id = pointer.next.get();
            pointer.next.set(id + 1);
            let mut listeners = pointer.listeners.take();
            listeners.insert(id, Callback::from(move |at| setter.set(at)));
            pointer.listeners.set(listeners);
            let pointer = Rc::clone(pointer);
            move || {
                let mut listeners = pointer.listeners.take();
                drop(listeners.remove(&id));
                pointer.listeners.set(listeners);
            }
        });
    }
    *pointed
}
