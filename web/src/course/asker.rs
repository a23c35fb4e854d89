//! The course's own solver: a worker that answers what judges ask.
//!
//! A worker cannot hear while it works. So a question that is of no more use is ended
//! together with its worker, and another one is started at once, to be warm for the next.

use std::cell::Cell;
use std::rc::Rc;

use giveway_course::learner::{Action, AskNumber};
use giveway_model::tr;
use giveway_solve::Request;
use giveway_wasm::protocol::{Ask, Message};
use yew::prelude::*;

use crate::held::Held;
use crate::language;
use crate::solver::{Event, Hired, Name, Program};

/// The course's end of the link to the solver.
#[derive(Clone)]
pub(super) struct Asker(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    program: Rc<Program>,
    worker: Held<Option<Rc<Hired>>>,
    /// What the worker is to answer.
    asked: Cell<Option<AskNumber>>,
    /// The message that asks it, until it is posted.
    waiting: Held<Option<Vec<u8>>>,
}

impl Asker {
    /// A link without a worker.
    pub(super) fn new(send: Callback<Action>) -> Self {
        Self::with(Rc::new(Program::new(Name::Analyst)), send)
    }

    fn with(program: Rc<Program>, send: Callback<Action>) -> Self {
        let asker = Self(Rc::new(Inner {
            send,
            program,
            worker: Held::default(),
            asked: Cell::default(),
            waiting: Held::default(),
        }));
        let tell = asker.clone();
        language::tell_workers(Callback::from(move |told: String| {
            if let Some(worker) = tell.0.worker.get().filter(|worker| worker.is_ready()) {
                worker.speak(&told);
            }
        }));
        asker
    }

    /// Another link with a worker of its own; neither ends what the other asks.
    pub(super) fn beside(&self, send: Callback<Action>) -> Self {
        Self::with(Rc::clone(&self.0.program), send)
    }

    /// Sees to it that a worker is there, or on its way.
    pub(super) fn warm(&self) {
        if self.0.worker.get().is_none() {
            self.hire();
        }
    }

    /// Asks; what was asked before is of no more use.
    pub(super) fn ask(&self, number: AskNumber, request: Request) {
        self.forget();
        let ask = Ask {
            id: number.0,
            request,
        };
        self.0.asked.set(Some(number));
        self.0.waiting.set(Some(ask.to_bytes()));
        self.warm();
        self.post();
    }

    /// What was asked is of no more use.
    pub(super) fn forget(&self) {
        let was_waiting = self.0.waiting.take().is_some();
        if self.0.asked.take().is_some() && !was_waiting {
            self.hire();
        }
    }

    /// What was asked is of no more use, and nothing else is asked soon.
    pub(super) fn end(&self) {
        drop(self.0.waiting.take());
        self.0.asked.take();
        drop(self.0.worker.take());
    }

    /// Starts a worker; the one before it is ended, whatever it was at.
    fn hire(&self) {
        drop(self.0.worker.take());
        let asker = self.clone();
        let hear = Rc::new(move |event| asker.hear(event));
        match Hired::start(Rc::clone(&self.0.program), hear) {
            Ok(hired) => self.0.worker.set(Some(Rc::new(hired))),
            Err(sentence) => self.fail(sentence),
        }
    }

    /// Posts what waits, if there is somebody who listens.
    fn post(&self) {
        let worker = self.0.worker.get().filter(|worker| worker.is_ready());
        if let Some(worker) = worker
            && let Some(bytes) = self.0.waiting.take()
        {
            worker.post(&bytes);
        }
    }

    fn hear(&self, event: Event) {
        let message = match event {
            Event::Said(bytes) => Message::from_bytes(&bytes),
            Event::Broke(sentence) => return self.broken(sentence),
        };
        match message {
            Ok(Message::Ready) => {
                if let Some(worker) = self.0.worker.get() {
                    worker.set_ready();
                }
                self.post();
            }
            Ok(Message::Progress { .. }) => {}
            Ok(Message::Answer { id, response }) => {
                let number = AskNumber(id);
                if self.0.asked.get() == Some(number) {
                    self.0.asked.set(None);
                    let response = Box::new(response);
                    self.0.send.emit(Action::Answered { number, response });
                }
            }
            Ok(Message::Failed { sentence, .. }) => self.broken(sentence),
            Err(error) => {
                self.broken(tr!("Unreadable message from the solver: {error}", error));
            }
        }
    }

    /// A worker is no more; the next question starts another one.
    fn broken(&self, sentence: String) {
        drop(self.0.worker.take());
        self.fail(sentence);
    }

    fn fail(&self, sentence: String) {
        drop(self.0.waiting.take());
        if let Some(number) = self.0.asked.take() {
            self.0.send.emit(Action::Failed { number, sentence });
        }
    }
}
