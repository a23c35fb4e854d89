//! A client of a worker: it starts the worker, asks one thing at a time, and replaces a
//! worker whose work is no longer wanted.
//!
//! A worker cannot hear while it works. So what is cancelled is ended together with its
//! worker, and another one is started at once, to be warm for what is asked next.

mod handle;
mod program;

use std::cell::Cell;
use std::rc::Rc;

use crate::held::Held;
use crate::language;
pub(crate) use handle::written;
use handle::{Signal, WorkerHandle};
pub(crate) use program::{Name, Program};
use yew::Callback;

/// A message of a worker, as its protocol reads it.
pub(crate) enum Received<M> {
    /// The worker listens from now on.
    Ready,
    /// The worker is of no more use, for this reason.
    Failed(String),
    /// Anything else.
    Message(M),
}

/// How the messages of a worker are read.
pub(crate) trait Protocol: 'static {
    /// A message that is no matter of the client.
    type Message;

    /// Reads the bytes of a message.
    ///
    /// # Errors
    /// Why they are no message, as a sentence.
    fn read(bytes: &[u8]) -> Result<Received<Self::Message>, String>;
}

/// A worker that is no more.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    /// Why, as a sentence.
    pub(crate) sentence: String,
    /// Whether it had worked.
    pub(crate) had_started: bool,
    /// Whether the browser, or the page around this one, allows no workers.
    pub(crate) is_forbidden: bool,
}

/// What the owner of a client hears.
pub(crate) enum Event<M> {
    /// A message of the worker.
    Message(M),
    /// The worker failed. What was asked is not answered; the next ask starts another one.
    Failed(Failure),
}

type Hear<M> = Rc<dyn Fn(Event<M>)>;

/// A client of one worker at a time.
pub(crate) struct Client<P: Protocol>(Rc<Inner<P>>);

struct Inner<P: Protocol> {
    program: Rc<Program>,
    worker: Held<Option<Rc<WorkerHandle>>>,
    /// Whether an answer is due.
    is_asked: Cell<bool>,
    /// The message that asks for it, until it is posted.
    waiting: Held<Option<Vec<u8>>>,
    hear: Held<Option<Hear<P::Message>>>,
}

impl<P: Protocol> Clone for Client<P> {
    fn clone(&self) -> Self {
        Self(Rc::clone(&self.0))
    }
}

impl<P: Protocol> Client<P> {
    /// A client without a worker, which speaks the language of the page.
    pub(crate) fn new(program: Rc<Program>) -> Self {
        let client = Self(Rc::new(Inner {
            program,
            worker: Held::default(),
            is_asked: Cell::default(),
            waiting: Held::default(),
            hear: Held::default(),
        }));
        let speaker = client.clone();
        language::tell_workers(Callback::from(move |told: String| {
            if let Some(worker) = speaker.ready() {
                worker.speak(&told);
            }
        }));
        client
    }

    /// Hears the worker from now on.
    pub(crate) fn listen(&self, hear: impl Fn(Event<P::Message>) + 'static) {
        self.0.hear.set(Some(Rc::new(hear)));
    }

    /// The program that its workers run.
    pub(crate) fn program(&self) -> Rc<Program> {
        Rc::clone(&self.0.program)
    }

    /// Asks; what was asked before is cancelled.
    pub(crate) fn ask(&self, message: Vec<u8>) {
        self.cancel();
        self.0.is_asked.set(true);
        self.0.waiting.set(Some(message));
        self.warm();
        self.post_waiting();
    }

    /// Posts a further message about what was asked; `false` without a worker that listens.
    pub(crate) fn post(&self, message: &[u8]) -> bool {
        let worker = self.ready();
        worker.is_some_and(|worker| {
            worker.post(message);
            true
        })
    }

    /// What was asked is answered.
    pub(crate) fn finish(&self) {
        self.0.is_asked.set(false);
    }

    /// What was asked is no longer wanted.
    pub(crate) fn cancel(&self) {
        let was_waiting = self.0.waiting.take().is_some();
        if self.0.is_asked.take() && !was_waiting {
            self.start();
        }
    }

    /// Starts a worker where there is none.
    pub(crate) fn warm(&self) {
        if self.0.worker.get().is_none() {
            self.start();
        }
    }

    /// Cancels what was asked, and ends the worker.
    pub(crate) fn end(&self) {
        drop(self.0.waiting.take());
        self.0.is_asked.set(false);
        drop(self.0.worker.take());
    }

    /// Ends the worker as one that failed.
    pub(crate) fn fail(&self, sentence: String) {
        let worker = self.0.worker.take();
        self.failed(Failure {
            sentence,
            had_started: worker.is_some_and(|worker| worker.is_ready()),
            is_forbidden: false,
        });
    }

    fn ready(&self) -> Option<Rc<WorkerHandle>> {
        self.0.worker.get().filter(|worker| worker.is_ready())
    }

    /// Starts a worker; the one before it is ended.
    fn start(&self) {
        drop(self.0.worker.take());
        let client = self.clone();
        let hear = Rc::new(move |signal| client.hear(signal));
        match WorkerHandle::start(self.program(), hear) {
            Ok(worker) => self.0.worker.set(Some(Rc::new(worker))),
            Err(sentence) => self.failed(Failure {
                sentence,
                had_started: false,
                is_forbidden: true,
            }),
        }
    }

    fn post_waiting(&self) {
        if let Some(worker) = self.ready()
            && let Some(message) = self.0.waiting.take()
        {
            worker.post(&message);
        }
    }

    fn hear(&self, signal: Signal) {
        let received = match signal {
            Signal::Message(bytes) => P::read(&bytes),
            Signal::Failed(sentence) => Err(sentence),
        };
        match received {
            Ok(Received::Ready) => {
                if let Some(worker) = self.0.worker.get() {
                    worker.set_ready();
                }
                self.post_waiting();
            }
            Ok(Received::Message(message)) => self.tell(Event::Message(message)),
            Ok(Received::Failed(sentence)) | Err(sentence) => self.fail(sentence),
        }
    }

    fn failed(&self, failure: Failure) {
        drop(self.0.waiting.take());
        self.0.is_asked.set(false);
        self.tell(Event::Failed(failure));
    }

    fn tell(&self, event: Event<P::Message>) {
        if let Some(hear) = self.0.hear.get() {
            hear(event);
        }
    }
}
