//! What a person must be told, as data.

use giveway_model::words::Sentence;

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

/// What a person must be told; it stays until it is dismissed. It is said in the language
/// that is spoken when it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What kind of thing it tells.
    pub kind: NoticeKind,
    sentence: Sentence,
    details: Vec<Sentence>,
}

impl Notice {
    /// All went well, and there is something to know.
    pub fn information(sentence: impl Into<Sentence>) -> Self {
        Self::of(NoticeKind::Information, sentence.into())
    }

    /// Something was refused, or failed.
    pub fn refusal(sentence: impl Into<Sentence>) -> Self {
        Self::of(NoticeKind::Refusal, sentence.into())
    }

    const fn of(kind: NoticeKind, sentence: Sentence) -> Self {
        Self {
            kind,
            sentence,
            details: Vec::new(),
        }
    }

    /// The same with more lines: places and reasons.
    #[must_use]
    pub fn with(mut self, details: impl IntoIterator<Item: Into<Sentence>>) -> Self {
        self.details.extend(details.into_iter().map(Into::into));
        self
    }

    /// The same reasons under another sentence.
    #[must_use]
    pub fn under(self, sentence: impl Into<Sentence>) -> Self {
        Self {
            sentence: sentence.into(),
            ..self
        }
    }

    /// One sentence: what happened.
    pub fn sentence(&self) -> String {
        self.sentence.to_string()
    }

    /// More lines: places and reasons.
    pub fn details(&self) -> Vec<String> {
        self.details.iter().map(ToString::to_string).collect()
    }
}
