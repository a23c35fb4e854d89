//! Undo and redo: whole documents, each with where it was looked at.

use crate::{Document, Selection};

/// The most steps that are kept.
pub(crate) const DEPTH: usize = 200;

/// A document as it was, and where it was looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The document.
    pub document: Document,
    /// The time shown, in steps.
    pub time: u32,
    /// What the inspector told of.
    pub selection: Selection,
}

/// What was before and after the present.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    past: Vec<Moment>,
    future: Vec<Moment>,
    touched: bool,
}

impl History {
    /// A history of which only the end of the past is known, the oldest moment
    /// first.
    pub(crate) const fn of(past: Vec<Moment>) -> Self {
        Self {
            past,
            future: Vec::new(),
            touched: true,
        }
    }

    /// Whether anything was ever done: else there is nothing to miss.
    pub const fn is_touched(&self) -> bool {
        self.touched
    }

    /// What was before, the oldest moment first.
    pub(crate) fn past(&self) -> &[Moment] {
        &self.past
    }

    /// Whether there is something to undo.
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes in what was replaced; what was undone is lost.
    pub(crate) fn record(&mut self, before: Moment) {
        self.touched = true;
        self.future.clear();
        self.past.push(before);
        if self.past.len() > DEPTH {
            self.past.remove(0);
        }
    }

    /// What was before, in the place of the present.
    pub(crate) fn undo(&mut self, present: Moment) -> Option<Moment> {
        let before = self.past.pop()?;
        self.future.push(present);
        Some(before)
    }

    /// What was undone last, in the place of the present.
    pub(crate) fn redo(&mut self, present: Moment) -> Option<Moment> {
        let after = self.future.pop()?;
        self.past.push(present);
        Some(after)
    }
}
