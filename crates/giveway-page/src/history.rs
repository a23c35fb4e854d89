//! Undo and redo.

use std::rc::Rc;

use crate::Draft;

/// The most steps that are kept.
const DEPTH: usize = 200;

/// The scenes before and after the present one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    past: Vec<Rc<Draft>>,
    future: Vec<Rc<Draft>>,
}

impl History {
    /// Whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes in the scene that an edit replaced; what was undone is lost.
    pub(crate) fn record(&mut self, before: Rc<Draft>) {
        self.future.clear();
        self.past.push(before);
        if self.past.len() > DEPTH {
            self.past.remove(0);
        }
    }

    /// The scene before the present one.
    pub(crate) fn undo(&mut self, present: Rc<Draft>) -> Option<Rc<Draft>> {
        let before = self.past.pop()?;
        self.future.push(present);
        Some(before)
    }

    /// The scene that was undone last.
    pub(crate) fn redo(&mut self, present: Rc<Draft>) -> Option<Rc<Draft>> {
        let after = self.future.pop()?;
        self.past.push(present);
        Some(after)
    }
}
