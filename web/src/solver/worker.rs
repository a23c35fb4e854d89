//! One worker: started, listened to, ended.

use std::rc::Rc;

use giveway_wasm::protocol::Message;
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{ErrorEvent, MessageEvent, Worker};

/// How long a worker may take to load, in milliseconds: as long as a slow
/// network may need.
const PATIENCE_MS: u32 = 60_000;

/// What is heard of a worker.
pub(super) enum Event {
    /// It said something.
    Said(Box<Message>),
    /// It is of no more use, for this reason.
    Broke(String),
}

/// A worker; it is ended when this is dropped.
pub(super) struct Hired {
    worker: Worker,
    patience: Option<Timeout>,
    _listening: [EventListener; 3],
}

impl Drop for Hired {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

impl Hired {
    /// Starts a worker. It does not listen before it has said
    /// [`Message::Ready`].
    ///
    /// # Errors
    /// Why the browser starts none, as a sentence.
    pub(super) fn start(hear: impl Fn(Event) + 'static) -> Result<Self, String> {
        let hear = Rc::new(hear);
        let worker = Worker::new(&address()?).map_err(|error| {
            let error = js_sys::Error::from(error).message();
            format!("The browser allows no worker: {error}")
        })?;
        let on = |kind, handle: fn(&web_sys::Event) -> Event| {
            let hear = Rc::clone(&hear);
            EventListener::new(&worker, kind, move |event| hear(handle(event)))
        };
        let listening = [
            on("message", said),
            on("error", broke),
            on("messageerror", |_| {
                Event::Broke("A message could not be read.".to_owned())
            }),
        ];
        let patience = Timeout::new(PATIENCE_MS, move || {
            let sentence = "The solver's file did not arrive within a minute.";
            hear(Event::Broke(sentence.to_owned()));
        });
        Ok(Self {
            worker,
            patience: Some(patience),
            _listening: listening,
        })
    }

    /// Whether it listens.
    pub(super) const fn is_ready(&self) -> bool {
        self.patience.is_none()
    }

    /// It said that it listens.
    pub(super) fn set_ready(&mut self) {
        self.patience = None;
    }

    /// Posts a text, which cannot fail.
    pub(super) fn post(&self, text: &str) {
        let _ = self.worker.post_message(&JsValue::from_str(text));
    }
}

fn said(event: &web_sys::Event) -> Event {
    let data = event.dyn_ref().map(MessageEvent::data);
    let text = data.and_then(|data| data.as_string()).unwrap_or_default();
    match Message::from_text(&text) {
        Ok(message) => Event::Said(Box::new(message)),
        Err(error) => Event::Broke(format!("The solver said what nobody understands: {error}")),
    }
}

fn broke(event: &web_sys::Event) -> Event {
    // The page tells it itself; the console need not.
    event.prevent_default();
    let message = event.dyn_ref().map(ErrorEvent::message);
    Event::Broke(match message.unwrap_or_default().as_str() {
        "" => "The browser gave no reason.".to_owned(),
        message => format!("The browser says: {message}"),
    })
}

/// Where the worker's script is: a build puts its name into the page.
fn address() -> Result<String, String> {
    let meta = gloo::utils::document()
        .query_selector("meta[name='giveway-worker']")
        .ok()
        .flatten();
    meta.and_then(|meta| meta.get_attribute("content"))
        .ok_or_else(|| "The page does not say where the solver is.".to_owned())
}
