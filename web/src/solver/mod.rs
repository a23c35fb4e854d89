//! The link to the solver: what the state says should run, runs in a worker.
//!
//! A worker cannot hear while it works, so a run that is no longer wanted is
//! ended together with its worker, and another is started at once, to be warm
//! for the next run. An idle worker is kept.
//!
//! The worker's program is the solver, which is small, until something is asked that
//! takes the analyst; from then on it is the analyst, who can all that the solver can.

mod program;
mod worker;

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::tr;
use giveway_page::{Action, FileAction, Notice, SolveAction, Work, link};
use giveway_solve::{Progress, Request};
use giveway_wasm::protocol::{Ask, Message};
use gloo::render::{AnimationFrame, request_animation_frame};
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use crate::Shown;
use crate::held::Held;
use crate::language;
pub(crate) use program::{Name, Program};
pub(crate) use worker::{Event, Hired, written};

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
    solver: Rc<Program>,
    analyst: Rc<Program>,
    /// Whether the worker runs the analyst.
    is_analyst: Cell<bool>,
    worker: Held<Option<Rc<Hired>>>,
    /// The run that the worker is to do, or does.
    run: Cell<Option<u64>>,
    /// The message that asks for it, until it is posted.
    waiting: Held<Option<Vec<u8>>>,
    news: Held<News>,
}

/// What was heard since the last frame: it is shown in one go.
#[derive(Default)]
struct News {
    events: Vec<Progress>,
    frame: Option<AnimationFrame>,
}

/// Why there are no workers here, and where there are some: the browser, or the page around
/// this one, allows none.
pub(crate) fn alone(why: String) -> Vec<String> {
    let href = gloo::utils::window().location().href().unwrap_or_default();
    vec![
        why,
        tr!("Open the page by itself, in a current browser:").to_owned(),
        link::whole_page(&href),
    ]
}

impl Solver {
    /// A link with a worker that is on its way.
    fn new(send: Callback<Action>) -> Self {
        let solver = Self(Rc::new(Inner {
            send,
            solver: Rc::new(Program::new(Name::Solver)),
            analyst: Rc::new(Program::new(Name::Analyst)),
            is_analyst: Cell::default(),
            worker: Held::default(),
            run: Cell::default(),
            waiting: Held::default(),
            news: Held::default(),
        }));
        solver.hire();
        let tell = solver.clone();
        language::tell_workers(Callback::from(move |told: String| {
            if let Some(worker) = tell.0.worker.get().filter(|worker| worker.is_ready()) {
                worker.speak(&told);
            }
        }));
        solver
    }

    /// Sees to it that this run runs, and no other.
    fn want(&self, work: &Work) {
        let inner = &self.0;
        if inner.run.get() == work.id() {
            return;
        }
        self.forget_news();
        let was_waiting = inner.waiting.take().is_some();
        let busy = inner.run.take().is_some() && !was_waiting;
        let wanted = work.request();
        let is_wanted = wanted.is_some();
        let for_analyst = |(_, request): &(u64, Request)| request.basic().is_none();
        let is_other = wanted.as_ref().is_some_and(for_analyst) && !inner.is_analyst.replace(true);
        if let Some((run, request)) = wanted {
            let ask = Ask {
                id: message_id(run),
                request,
            };
            inner.run.set(Some(run));
            inner.waiting.set(Some(ask.to_bytes()));
        }
        let absent = inner.worker.get().is_none();
        if busy || is_other || (absent && is_wanted) {
            self.hire();
        }
        self.post();
    }

    /// Starts a worker; the one before it is ended, whatever it was at.
    fn hire(&self) {
        drop(self.0.worker.take());
        let solver = self.clone();
        let hear = Rc::new(move |event| solver.hear(event));
        let program = if self.0.is_analyst.get() {
            &self.0.analyst
        } else {
            &self.0.solver
        };
        match Hired::start(Rc::clone(program), hear) {
            Ok(hired) => self.0.worker.set(Some(Rc::new(hired))),
            Err(sentence) => {
                self.tell_alone(sentence.clone());
                self.fail(sentence, false);
            }
        }
    }

    /// Tells that nothing can be solved here, and where it can be: the browser, or the
    /// page around this one, allows no worker.
    fn tell_alone(&self, why: String) {
        let send = self.0.send.clone();
        // Not while the page is being built, and in the place of what is told of the run.
        Timeout::new(0, move || {
            send.emit(Action::File(FileAction::Refuse(Notice::refusal(
                tr!("Plans can be looked at here, but nothing can be solved."),
                alone(why),
            ))));
        })
        .forget();
    }

    /// Posts what waits, if there is somebody who listens.
    fn post(&self) {
        let worker = self.0.worker.get();
        let Some(worker) = worker.filter(|worker| worker.is_ready()) else {
            return;
        };
        if let Some(bytes) = self.0.waiting.take() {
            worker.post(&bytes);
        }
    }

    fn hear(&self, event: Event) {
        match event {
            Event::Said(bytes) => match Message::from_bytes(&bytes) {
                Ok(message) => self.read(message),
                Err(error) => {
                    self.broken(tr!("Unreadable message from the solver: {error}", error));
                }
            },
            Event::Broke(sentence) => self.broken(sentence),
        }
    }

    fn read(&self, message: Message) {
        match message {
            Message::Ready => {
                if let Some(worker) = self.0.worker.get() {
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
                    && let Some(run) = self.0.run.take()
                {
                    self.forget_news();
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
        self.forget_news();
        drop(self.0.waiting.take());
        let run = self.0.run.take();
        if had_started {
            self.hire();
        } else {
            // Solving may still be possible, where a network has come to an end.
            self.0.is_analyst.set(false);
        }
        if let Some(run) = run {
            self.0.send.emit(Action::Solve(SolveAction::Crash {
                job: run,
                sentence,
                had_started,
            }));
        }
    }

    fn is_at(&self, id: u32) -> bool {
        self.0.run.get().is_some_and(|run| message_id(run) == id)
    }

    /// Keeps progress for the next frame.
    fn learn(&self, event: Progress) {
        let mut news = self.0.news.take();
        let is_size = |event: &Progress| matches!(event, Progress::Size { .. });
        if is_size(&event) {
            news.events.retain(|event| !is_size(event));
        }
        news.events.push(event);
        if news.frame.is_none() {
            let solver = self.clone();
            news.frame = Some(request_animation_frame(move |_| solver.tell()));
        }
        self.0.news.set(news);
    }

    /// What was heard is told no more. A frame that was asked for still comes, and
    /// finds nothing: nothing hangs on whether it could be called off.
    fn forget_news(&self) {
        let mut news = self.0.news.take();
        news.events.clear();
        self.0.news.set(news);
    }

    fn tell(&self) {
        let News { events, .. } = self.0.news.take();
        let Some(run) = self.0.run.get() else {
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
