//! A worker: started, heard and ended.

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::tr;
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use js_sys::Uint8Array;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{ErrorEvent, MessageEvent, Worker, WorkerOptions, WorkerType};
use yew::platform::spawn_local;

use super::program::Program;

use crate::held::Held;
use crate::language;

/// How long a worker may take to load, in milliseconds: as long as a slow
/// network may need.
const PATIENCE_MS: u32 = 60_000;

/// What a worker is heard to do.
pub(super) enum Signal {
    /// It posted a message, in bytes.
    Message(Vec<u8>),
    /// It is of no more use, for this reason.
    Failed(String),
}

/// A worker; it is ended when this is dropped.
pub(super) struct WorkerHandle {
    worker: Worker,
    is_ready: Cell<bool>,
    patience: Held<Option<Timeout>>,
    /// Dropped with this: a program that arrives later is not posted.
    _here: Rc<()>,
    _listening: [EventListener; 3],
}

impl Drop for WorkerHandle {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

impl WorkerHandle {
    /// Starts a worker, which runs the program as soon as that is there. It
    /// does not listen before it has said `Message::Ready`.
    ///
    /// # Errors
    /// Why the browser starts none, as a sentence.
    pub(super) fn start(program: Rc<Program>, hear: Rc<dyn Fn(Signal)>) -> Result<Self, String> {
        let name = program.name();
        let address = written(&format!("giveway-{}-worker", name.key()))?;
        let worker = begin(&address).map_err(|error| {
            let error = js_sys::Error::from(error).message();
            tr!("The browser allows no worker: {error}", error)
        })?;
        let on = |kind, handle: fn(&web_sys::Event) -> Signal| {
            let hear = Rc::clone(&hear);
            EventListener::new(&worker, kind, move |event| hear(handle(event)))
        };
        let listening = [
            on("message", message),
            on("error", failed),
            on("messageerror", |_| {
                Signal::Failed(tr!("A message could not be read.").to_owned())
            }),
        ];
        let here = Rc::new(());
        spawn_local({
            let (worker, hear) = (worker.clone(), Rc::clone(&hear));
            let here = Rc::downgrade(&here);
            async move {
                let module = program.module().await;
                if here.upgrade().is_none() {
                    return;
                }
                let posted = module.and_then(|module| {
                    let refused = |_| tr!("The browser hands no program to a worker.").to_owned();
                    worker.post_message(&module).map_err(refused)
                });
                if let Err(sentence) = posted {
                    hear(Signal::Failed(sentence));
                }
            }
        });
        let patience = Timeout::new(PATIENCE_MS, move || {
            let sentence = tr!(
                "The {word}'s file did not arrive within a minute.",
                word = name.word()
            );
            hear(Signal::Failed(sentence));
        });
        Ok(Self {
            worker,
            is_ready: Cell::new(false),
            patience: Held::new(Some(patience)),
            _here: here,
            _listening: listening,
        })
    }

    /// Whether it listens.
    pub(super) fn is_ready(&self) -> bool {
        self.is_ready.get()
    }

    /// It said that it listens: first it hears which language is spoken.
    pub(super) fn set_ready(&self) {
        self.is_ready.set(true);
        self.patience.set(None);
        let told = language::told();
        if !told.is_empty() {
            self.speak(&told);
        }
    }

    /// Has it speak a language from now on.
    pub(super) fn speak(&self, told: &str) {
        let _ = self.worker.post_message(&JsValue::from_str(told));
    }

    /// Posts bytes, which cannot fail.
    pub(super) fn post(&self, bytes: &[u8]) {
        let _ = self.worker.post_message(&Uint8Array::from(bytes));
    }
}

fn message(event: &web_sys::Event) -> Signal {
    let data = event.dyn_ref().map(MessageEvent::data);
    let bytes = data.and_then(|data| data.dyn_ref().map(Uint8Array::to_vec));
    Signal::Message(bytes.unwrap_or_default())
}

fn failed(event: &web_sys::Event) -> Signal {
    // The page shows it, so the console need not.
    event.prevent_default();
    let reason = event.dyn_ref().map(ErrorEvent::message);
    Signal::Failed(match reason.unwrap_or_default().as_str() {
        "" => tr!("The browser gave no reason.").to_owned(),
        message => tr!("The browser says: {message}", message),
    })
}

fn begin(address: &str) -> Result<Worker, JsValue> {
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    Worker::new_with_options(address, &options)
}

/// What the page's HTML says under a name; a build puts the names of files there.
pub(crate) fn written(name: &str) -> Result<String, String> {
    let selector = format!("meta[name='{name}']");
    let element = gloo::utils::document().query_selector(&selector);
    let value = element
        .ok()
        .flatten()
        .and_then(|it| it.get_attribute("content"));
    value.ok_or_else(|| tr!("The page does not say where {name} is.", name))
}
