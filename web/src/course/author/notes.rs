//! What is told beside the draft.

use super::Author;
use super::check::Checked;

/// What is told beside the draft.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Notes {
    /// Whether what is missing is told, too.
    pub(super) is_strict: bool,
    /// What was done last, as a sentence.
    pub(super) told: String,
    /// Whether another tab has kept a draft since.
    pub(super) is_elsewhere: bool,
    /// Whether the browser does not keep the draft.
    pub(super) is_unkept: bool,
    /// What the check says.
    pub(super) check: Checked,
}

impl Author {
    pub(super) fn notes(&self) -> Notes {
        Notes {
            is_strict: self.is_strict,
            told: self.told.clone(),
            is_elsewhere: self.theirs.is_some(),
            is_unkept: self.is_unkept,
            check: self.checked(),
        }
    }
}
