//! The page's end of the link to the course: a program of its own, fetched when it is
//! opened first, which lives in an element of the page. It says what the board shows,
//! and hears what happened there (`giveway_course::port`).

use giveway_model::tr_data;
use std::cell::Cell;
use std::rc::Rc;

use giveway_course::port::{FromPage, ToPage};
use giveway_page::lesson::{LessonAction, as_it_is, happened};
use giveway_page::{Action, FileAction, Notice};
use js_sys::Uint8Array;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{CustomEvent, CustomEventInit, Element};
use yew::prelude::*;

use crate::held::Held;
use crate::{Shown, keep, language, script};
use gloo::events::EventListener;

/// From the lesson: what the board shows.
const TO_PAGE: &str = "giveway-to-page";
/// To the lesson: what happened on the board.
const FROM_PAGE: &str = "giveway-from-page";
/// To the course: open this.
const OPEN: &str = "giveway-open";
/// To the course: the language that is spoken, as workers are told it.
const LANGUAGE: &str = "giveway-language";
/// From the course: it listens.
const READY: &str = "giveway-course-ready";
/// From the script of the course: it could not be started, for this reason.
const FAILED: &str = "giveway-course-failed";

/// The course, as the page sees it.
#[derive(Clone)]
pub(crate) struct Course(Rc<Inner>);

impl PartialEq for Course {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }
}

struct Inner {
    /// The element in which it lives: always the same, whichever language the page
    /// around it is made anew in.
    place: Option<Element>,
    send: Callback<Action>,
    stage: Held<Stage>,
    /// The state that the lesson knows.
    known: Held<Option<Shown>>,
    listening: Held<Option<Rc<[EventListener; 3]>>>,
    /// How often it was started.
    starts: Cell<u32>,
}

/// How far the program is.
#[derive(Clone, Default)]
enum Stage {
    /// Nobody has opened it yet.
    #[default]
    Absent,
    /// It comes, and is to open this then.
    Coming(String),
    /// It listens.
    Ready,
}

/// The link to the course: tells it what happens on the board of a lesson.
#[hook]
pub(crate) fn use_course(state: &Shown, send: &Callback<Action>) -> Course {
    let course = {
        let send = send.clone();
        use_memo((), move |()| {
            let place = gloo::utils::document().create_element("div").ok();
            if let Some(place) = &place {
                place.set_id("course");
            }
            Course(Rc::new(Inner {
                place,
                send,
                stage: Held::default(),
                known: Held::default(),
                listening: Held::default(),
                starts: Cell::new(0),
            }))
        })
    };
    {
        let course = (*course).clone();
        use_effect_with(state.clone(), move |state| course.tell(state));
    }
    {
        let course = (*course).clone();
        use_effect_with((), move |()| {
            let told = course.clone();
            let follow = move |what: Option<String>| {
                if let Some(what) = what {
                    course.open(&what);
                }
            };
            follow(keep::lesson());
            language::tell_workers(Callback::from(move |language: String| {
                told.dispatch(LANGUAGE, &JsValue::from_str(&language));
            }));
            let window = gloo::utils::window();
            let listening = EventListener::new(&window, "hashchange", move |event| {
                follow(keep::lesson_come(event));
            });
            move || drop(listening)
        });
    }
    (*course).clone()
}

impl Course {
    /// Where the course lives. What is in it is its own business.
    pub(crate) fn place(&self) -> Html {
        let place = self.0.place.clone();
        place.map_or_else(Html::default, |place| Html::VRef(place.into()))
    }

    /// Opens the course: its contents (an empty text), a lesson, or a step of one.
    pub(crate) fn open(&self, what: &str) {
        if !self
            .0
            .place
            .as_ref()
            .is_some_and(|place| place.is_connected())
        {
            // Inside another page there is no course.
            return;
        }
        match self.0.stage.get() {
            Stage::Ready => self.dispatch(OPEN, &JsValue::from_str(what)),
            Stage::Coming(_) => self.0.stage.set(Stage::Coming(what.to_owned())),
            Stage::Absent => {
                self.listen();
                self.0.stage.set(Stage::Coming(what.to_owned()));
                let course = self.clone();
                let number = self.0.starts.get();
                self.0.starts.set(number + 1);
                if let Err(why) = script::start("giveway-course-start", number, move |why| {
                    course.missing(why);
                }) {
                    self.missing(why);
                }
            }
        }
    }

    /// It could not be loaded: the next press tries again.
    fn missing(&self, why: String) {
        self.0.stage.set(Stage::Absent);
        self.0.send.emit(Action::File(FileAction::Tell(
            Notice::refusal(tr_data!(
                "The course could not be loaded. Try again when the network is back."
            ))
            .with([why]),
        )));
    }

    fn listen(&self) {
        let Some(place) = &self.0.place else {
            return;
        };
        let ready = {
            let course = self.clone();
            EventListener::new(place, READY, move |_| {
                if let Stage::Coming(what) = course.0.stage.get() {
                    course.0.stage.set(Stage::Ready);
                    course.dispatch(LANGUAGE, &JsValue::from_str(&language::told()));
                    course.dispatch(OPEN, &JsValue::from_str(&what));
                }
            })
        };
        let said = {
            let course = self.clone();
            EventListener::new(place, TO_PAGE, move |event| {
                let detail = event.dyn_ref().map(CustomEvent::detail);
                let bytes = detail.and_then(|detail| detail.dyn_into::<Uint8Array>().ok());
                let message = bytes.map(|bytes| ToPage::from_bytes(&bytes.to_vec()));
                match message {
                    Some(Ok(ToPage::Take)) => {
                        if let Some(state) = course.0.known.get() {
                            course.say(as_it_is(&state));
                        }
                    }
                    Some(Ok(ToPage::Speak(tag))) => language::choose(&tag, &course.0.send),
                    Some(Ok(message)) => {
                        let says = LessonAction::Says(Box::new(message));
                        course.0.send.emit(Action::Lesson(says));
                    }
                    _ => {}
                }
            })
        };
        let failed = {
            let course = self.clone();
            EventListener::new(place, FAILED, move |event| {
                let why = event.dyn_ref().map(CustomEvent::detail);
                let why = why.and_then(|why| why.as_string());
                course.missing(why.unwrap_or_default());
            })
        };
        self.0.listening.set(Some(Rc::new([ready, said, failed])));
    }

    /// Tells the lesson what happened since it was told last.
    fn tell(&self, state: &Shown) {
        let before = self.0.known.get();
        self.0.known.set(Some(state.clone()));
        let said = before.map(|before| happened(&before, state));
        self.say(said.unwrap_or_default());
    }

    fn say(&self, messages: Vec<FromPage>) {
        for message in messages {
            let bytes = Uint8Array::from(message.to_bytes().as_slice());
            self.dispatch(FROM_PAGE, &bytes.into());
        }
    }

    fn dispatch(&self, kind: &str, detail: &JsValue) {
        let init = CustomEventInit::new();
        init.set_detail(detail);
        let event = CustomEvent::new_with_event_init_dict(kind, &init);
        if let (Some(place), Ok(event)) = (&self.0.place, event) {
            // It fails only where an event is dispatched twice.
            let _ = place.dispatch_event(&event);
        }
    }
}
