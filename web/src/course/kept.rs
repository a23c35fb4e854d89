//! Progress, as the browser keeps it for all of its tabs.

use giveway_course::learner::{Action, Progress, reduce};
use gloo::events::EventListener;
use wasm_bindgen::JsCast as _;
use web_sys::StorageEvent;
use yew::prelude::*;

use super::tutor::Tutor;
use crate::keep;

/// Under which name it is kept.
const NAME: &str = "course";

/// What the browser keeps.
pub(super) struct Kept {
    /// The text, as this tab read or wrote it last.
    text: String,
    _listening: EventListener,
}

impl Kept {
    /// Nothing was read yet; tells when another tab has kept something.
    pub(super) fn new(send: Callback<()>) -> Self {
        Self {
            text: String::new(),
            _listening: hear(NAME, send),
        }
    }
}

/// Hears when another tab has kept something under a name: a tab is not told of what it
/// keeps itself.
pub(super) fn hear(name: &str, send: Callback<()>) -> EventListener {
    let name = format!("giveway.{name}");
    let window = gloo::utils::window();
    EventListener::new(&window, "storage", move |event| {
        let key = event.dyn_ref::<StorageEvent>().and_then(StorageEvent::key);
        if key.as_ref() == Some(&name) {
            send.emit(());
        }
    })
}

impl Tutor {
    /// What another tab has kept since comes to what there is.
    pub(super) fn read_kept(&mut self) {
        let text = keep::load(NAME).filter(|text| *text != self.kept.text);
        let Some(text) = text else {
            return;
        };
        // What was kept may be of another version, or not ours.
        if let Ok(progress) = Progress::read(&text) {
            let learner = std::mem::take(&mut self.learner);
            (self.learner, _) = reduce(learner, Action::Kept(progress));
        }
        self.kept.text = text;
    }

    /// Keeps progress. A browser may keep nothing: then the course begins anew with the
    /// page.
    pub(super) fn keep(&mut self) {
        let text = self.learner.progress.write();
        if keep::store(NAME, &text).is_ok() {
            self.kept.text = text;
        }
    }
}
