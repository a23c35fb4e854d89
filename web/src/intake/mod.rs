//! The link to the reader: what the state says should be read, written or drawn, is done
//! in a worker that is started for it. Frames of pictures are drawn here, since only a page
//! can draw SVG.

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
use crate::solver::alone;
use crate::worker_client::{Client, Event, Failure, Name, Program, Protocol, Received};
use crate::{Shown, files};

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

/// The protocol of the reader.
struct Reading;

/// What the reader tells of a job.
enum Told {
    Progress { id: u64, sentence: String },
    Draw { id: u64, shot: Shot },
    Reply { id: u64, reply: Reply },
}

impl Protocol for Reading {
    type Message = Told;

    fn read(bytes: &[u8]) -> Result<Received<Told>, String> {
        let message = borsh::from_slice(bytes).map_err(|error| {
            tr!(
                "Unreadable message from the reader of files: {error}",
                error
            )
        })?;
        Ok(match message {
            Message::Ready => Received::Ready,
            Message::Failed(sentence) => Received::Failed(sentence),
            Message::Progress { id, sentence } => {
                Received::Message(Told::Progress { id, sentence })
            }
            Message::Draw { id, shot } => Received::Message(Told::Draw { id, shot }),
            Message::Reply { id, reply } => Received::Message(Told::Reply { id, reply }),
        })
    }
}

/// The page's end of the link.
#[derive(Clone)]
struct Reader(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    client: Client<Reading>,
    /// The job that the worker is to do, or does.
    job: Cell<Option<u64>>,
    state: Held<Option<Shown>>,
    show: Held<Option<Callback<Panel>>>,
    /// What the frames of a picture are drawn on.
    frames: Held<Option<Rc<Frames>>>,
}

impl Reader {
    fn new(send: Callback<Action>) -> Self {
        let reader = Self(Rc::new(Inner {
            send,
            client: Client::new(Rc::new(Program::new(Name::Reader))),
            job: Cell::default(),
            state: Held::default(),
            show: Held::default(),
            frames: Held::default(),
        }));
        let link = reader.clone();
        reader.0.client.listen(move |event| link.hear(event));
        reader
    }

    /// Sees to it that this job is done, and no other.
    fn want(&self, intake: &Intake) {
        let inner = &self.0;
        if inner.job.take().is_some() {
            // An idle reader is kept, but none is kept warm.
            inner.client.end();
        }
        drop(inner.frames.take());
        if let Some(job) = intake.job().filter(|job| !job.fetches.is_empty()) {
            return self.fetch(job.id, job.fetches.clone());
        }
        let Some((job, bytes)) = intake.ask() else {
            return;
        };
        inner.job.set(Some(job));
        inner.client.ask(bytes);
    }

    /// Fetches files of the page; those that are not there are left out.
    fn fetch(&self, job: u64, names: Vec<String>) {
        let send = self.0.send.clone();
        spawn_local(async move {
            let files = files::fetch_maps(names).await;
            send.emit(Action::Intake(IntakeAction::Fetched { job, files }));
        });
    }

    fn hear(&self, event: Event<Told>) {
        let message = match event {
            Event::Message(message) => message,
            Event::Failed(failure) => return self.fail(failure),
        };
        match message {
            Told::Progress { id, sentence } => {
                let progress = IntakeAction::Progress { job: id, sentence };
                self.0.send.emit(Action::Intake(progress));
            }
            Told::Draw { id, shot } => {
                if self.0.job.get() == Some(id) {
                    self.draw(id, shot);
                }
            }
            Told::Reply { id, reply } => {
                drop(self.0.frames.take());
                if self.0.job.get() == Some(id) {
                    self.0.job.set(None);
                    self.0.client.finish();
                    self.replied(id, reply);
                }
            }
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
            let is_posted = drawn.is_ok_and(|pixels| {
                let task = Task::Pixels(pixels);
                // Memory is all that could run out.
                let message = borsh::to_vec(&Ask { id, task }).unwrap_or_default();
                reader.0.client.post(&message)
            });
            if !is_posted {
                let sentence = tr!("The browser could not draw a frame.");
                reader.0.client.fail(sentence.to_owned());
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

    /// The job is not done: its worker failed, or the browser allows none.
    fn fail(&self, failure: Failure) {
        let Failure {
            sentence,
            had_started,
            is_forbidden,
        } = failure;
        drop(self.0.frames.take());
        if let Some(job) = self.0.job.take() {
            let details = if is_forbidden {
                alone(sentence)
            } else {
                vec![sentence]
            };
            let crash = IntakeAction::Crash {
                job,
                had_started,
                details,
            };
            self.0.send.emit(Action::Intake(crash));
        }
    }
}
