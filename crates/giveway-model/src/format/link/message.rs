//! Data as a text holds it: the bytes of a message, in letters. Their form may change
//! with the version, so a number stands before them.

use borsh::{BorshDeserialize, BorshSerialize};
use data_encoding::BASE64URL_NOPAD;

/// To be raised when the form of a message changes: the page's tests of what a browser
/// kept have one of each as it was written.
const FORM: &str = "1";

/// A message in letters.
pub fn write<T: BorshSerialize>(told: &T) -> String {
    // Memory is all that could run out.
    let bytes = borsh::to_vec(told).unwrap_or_default();
    format!("{FORM}-{}", BASE64URL_NOPAD.encode(&bytes))
}

/// The message; `None` where it is broken or of another form.
pub fn read<T: BorshDeserialize>(text: &str) -> Option<T> {
    let letters = text.strip_prefix(FORM)?.strip_prefix('-')?;
    let bytes = BASE64URL_NOPAD.decode(letters.as_bytes()).ok()?;
    borsh::from_slice(&bytes).ok()
}
