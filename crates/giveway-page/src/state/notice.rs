//! What a person must be told.

/// What kind of thing a notice tells: the page shows and reads out each in its own way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoticeKind {
    /// All went well, and there is something to know: what was left out of a file, say.
    Information,
    /// Something was refused, or failed.
    Refusal,
}

impl NoticeKind {
    /// The role of its live region: only a refusal interrupts a screen reader.
    pub const fn role(self) -> &'static str {
        match self {
            Self::Information => "status",
            Self::Refusal => "alert",
        }
    }

    /// Its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Information => "info",
            Self::Refusal => "warning",
        }
    }

    /// Its class in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Information => "information",
            Self::Refusal => "refusal",
        }
    }
}

/// What a person must be told; it stays until it is dismissed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What kind of thing it tells.
    pub kind: NoticeKind,
    /// One sentence: what happened.
    pub sentence: String,
    /// More lines: places and reasons.
    pub details: Vec<String>,
}

impl Notice {
    /// All went well, and there is something to know.
    pub fn information(sentence: impl Into<String>, details: Vec<String>) -> Self {
        Self::of(NoticeKind::Information, sentence, details)
    }

    /// Something was refused, or failed.
    pub fn refusal(sentence: impl Into<String>, details: Vec<String>) -> Self {
        Self::of(NoticeKind::Refusal, sentence, details)
    }

    fn of(kind: NoticeKind, sentence: impl Into<String>, details: Vec<String>) -> Self {
        Self {
            kind,
            sentence: sentence.into(),
            details,
        }
    }
}
