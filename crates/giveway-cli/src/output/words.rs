//! Sentences as the command writes them.

/// The sentence with one full stop at its end, safe for a terminal.
pub(crate) fn sentence(text: &str) -> String {
    giveway_model::words::sentence(&super::plain::text(text.trim()))
}
