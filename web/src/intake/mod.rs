//! The link to the reader: what the state says should be read, written or drawn, is done
//! in a worker that is started for it. Frames of pictures are drawn here, since only a page
//! can draw SVG.
//!
//! A worker cannot hear while it works, so a job that is no longer wanted is ended
//! together with its worker. An idle worker is kept.

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::tr;
use giveway_page::intake::Intake;
use giveway_page::intake::protocol::{Ask, Message, Reply, Task};
use giveway_page::{Action, IntakeAction, Shot};
use gloo::file::Blob;
use wasm_bindgen::JsValue;
use yew::platform::spawn_local;
use yew::prelude::*;

use crate::dialog::Panel;
use crate::held::Held;
use crate::paper::Frames;
use crate::solver::{Event, Hired, Name, Program, alone};
use crate::{Shown, files, language};

/// Does what [`Intake`] says, saves what was packed, and sends what the reader tells. What turns out to be
/// the page's own business is opened by it.
#[hook]
pub(crate) fn use_intake(state: &Shown, send: &Callback<Action>, show: &Callback<Panel>) {
    let reader = {
        let send = send.clone();
        use_memo((), move |()| Reader::new(send))
    };
    reader.0.state.set(Some(state.clone()));
    reader.0.show.set(Some(show.clone()));
    let state = state.clone();
    {
        let send = send.clone();
        use_effect_with(state.intake.packed.clone(), move |packed| {
            if let Some(packed) = packed {
                files::save_as(&packed.name, Blob::new(packed.bytes.as_slice()));
                send.emit(Action::Intake(IntakeAction::Saved));
            }
        });
    }
    let job = state
        .intake
        .job()
        .map(|job| (job.id, job.fetches.is_empty()));
    use_effect_with(job, move |_| reader.want(&state.intake));
}

/// The page's end of the link.
#[derive(Clone)]
struct Reader(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    program: Rc<Program>,
    worker: Held<Option<Rc<Hired>>>,
    /// The job that the worker is to do, or does.
    job: Cell<Option<u64>>,
    /// The message that asks for it, until it is posted.
    waiting: Held<Option<Vec<u8>>>,
    state: Held<Option<Shown>>,
    show: Held<Option<Callback<Panel>>>,
    /// What the frames of a picture are drawn on.
    frames: Held<Option<Rc<Frames>>>,
}

impl Reader {
    fn new(send: Callback<Action>) -> Self {
        let reader = Self(Rc::new(Inner {
            send,
            program: Rc::new(Program::new(Name::Reader)),
            worker: Held::default(),
            job: Cell::default(),
            waiting: Held::default(),
            state: Held::default(),
            show: Held::default(),
            frames: Held::default(),
        }));
        let tell = reader.clone();
        language::tell_workers(Callback::from(move |told: String| {
            if let Some(worker) = tell.0.worker.get().filter(|worker| worker.is_ready()) {
                worker.speak(&told);
            }
        }));
        reader
    }

    /// Sees to it that this job is done, and no other.
    fn want(&self, intake: &Intake) {
        let inner = &self.0;
        if inner.job.take().is_some() {
            // It is at something that nobody wants any longer.
            drop(inner.worker.take());
        }
        drop(inner.frames.take());
        drop(inner.waiting.take());
        if let Some(job) = intake.job().filter(|job| !job.fetches.is_empty()) {
            return self.fetch(job.id, job.fetches.clone());
        }
        let Some((job, bytes)) = intake.ask() else {
            return;
        };
        inner.job.set(Some(job));
        inner.waiting.set(Some(bytes));
        if inner.worker.get().is_none() {
            self.hire();
        }
        self.post();
    }

    /// Fetches files of the page; those that are not there are left out.
    fn fetch(&self, job: u64, names: Vec<String>) {
        let send = self.0.send.clone();
        spawn_local(async move {
            let files = files::fetch_maps(names).await;
            send.emit(Action::Intake(IntakeAction::Fetched { job, files }));
        });
    }

    fn hire(&self) {
        let reader = self.clone();
        let program = Rc::clone(&self.0.program);
        match Hired::start(program, Rc::new(move |event| reader.hear(event))) {
            Ok(hired) => self.0.worker.set(Some(Rc::new(hired))),
            Err(sentence) => self.fail(false, alone(sentence)),
        }
    }

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
        let message = match event {
            Event::Said(bytes) => borsh::from_slice(&bytes).unwrap_or_else(|error| {
                Message::Failed(tr!(
                    "Unreadable message from the reader of files: {error}",
                    error
                ))
            }),
            Event::Broke(sentence) => Message::Failed(sentence),
        };
        match message {
            Message::Ready => {
                if let Some(worker) = self.0.worker.get() {
                    worker.set_ready();
                }
                self.post();
            }
            Message::Progress { id, sentence } => {
                let progress = IntakeAction::Progress { job: id, sentence };
                self.0.send.emit(Action::Intake(progress));
            }
            Message::Draw { id, shot } => {
                if self.0.job.get() == Some(id) {
                    self.draw(id, shot);
                }
            }
            Message::Reply { id, reply } => {
                drop(self.0.frames.take());
                if self.0.job.get() == Some(id) {
                    self.0.job.set(None);
                    self.replied(id, reply);
                }
            }
            Message::Failed(sentence) => self.broken(sentence),
        }
    }

    /// Draws a frame, and sends its pixels: the browser does other things in between.
    fn draw(&self, id: u64, shot: Shot) {
        let reader = self.clone();
        spawn_local(async move {
            let drawn = async {
                if let Some(ground) = &shot.ground {
                    let frames = Rc::new(Frames::begin(shot.size, ground).await?);
                    if reader.0.job.get() == Some(id) {
                        reader.0.frames.set(Some(frames));
                    }
                }
                let frames = reader.0.frames.get().ok_or("no paper")?;
                frames.pixels(&shot).await
            };
            let drawn: Result<Vec<u8>, JsValue> = drawn.await;
            if reader.0.job.get() != Some(id) {
                return;
            }
            match (drawn, reader.0.worker.get()) {
                (Ok(pixels), Some(worker)) => {
                    let task = Task::Pixels(pixels);
                    // Memory is all that could run out.
                    worker.post(&borsh::to_vec(&Ask { id, task }).unwrap_or_default());
                }
                _ => reader.broken(tr!("The browser could not draw a frame.").to_owned()),
            }
        });
    }

    fn replied(&self, job: u64, reply: Reply) {
        let own = matches!(reply, Reply::Own);
        let reply = Rc::new(reply);
        let state = self.0.state.get();
        self.0
            .send
            .emit(Action::Intake(IntakeAction::Reply { job, reply }));
        if let (true, Some(state), Some(show)) = (own, state, self.0.show.get()) {
            let opened = state.intake.job().map(|job| job.files().to_vec());
            let reading = giveway_page::files::read_beside(&state, &opened.unwrap_or_default());
            if let Some(reading) = reading {
                files::take(reading, &self.0.send, &show);
            }
        }
    }

    fn broken(&self, sentence: String) {
        let had_started = self.0.worker.take().is_some_and(|w| w.is_ready());
        self.fail(had_started, vec![sentence]);
    }

    /// What was to be done is not: the worker is no more, or there never was one.
    fn fail(&self, had_started: bool, details: Vec<String>) {
        drop(self.0.waiting.take());
        drop(self.0.frames.take());
        if let Some(job) = self.0.job.take() {
            let crash = IntakeAction::Crash {
                job,
                had_started,
                details,
            };
            self.0.send.emit(Action::Intake(crash));
        }
    }
}
