//! The messages between a page and its worker, as plain data in bytes.
//!
//! The worker says [`Message::Ready`] once; what is posted to it earlier is
//! lost. It answers one [`Ask`] after the other, in order: some
//! [`Message::Progress`], then one [`Message::Answer`]. It cannot hear while it
//! works, so a page cancels by ending it and starting another.
//!
//! A worker that says [`Message::Failed`] is broken and must be ended, too. It
//! may also break without a word, when the browser gives it no more memory:
//! then the `Worker` object in the page has an `error` event only.
//!
//! A text in the place of bytes is the [language](crate::language) to speak from then on.
//!
//! Both ends are the same program, so the bytes need not tell what they are: code
//! that reads and writes them is a tenth of what JSON would take.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_solve::{Progress, Request, Response};

/// From the page to the worker: do this.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Ask {
    /// A number that all messages about it carry.
    pub id: u32,
    /// What to do.
    pub request: Request,
}

/// From the worker to the page.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Message {
    /// It listens.
    Ready,
    /// Something became known on the way to an answer.
    Progress {
        /// Of the [`Ask`].
        id: u32,
        /// What.
        event: Progress,
    },
    /// The answer.
    Answer {
        /// Of the [`Ask`].
        id: u32,
        /// The answer; an error is one, too.
        response: Box<Response>,
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
    /// The message, to be posted.
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the bytes are none, as a sentence.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        borsh::from_slice(bytes).map_err(|error| error.to_string())
    }
}

impl Message {
    /// The message, to be posted.
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the bytes are none, as a sentence.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        borsh::from_slice(bytes).map_err(|error| error.to_string())
    }
}

fn to_bytes<T: BorshSerialize>(message: &T) -> Vec<u8> {
    // Memory always takes them, and no number in them is none.
    borsh::to_vec(message).unwrap_or_default()
}

#[cfg(test)]
mod tests;
