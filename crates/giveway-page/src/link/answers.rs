//! Answers as this browser keeps them: the bytes of a message in letters, behind the number
//! of their form.

use borsh::{BorshDeserialize, BorshSerialize};

use super::message;

/// To be raised when the form of an answer changes. An answer of another form is left out:
/// it can be asked for again, and the document beside it is opened.
const FORM: &str = "5.";

/// An answer in letters.
pub(super) fn write<T: BorshSerialize>(answer: &T) -> String {
    format!("{FORM}{}", message::write(answer))
}

/// The answer; `Some(None)` where it is of another form, `None` where it is broken.
#[expect(clippy::option_option, reason = "broken is not the same as left out")]
pub(super) fn read<T: BorshDeserialize>(text: &str) -> Option<Option<T>> {
    match text.strip_prefix(FORM) {
        Some(letters) => message::read(letters).map(Some),
        None => text
            .starts_with(|first: char| first.is_ascii_digit())
            .then_some(None),
    }
}
