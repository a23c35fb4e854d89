//! The course's own solver: a worker that answers what judges ask.

use std::cell::Cell;
use std::rc::Rc;

use giveway_course::learner::{Action, AskNumber};
use giveway_solve::Request;
use giveway_wasm::protocol::Ask;
use yew::prelude::*;

use crate::solver::{Solving, Told};
use crate::worker_client::{Client, Event, Name, Program};

/// The course's end of the link to the solver.
#[derive(Clone)]
pub(super) struct Asker(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    client: Client<Solving>,
    /// What the worker is to answer.
    asked: Cell<Option<AskNumber>>,
}

impl Asker {
    /// A link without a worker.
    pub(super) fn new(send: Callback<Action>) -> Self {
        Self::with(Rc::new(Program::new(Name::Analyst)), send)
    }

    fn with(program: Rc<Program>, send: Callback<Action>) -> Self {
        let asker = Self(Rc::new(Inner {
            send,
            client: Client::new(program),
            asked: Cell::default(),
        }));
        let link = asker.clone();
        asker.0.client.listen(move |event| link.hear(event));
        asker
    }

    /// Another link with a worker of its own; neither ends what the other asks.
    pub(super) fn beside(&self, send: Callback<Action>) -> Self {
        Self::with(self.0.client.program(), send)
    }

    /// Sees to it that a worker is there, or on its way.
    pub(super) fn warm(&self) {
        self.0.client.warm();
    }

    /// Asks; what was asked before is of no more use.
    pub(super) fn ask(&self, number: AskNumber, request: Request) {
        let id = number.0;
        self.0.asked.set(Some(number));
        self.0.client.ask(Ask { id, request }.to_bytes());
    }

    /// What was asked is of no more use.
    pub(super) fn forget(&self) {
        self.0.asked.set(None);
        self.0.client.cancel();
    }

    /// What was asked is of no more use, and nothing else is asked soon.
    pub(super) fn end(&self) {
        self.0.asked.set(None);
        self.0.client.end();
    }

    fn hear(&self, event: Event<Told>) {
        match event {
            Event::Message(Told::Progress { .. }) => {}
            Event::Message(Told::Answer { id, response }) => {
                let number = AskNumber(id);
                if self.0.asked.get() == Some(number) {
                    self.0.asked.set(None);
                    self.0.client.finish();
                    self.0.send.emit(Action::Answered { number, response });
                }
            }
            Event::Failed(failure) => {
                if let Some(number) = self.0.asked.take() {
                    let sentence = failure.sentence;
                    self.0.send.emit(Action::Failed { number, sentence });
                }
            }
        }
    }
}
