//! The draft, as the browser keeps it for all of its tabs, and the one before it: so
//! nothing is lost when a new lesson is begun, or two tabs write.

use giveway_course::author::{Action, Draft};
use giveway_course::lesson::Glossary;

use super::Author;
use crate::keep::{forget, load, store};

/// Under which name the draft is kept.
pub(super) const NAME: &str = "lesson-draft";
/// Under which name the draft is kept that was there before.
const BEFORE: &str = "lesson-draft-before";

/// A draft that was kept. It may be of another version, or not ours.
fn read(name: &str) -> Option<Box<Draft>> {
    let draft = Draft::read(&load(name)?).ok()?;
    Some(Box::new(draft))
}

impl Author {
    /// Opens the editor with what is kept, and with a way back to what was there before.
    pub(super) fn open(&mut self, glossary: &Glossary) {
        self.is_open = true;
        self.is_strict = false;
        self.told.clear();
        if self.is_unkept {
            // What is kept is older than what is here.
            self.keep();
            self.look(glossary);
        } else if let Some(kept) = read(NAME) {
            let is_theirs = self.theirs.take().is_some();
            self.act(
                if is_theirs {
                    Action::Take(kept)
                } else {
                    Action::Kept(kept)
                },
                glossary,
            );
        } else {
            self.look(glossary);
        }
        if let Some(before) = read(BEFORE) {
            self.act(Action::Before(before), glossary);
        }
    }

    /// Keeps the draft. What another tab has written in its place is put aside first.
    pub(super) fn keep(&mut self) {
        if let Some((theirs, is_aside)) = &mut self.theirs
            && !std::mem::replace(is_aside, true)
        {
            // It is only a way back: where there is no room for it, there is none.
            let _ = store(BEFORE, theirs);
        }
        let text = self.draft.write();
        self.is_unkept = store(NAME, &text).is_err() && {
            // What is written comes before what was.
            forget(BEFORE);
            store(NAME, &text).is_err()
        };
    }

    /// Keeps the draft that was there before, where there is a way back to one.
    pub(super) fn keep_before(&self) {
        match self.draft.before() {
            Some(before) if store(BEFORE, &before.write()).is_ok() => {}
            _ => forget(BEFORE),
        }
    }

    /// Another tab has kept a draft.
    pub(super) fn hear(&mut self) {
        let theirs = load(NAME).filter(|text| *text != self.draft.write());
        self.theirs = theirs.map(|text| (text, false));
    }

    /// Takes the draft of the other tab; there is a way back to this one.
    pub(super) fn take(&mut self, glossary: &Glossary) {
        let theirs = self.theirs.take();
        if let Some(Ok(theirs)) = theirs.map(|(text, _)| Draft::read(&text)) {
            self.act(Action::Take(Box::new(theirs)), glossary);
        }
    }
}
