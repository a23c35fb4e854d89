//! The messages of the workers that solve and answer.

use giveway_model::tr;
use giveway_solve::{Progress, Response};
use giveway_wasm::protocol::Message;

use crate::worker_client::{Protocol, Received};

/// The protocol of solver and analyst.
pub(crate) struct Solving;

/// What became known of a request, or its answer.
pub(crate) enum Told {
    /// Something became known.
    Progress { id: u32, event: Progress },
    /// The answer.
    Answer { id: u32, response: Box<Response> },
}

impl Protocol for Solving {
    type Message = Told;

    fn read(bytes: &[u8]) -> Result<Received<Told>, String> {
        let message = Message::from_bytes(bytes);
        let message =
            message.map_err(|error| tr!("Unreadable message from the solver: {error}", error))?;
        Ok(match message {
            Message::Ready => Received::Ready,
            Message::Progress { id, event } => Received::Message(Told::Progress { id, event }),
            Message::Answer { id, response } => Received::Message(Told::Answer { id, response }),
            Message::Failed { sentence, .. } => Received::Failed(sentence),
        })
    }
}
