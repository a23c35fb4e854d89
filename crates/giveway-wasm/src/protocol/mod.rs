//! The messages between a page and its worker, as plain data in JSON text.
//!
//! The worker says [`Message::Ready`] once; what is posted to it earlier is
//! lost. It answers one [`Ask`] after the other, in order: some
//! [`Message::Progress`], then one [`Message::Answer`]. It cannot hear while it
//! works, so a page cancels by ending it and starting another.
//!
//! A worker that says [`Message::Failed`] is broken and must be ended, too. It
//! may also break without a word, when the browser gives it no more memory:
//! then the `Worker` object in the page has an `error` event only.

mod compact;

use giveway_solve::{Progress, Request, Response};
use serde::{Deserialize, Serialize};

/// From the page to the worker: do this.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ask {
    /// A number that all messages about it carry.
    pub id: u32,
    /// What to do.
    #[serde(with = "compact::Request")]
    pub request: Request,
}

/// From the worker to the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Message {
    /// It listens.
    Ready,
    /// Something became known on the way to an answer.
    Progress {
        /// Of the [`Ask`].
        id: u32,
        /// What.
        #[serde(with = "compact::Progress")]
        event: Progress,
    },
    /// The answer.
    Answer {
        /// Of the [`Ask`].
        id: u32,
        /// The answer; an error is one, too.
        #[serde(with = "compact::Response")]
        response: Response,
    },
    /// A fault of the program; the worker is of no more use.
    Failed {
        /// Of the [`Ask`] that it was at, if it was at one.
        id: Option<u32>,
        /// What happened, as a sentence.
        sentence: String,
    },
}

impl Ask {
    /// The message as text, to be posted.
    pub fn to_text(&self) -> String {
        to_text(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the text is none, as a sentence.
    pub fn from_text(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map_err(|error| error.to_string())
    }
}

impl Message {
    /// The message as text, to be posted.
    pub fn to_text(&self) -> String {
        to_text(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the text is none, as a sentence.
    pub fn from_text(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map_err(|error| error.to_string())
    }
}

fn to_text<T: Serialize>(message: &T) -> String {
    // Maps by text, numbers and lists always have a JSON form.
    serde_json::to_string(message).unwrap_or_default()
}

#[cfg(test)]
mod tests;
