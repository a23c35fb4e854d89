//! Undo and redo.

use std::rc::Rc;

use crate::changing::Changing;
use crate::steering::Steering;
use crate::{Answer, Draft};

/// The most steps that are kept.
const DEPTH: usize = 200;

/// What a step of undo brings back.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Moment {
    /// A scene; the answer stays, and may be stale.
    Scene(Rc<Draft>),
    /// A plan of the scene as it is, with what was changing around it, or the plan
    /// of one's own that was made of it.
    Course {
        answer: Option<Rc<Answer>>,
        changing: Option<Rc<Changing>>,
        steering: Option<Rc<Steering>>,
    },
}

/// What was before and after the present.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    past: Vec<Moment>,
    future: Vec<Moment>,
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

    /// Takes in what was replaced; what was undone is lost.
    pub(crate) fn record(&mut self, before: Moment) {
        self.future.clear();
        self.past.push(before);
        if self.past.len() > DEPTH {
            self.past.remove(0);
        }
    }

    /// What was before; `present` gives the same kind of what is now.
    pub(crate) fn undo(&mut self, present: impl FnOnce(&Moment) -> Moment) -> Option<Moment> {
        let before = self.past.pop()?;
        self.future.push(present(&before));
        Some(before)
    }

    /// What was undone last.
    pub(crate) fn redo(&mut self, present: impl FnOnce(&Moment) -> Moment) -> Option<Moment> {
        let after = self.future.pop()?;
        self.past.push(present(&after));
        Some(after)
    }
}
