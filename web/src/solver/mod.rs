//! The link to the solver: what the state says should run, runs in a worker.
//!
//! Plans are found by the solver, which is small and fetched with the page. What only the
//! analyst can answer is asked of a worker of its own, whose program is fetched at the
//! first such question; the solver stays warm beside it.

mod protocol;

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::{tr, tr_data};
use giveway_page::{Action, FileAction, Notice, Work, WorkerAction, link};
use giveway_solve::Progress;
use giveway_wasm::protocol::Ask;
use gloo::render::{AnimationFrame, request_animation_frame};
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use crate::Shown;
use crate::held::Held;
use crate::worker_client::{Client, Event, Failure, Name, Program};
pub(crate) use protocol::{Solving, Told};

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
    solver: Client<Solving>,
    analyst: Client<Solving>,
    /// The run that is asked for, and of which program.
    run: Cell<Option<(u64, Name)>>,
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
        let client = |name| Client::new(Rc::new(Program::new(name)));
        let solver = Self(Rc::new(Inner {
            send,
            solver: client(Name::Solver),
            analyst: client(Name::Analyst),
            run: Cell::default(),
            news: Held::default(),
        }));
        for name in [Name::Solver, Name::Analyst] {
            let link = solver.clone();
            let client = solver.client(name);
            client.listen(move |event| link.hear(name, event));
        }
        solver.0.solver.warm();
        solver
    }

    /// The client of a program; what is no program of this link is the analyst's.
    fn client(&self, name: Name) -> &Client<Solving> {
        match name {
            Name::Solver => &self.0.solver,
            Name::Analyst | Name::Reader => &self.0.analyst,
        }
    }

    /// Sees to it that this run runs, and no other.
    fn want(&self, work: &Work) {
        let before = self.0.run.get();
        if before.map(|(run, _)| run) == work.id() {
            return;
        }
        self.forget_news();
        self.0.run.set(None);
        let wanted = work.request().map(|(run, request)| {
            let is_basic = request.basic().is_some();
            let name = if is_basic {
                Name::Solver
            } else {
                Name::Analyst
            };
            let id = message_id(run);
            (run, name, Ask { id, request }.to_bytes())
        });
        if let Some((_, name)) = before {
            self.client(name).cancel();
        }
        if let Some((run, name, message)) = wanted {
            self.0.run.set(Some((run, name)));
            self.client(name).ask(message);
        }
    }

    /// Tells that nothing can be solved here, and where it can be: the browser, or the
    /// page around this one, allows no worker.
    fn tell_alone(&self, why: String) {
        let send = self.0.send.clone();
        // Not while the page is being built, and in the place of what is told of the run.
        Timeout::new(0, move || {
            send.emit(Action::File(FileAction::Tell(
                Notice::refusal(tr_data!(
                    "Plans can be looked at here, but nothing can be solved."
                ))
                .with(alone(why)),
            )));
        })
        .forget();
    }

    fn hear(&self, name: Name, event: Event<Told>) {
        match event {
            Event::Message(Told::Progress { id, event }) => {
                if self.is_at(id) {
                    self.learn(event);
                }
            }
            Event::Message(Told::Answer { id, response }) => {
                if self.is_at(id)
                    && let Some((job, name)) = self.0.run.take()
                {
                    self.client(name).finish();
                    self.forget_news();
                    let respond = WorkerAction::Respond { job, response };
                    self.0.send.emit(Action::Worker(respond));
                }
            }
            Event::Failed(failure) => self.fail(name, failure),
        }
    }

    /// Tells of a worker that failed. One that had worked is replaced at once; for one
    /// that never started, another is tried at the next run.
    fn fail(&self, name: Name, failure: Failure) {
        let Failure {
            sentence,
            had_started,
            is_forbidden,
        } = failure;
        if is_forbidden {
            self.tell_alone(sentence.clone());
        }
        if had_started {
            self.client(name).warm();
        }
        let run = self.0.run.get().filter(|&(_, of)| of == name);
        if let Some((job, _)) = run {
            self.0.run.set(None);
            self.forget_news();
            self.0.send.emit(Action::Worker(WorkerAction::Crash {
                job,
                sentence,
                had_started,
            }));
        }
    }

    fn is_at(&self, id: u32) -> bool {
        self.0
            .run
            .get()
            .is_some_and(|(run, _)| message_id(run) == id)
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

    /// Drops what was heard and not told yet. A frame that was asked for still comes, and
    /// finds nothing.
    fn forget_news(&self) {
        let mut news = self.0.news.take();
        news.events.clear();
        self.0.news.set(news);
    }

    fn tell(&self) {
        let News { events, .. } = self.0.news.take();
        let Some((job, _)) = self.0.run.get() else {
            return;
        };
        for event in events {
            let progress = WorkerAction::Progress { job, event };
            self.0.send.emit(Action::Worker(progress));
        }
    }
}

/// Runs are numbered from 1; no page starts four thousand million of them.
const fn message_id(run: u64) -> u32 {
    run as u32
}
