//! The link to the solver: what the state says should run, runs in a worker.
//!
//! A worker cannot hear while it works, so a run that is no longer wanted is
//! ended together with its worker, and another is started at once, to be warm
//! for the next run. An idle worker is kept.

mod worker;

use std::cell::RefCell;
use std::rc::Rc;

use giveway_page::{Action, SolveAction, Work};
use giveway_solve::Progress;
use giveway_wasm::protocol::{Ask, Message};
use gloo::render::{AnimationFrame, request_animation_frame};
use yew::prelude::*;

use crate::Shown;
use worker::{Event, Hired};

/// Runs what [`Work`] says, and sends what the solver tells.
#[hook]
pub(crate) fn use_solver(state: &Shown, send: &Callback<Action>) {
    let solver = {
        let send = send.clone();
        use_memo((), move |()| Solver::new(send))
    };
    let state = state.clone();
    use_effect_with(state.work.id(), move |_| solver.want(&state.work));
}

/// The page's end of the link.
#[derive(Clone)]
struct Solver(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    worker: RefCell<Option<Hired>>,
    job: RefCell<Option<Job>>,
    news: RefCell<News>,
}

/// What the worker is to do, or does.
struct Job {
    run: u64,
    /// The message, until it is posted.
    waiting: Option<Vec<u8>>,
}

/// What was heard since the last frame: it is shown in one go.
#[derive(Default)]
struct News {
    events: Vec<Progress>,
    frame: Option<AnimationFrame>,
}

impl Solver {
    /// A link with a worker that is on its way.
    fn new(send: Callback<Action>) -> Self {
        let solver = Self(Rc::new(Inner {
            send,
            worker: RefCell::new(None),
            job: RefCell::new(None),
            news: RefCell::default(),
        }));
        solver.hire();
        solver
    }

    /// Sees to it that this run runs, and no other.
    fn want(&self, work: &Work) {
        let inner = &self.0;
        let at = inner.job.borrow().as_ref().map(|job| job.run);
        if at == work.id() {
            return;
        }
        inner.news.take();
        let busy = inner.job.take().is_some_and(|job| job.waiting.is_none());
        let wanted = work.request();
        let is_wanted = wanted.is_some();
        if let Some((run, request)) = wanted {
            let ask = Ask {
                id: message_id(run),
                request,
            };
            inner.job.replace(Some(Job {
                run,
                waiting: Some(ask.to_bytes()),
            }));
        }
        let absent = inner.worker.borrow().is_none();
        if busy || (absent && is_wanted) {
            self.hire();
        }
        self.post();
    }

    /// Starts a worker; the one before it is ended, whatever it was at.
    fn hire(&self) {
        self.0.worker.take();
        let solver = self.clone();
        match Hired::start(move |event| solver.hear(event)) {
            Ok(hired) => {
                self.0.worker.replace(Some(hired));
            }
            Err(sentence) => self.fail(sentence, false),
        }
    }

    /// Posts what waits, if there is somebody who listens.
    fn post(&self) {
        let worker = self.0.worker.borrow();
        let Some(worker) = worker.as_ref().filter(|worker| worker.is_ready()) else {
            return;
        };
        if let Some(job) = self.0.job.borrow_mut().as_mut()
            && let Some(bytes) = job.waiting.take()
        {
            worker.post(&bytes);
        }
    }

    fn hear(&self, event: Event) {
        match event {
            Event::Said(message) => self.read(*message),
            Event::Broke(sentence) => self.broken(sentence),
        }
    }

    fn read(&self, message: Message) {
        match message {
            Message::Ready => {
                if let Some(worker) = self.0.worker.borrow_mut().as_mut() {
                    worker.set_ready();
                }
                self.post();
            }
            Message::Progress { id, event } => {
                if self.is_at(id) {
                    self.learn(event);
                }
            }
            Message::Answer { id, response } => {
                if self.is_at(id)
                    && let Some(Job { run, .. }) = self.0.job.take()
                {
                    self.0.news.take();
                    let response = Box::new(response);
                    self.0
                        .send
                        .emit(Action::Solve(SolveAction::Respond { job: run, response }));
                }
            }
            Message::Failed { sentence, .. } => self.broken(sentence),
        }
    }

    fn broken(&self, sentence: String) {
        let had_started = self.0.worker.take().is_some_and(|w| w.is_ready());
        self.fail(sentence, had_started);
    }

    /// Tells of a worker that is no more. One that had worked is replaced at
    /// once; for one that never started, another is tried at the next run.
    fn fail(&self, sentence: String, had_started: bool) {
        self.0.news.take();
        let job = self.0.job.take();
        if had_started {
            self.hire();
        }
        if let Some(Job { run, .. }) = job {
            self.0.send.emit(Action::Solve(SolveAction::Crash {
                job: run,
                sentence,
                had_started,
            }));
        }
    }

    fn is_at(&self, id: u32) -> bool {
        let job = self.0.job.borrow();
        job.as_ref().is_some_and(|job| message_id(job.run) == id)
    }

    /// Keeps progress for the next frame.
    fn learn(&self, event: Progress) {
        let mut news = self.0.news.borrow_mut();
        let is_size = |event: &Progress| matches!(event, Progress::Size { .. });
        if is_size(&event) {
            news.events.retain(|event| !is_size(event));
        }
        news.events.push(event);
        if news.frame.is_none() {
            let solver = self.clone();
            news.frame = Some(request_animation_frame(move |_| solver.tell()));
        }
    }

    fn tell(&self) {
        let News { events, .. } = self.0.news.take();
        let Some(run) = self.0.job.borrow().as_ref().map(|job| job.run) else {
            return;
        };
        for event in events {
            self.0
                .send
                .emit(Action::Solve(SolveAction::Progress { job: run, event }));
        }
    }
}

/// Runs are numbered from 1, and nobody starts four thousand million of them.
const fn message_id(run: u64) -> u32 {
    run as u32
}
