//! The course as a whole: what a learner has done, and what must be done outside of it.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_course::judge::Verdict;
use giveway_course::learner::{Action, Effect, Judge, Learner, Open, Progress, reduce};
use giveway_course::lesson::{Id, Lesson};
use giveway_course::port::ToPage;
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use yew::platform::spawn_local;
use yew::prelude::*;

use super::asker::Asker;
use super::author::{Author, AuthorMsg, is_own};
use super::contents::{Contents, Page};
use super::keys;
use super::lesson;
use super::line::Line;
use super::place::Place;
use super::shelf::Shelf;
use super::sight::{bring_into_view, focus};
use crate::keep;

/// Under which name progress is kept.
const KEPT: &str = "course";
/// How long the judge may look before that is said, in milliseconds.
const LATE_MS: u32 = 300;

/// What happens in the course.
#[derive(Clone)]
pub(super) enum Msg {
    /// Something that a learner does, or hears.
    Do(Action),
    /// The page wants an address to be opened; the contents, where it is empty.
    Open(String),
    /// A place is chosen.
    Enter(Place),
    /// Index and glossary are there, or are not.
    Shelved(Result<Rc<Shelf>, String>),
    /// A lesson is there, or is not.
    Fetched(Place, Result<Rc<Lesson>, String>),
    /// Something is done in the editor.
    Author(AuthorMsg),
    /// Shows a page of the contents, or closes them.
    Show(Option<Page>),
    /// Moves a robot in the order, from one place to another.
    Move(usize, usize),
    /// Types a value.
    Type(String),
    /// The judge has been looking for a while.
    Late,
}

/// The course.
pub(super) struct Tutor {
    pub(super) learner: Learner,
    pub(super) shelf: Option<Rc<Shelf>>,
    lessons: BTreeMap<Id, Rc<Lesson>>,
    /// What is to be opened as soon as it is there.
    wanted: Option<Place>,
    page: Option<Page>,
    /// Why something is not there.
    missing: Option<String>,
    /// The robots in the order that is tried next, by their names.
    pub(super) order: Vec<String>,
    /// The value that is being typed.
    pub(super) typed: String,
    /// What the judge said before it looked again.
    pub(super) before: Option<Box<Verdict>>,
    pub(super) is_late: bool,
    late: Option<Timeout>,
    /// Whether the title of a step that is new takes the focus.
    is_new: bool,
    /// Whether the judge has just said something.
    has_said: bool,
    pub(super) title: NodeRef,
    pub(super) next: NodeRef,
    pub(super) author: Author,
    asker: Asker,
    line: Option<Line>,
    _keys: EventListener,
}

impl Component for Tutor {
    type Message = Msg;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> Self {
        let link = ctx.link().clone();
        spawn_local(async move {
            let shelf = Shelf::fetch().await;
            link.send_message(Msg::Shelved(shelf.map(Rc::new)));
        });
        // What was kept may be of another version, or not ours.
        let kept = keep::load(KEPT).and_then(|text| Progress::read(&text).ok());
        let (learner, _) = reduce(Learner::default(), Action::Kept(kept.unwrap_or_default()));
        Self {
            learner,
            shelf: None,
            lessons: BTreeMap::new(),
            wanted: None,
            page: None,
            missing: None,
            order: Vec::new(),
            typed: String::new(),
            before: None,
            is_late: false,
            late: None,
            is_new: false,
            has_said: false,
            title: NodeRef::default(),
            next: NodeRef::default(),
            author: Author::new(ctx.link().callback(Msg::Author)),
            asker: Asker::new(ctx.link().callback(Msg::Do)),
            line: None,
            _keys: keys::listen(),
        }
    }

    fn update(&mut self, ctx: &Context<Self>, msg: Msg) -> bool {
        match msg {
            Msg::Do(action) => self.act(ctx, action),
            Msg::Author(msg) => self.author(ctx, msg),
            Msg::Open(address) if is_own(&address) => self.arrive(ctx, address),
            Msg::Open(address) => match Place::read(&address) {
                Some(place) => self.enter(ctx, place),
                None => self.page = Some(Page::Lessons),
            },
            Msg::Enter(place) => self.enter(ctx, place),
            Msg::Shelved(Ok(shelf)) => {
                self.shelf = Some(shelf);
                if let Some(place) = self.wanted.take() {
                    self.enter(ctx, place);
                }
                self.arrive_late(ctx);
            }
            Msg::Fetched(place, Ok(lesson)) => {
                self.lessons.insert(place.lesson.clone(), lesson);
                if self.wanted.as_ref() == Some(&place) {
                    self.enter(ctx, place);
                }
            }
            Msg::Shelved(Err(sentence)) | Msg::Fetched(_, Err(sentence)) => {
                self.missing = Some(sentence);
                self.page = Some(Page::Lessons);
            }
            Msg::Show(page) => self.page = page,
            Msg::Move(from, to) => {
                let mut order = self.order();
                if from < order.len() && to < order.len() {
                    let robot = order.remove(from);
                    order.insert(to, robot);
                }
                self.order = order;
            }
            Msg::Type(typed) => self.typed = typed,
            Msg::Late => self.is_late = true,
        }
        true
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let send = ctx.link().callback(|msg: Msg| msg);
        html! {
            <>
                if let (Some(open), Some(shelf)) = (&self.learner.open, &self.shelf) {
                    { lesson::show(self, open, shelf, &send) }
                }
                if let Some(page) = &self.page {
                    <Contents page={*page} shelf={self.shelf.clone()} progress={self.learner.progress.clone()}
                        missing={self.missing.clone()} send={send.clone()} />
                }
                { self.author_view(&send) }
            </>
        }
    }

    fn rendered(&mut self, ctx: &Context<Self>, first: bool) {
        if first && let Some(place) = super::place() {
            let line = Line::new(place, ctx.link().callback(|msg: Msg| msg));
            line.tell_ready();
            self.line = Some(line);
        }
        if std::mem::take(&mut self.is_new) {
            focus(&self.title);
        }
        if std::mem::take(&mut self.has_said) {
            bring_into_view();
        }
    }
}

impl Tutor {
    /// Opens a place, as soon as what it takes is there.
    fn enter(&mut self, ctx: &Context<Self>, place: Place) {
        self.asker.warm();
        self.missing = None;
        let Some(shelf) = self.shelf.clone() else {
            self.wanted = Some(place);
            return;
        };
        if shelf.entry(&place.lesson).is_none() {
            // A link to a lesson that there is not: here are those that there are.
            self.page = Some(Page::Lessons);
            return;
        }
        if let Some(lesson) = self.lessons.get(&place.lesson) {
            let action = Action::Open {
                id: place.lesson,
                lesson: Rc::clone(lesson),
                at: place.step,
            };
            self.wanted = None;
            self.page = None;
            return self.act(ctx, action);
        }
        self.wanted = Some(place.clone());
        let link = ctx.link().clone();
        spawn_local(async move {
            let lesson = shelf.lesson(&place.lesson).await;
            link.send_message(Msg::Fetched(place, lesson.map(Rc::new)));
        });
    }

    /// Sees to it that the solver is there when the first task is judged.
    pub(super) fn warm(&self) {
        self.asker.warm();
    }

    /// Says something to the page.
    pub(super) fn say(&self, message: &ToPage) {
        if let Some(line) = &self.line {
            line.say(message);
        }
    }

    /// Nothing but the lesson is shown, or what comes over it.
    pub(super) fn close_contents(&mut self) {
        self.page = None;
        self.missing = None;
    }

    pub(super) fn act(&mut self, ctx: &Context<Self>, action: Action) {
        let was_tried = self.learner.open.as_ref().is_some_and(Open::is_tried);
        let is_next = action == Action::Next;
        let is_left_there = matches!(action, Action::Page(_));
        let was = self.step();
        let said = self.learner.open.as_ref().map(|open| open.judge().clone());
        let (learner, effects) = reduce(std::mem::take(&mut self.learner), action);
        self.learner = learner;
        if let Some(Judge::Said(verdict)) = &said {
            self.before = Some(verdict.clone());
        }
        let now = self.learner.open.as_ref().map(|open| open.judge().clone());
        self.has_said |= now != said && matches!(now, Some(Judge::Said(_)));
        let is = self.step();
        if is != was {
            self.order.clear();
            self.typed.clear();
            self.before = None;
            self.is_new = is.is_some();
            self.has_said = false;
            // After the last step there is the next lesson to choose.
            if is.is_none() && was_tried && !is_left_there {
                self.author.back();
            } else if is.is_none() && is_next {
                self.page = Some(Page::Lessons);
            }
        }
        self.watch(ctx);
        for effect in effects {
            self.effect(effect);
        }
        if let Some(line) = &self.line
            && is.is_some() != was.is_some()
        {
            line.tell_state(is.is_some());
        }
    }

    fn effect(&self, effect: Effect) {
        match effect {
            Effect::Ask { number, request } => self.asker.ask(number, *request),
            Effect::Forget => self.asker.forget(),
            Effect::Page(message) => self.say(&message),
            // A browser may keep nothing: then the course begins anew with the page.
            Effect::Keep(progress) => drop(keep::store(KEPT, &progress.write())),
            Effect::FocusNext => focus(&self.next),
        }
    }

    /// Says that the judge looks only where that takes long.
    fn watch(&mut self, ctx: &Context<Self>) {
        let judge = self.learner.open.as_ref().map(Open::judge);
        if matches!(judge, Some(Judge::Looking(_))) {
            if self.late.is_none() {
                let link = ctx.link().clone();
                let late = Timeout::new(LATE_MS, move || link.send_message(Msg::Late));
                self.late = Some(late);
            }
        } else {
            self.late = None;
            self.is_late = false;
        }
    }

    /// The lesson that is open, and its step.
    fn step(&self) -> Option<(Id, usize)> {
        let open = self.learner.open.as_ref()?;
        Some((open.id.clone(), open.index()))
    }

    /// The robots in the order that is tried next: that of the scene at first.
    pub(super) fn order(&self) -> Vec<String> {
        let Some(open) = &self.learner.open else {
            return Vec::new();
        };
        let agents = &open.scene().agents;
        let is_whole = agents.len() == self.order.len()
            && agents.iter().all(|agent| self.order.contains(&agent.name));
        if is_whole {
            return self.order.clone();
        }
        agents.iter().map(|agent| agent.name.clone()).collect()
    }
}
