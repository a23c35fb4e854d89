//! The line between the course and the page: events of the element in which the course
//! stands.

use giveway_course::learner::Action;
use giveway_course::port::{BoardNumber, FromPage, ToPage};
use gloo::events::EventListener;
use js_sys::Uint8Array;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{CustomEvent, CustomEventInit, Element, Event};
use yew::prelude::*;

use super::author::AuthorMsg;
use super::tutor::Msg;

/// A message to the page, in bytes.
const TO_PAGE: &str = "giveway-to-page";
/// A message from the page, in bytes.
const FROM_PAGE: &str = "giveway-from-page";
/// The page asks for the contents, a lesson or a step.
const OPEN: &str = "giveway-open";
/// The page tells the language that is spoken.
const LANGUAGE: &str = "giveway-language";
/// The course listens.
const READY: &str = "giveway-course-ready";
/// A lesson was opened, or left.
const STATE: &str = "giveway-course-state";

/// The course's end of the line.
pub(super) struct Line {
    place: Element,
    _listening: [EventListener; 3],
}

impl Line {
    /// Listens to the page.
    pub(super) fn new(place: Element, send: Callback<Msg>) -> Self {
        let heard = {
            let send = send.clone();
            EventListener::new(&place, FROM_PAGE, move |event| {
                let bytes = detail(event).dyn_ref().map(Uint8Array::to_vec);
                // The page is of the same build: it says nothing else.
                if let Ok(message) = FromPage::from_bytes(&bytes.unwrap_or_default()) {
                    send.emit(match message {
                        // Of no board of a lesson, but of a person's own page.
                        FromPage { number, what } if number == BoardNumber::default() => {
                            Msg::Author(AuthorMsg::Heard(what))
                        }
                        message => Msg::Do(Action::Page(message)),
                    });
                }
            })
        };
        let told = {
            let send = send.clone();
            EventListener::new(&place, LANGUAGE, move |event| {
                let told = detail(event).as_string();
                send.emit(Msg::Told(told.unwrap_or_default()));
            })
        };
        let opened = EventListener::new(&place, OPEN, move |event| {
            let address = detail(event).as_string();
            send.emit(Msg::Open(address.unwrap_or_default()));
        });
        Self {
            place,
            _listening: [heard, told, opened],
        }
    }

    /// Says something to the page.
    pub(super) fn say(&self, message: &ToPage) {
        let bytes = Uint8Array::from(message.to_bytes().as_slice());
        self.dispatch(TO_PAGE, &bytes);
    }

    /// Tells that the course listens.
    pub(super) fn tell_ready(&self) {
        self.dispatch(READY, &JsValue::UNDEFINED);
    }

    /// Tells whether a lesson is open.
    pub(super) fn tell_state(&self, has_lesson: bool) {
        let detail = if has_lesson { "lesson" } else { "" };
        self.dispatch(STATE, &detail.into());
    }

    fn dispatch(&self, name: &str, detail: &JsValue) {
        let init = CustomEventInit::new();
        init.set_detail(detail);
        // It fails for an event that is dispatched already, which this is not.
        if let Ok(event) = CustomEvent::new_with_event_init_dict(name, &init) {
            let _ = self.place.dispatch_event(&event);
        }
    }
}

fn detail(event: &Event) -> JsValue {
    event
        .dyn_ref::<CustomEvent>()
        .map_or(JsValue::UNDEFINED, CustomEvent::detail)
}
