//! What a person must be told.

/// What a person must be told: something was refused, or failed and was mended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// One sentence: what happened.
    pub sentence: String,
    /// More lines: places and reasons.
    pub details: Vec<String>,
}

impl Notice {
    /// One sentence, and nothing more.
    pub(crate) fn new(sentence: impl Into<String>) -> Self {
        Self {
            sentence: sentence.into(),
            details: Vec::new(),
        }
    }
}
