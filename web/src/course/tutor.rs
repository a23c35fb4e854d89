//! The course as a whole: what a learner has done, and what must be done outside of it.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_course::grade::Came;
use giveway_course::judge::Verdict;
use giveway_course::learner::{Action, Learner, NEXT};
use giveway_course::lesson::{Id, Lesson};
use giveway_course::port::{BoardNumber, ToPage};
use giveway_course::tour::{self, Tour};
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use super::address;
use super::asker::Asker;
use super::author::{Author, is_own};
use super::class::{self, ClassMsg, ClassTable, Collected, Shows};
use super::contents::{Contents, Page};
use super::enter::no_lesson;
use super::handin::Handing;
use super::kept::Kept;
use super::keys;
use super::language;
use super::lesson;
use super::line::Line;
pub(super) use super::msg::Msg;
use super::own::Own;
use super::place::{Place, Wanted};
use super::print::Sheet;
use super::shelf::Shelf;
use super::sight::{bring_into_view, focus, has_focus, refocus};
use super::tour::Guide;
use crate::course::class::ClassProps;
use crate::course::contents::ContentsProps;
use crate::course::tour::GuideProps;
use crate::foreign::{self, Anew};
use crate::part::part;

/// The course.
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is told by itself, in any mixture"
)]
pub(super) struct Tutor {
    pub(super) learner: Learner,
    /// What the browser keeps of it.
    pub(super) kept: Kept,
    /// The tour of the page, while somebody takes it.
    pub(super) tour: Option<Tour>,
    /// The number that the board of the next tour has.
    pub(super) tours: BoardNumber,
    /// The course in the language that is spoken.
    pub(super) shelf: Option<Rc<Shelf>>,
    /// The course as it was fetched, in English.
    pub(super) fetched: Option<Rc<Shelf>>,
    /// The lessons as they were fetched, in English.
    pub(super) lessons: BTreeMap<Id, Rc<Lesson>>,
    /// Whether index and glossary are on their way.
    pub(super) is_fetching: bool,
    /// The lessons that came as a file or in a link.
    pub(super) own: Own,
    /// What is to be opened as soon as it is there.
    pub(super) wanted: Option<Wanted>,
    pub(super) page: Option<Page>,
    /// Why something is not there.
    pub(super) missing: Option<String>,
    /// The robots in the order that is tried next, by their names.
    pub(super) order: Vec<String>,
    /// The value that is being typed.
    pub(super) typed: String,
    /// What the judge said before it looked again.
    pub(super) before: Option<Box<Verdict>>,
    pub(super) is_late: bool,
    pub(super) late: Option<Timeout>,
    /// Whether the title of a step that is new takes the focus.
    pub(super) is_new: bool,
    /// Whether something of the course had the focus before what happened.
    pub(super) had_focus: bool,
    /// Whether the judge has just said something.
    pub(super) has_said: bool,
    pub(super) title: NodeRef,
    pub(super) next: NodeRef,
    pub(super) author: Author,
    pub(super) asker: Asker,
    pub(super) line: Option<Line>,
    /// What is typed while the lesson is handed in.
    pub(super) handing: Option<Handing>,
    /// The name in the last form, for the next one; it is not kept.
    pub(super) hand_name: String,
    /// The hand-ins of a class.
    pub(super) class: Option<Collected>,
    /// Hand-ins that came before the course was there.
    pub(super) arriving: Option<Vec<Came>>,
    /// The lesson on its way to a printer.
    pub(super) sheet: Option<Sheet>,
    /// How often the elements were built anew.
    built: u32,
    _listening: [EventListener; 2],
}

impl Component for Tutor {
    type Message = Msg;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> Self {
        let asker = Asker::new(ctx.link().callback(Msg::Do));
        let mut tutor = Self {
            learner: Learner::default(),
            kept: Kept::new(ctx.link().callback(|()| Msg::Elsewhere)),
            tour: None,
            tours: tour::FIRST,
            shelf: None,
            fetched: None,
            lessons: BTreeMap::new(),
            is_fetching: false,
            own: Own::default(),
            wanted: None,
            page: None,
            missing: None,
            order: Vec::new(),
            typed: String::new(),
            before: None,
            is_late: false,
            late: None,
            is_new: false,
            had_focus: false,
            has_said: false,
            title: NodeRef::default(),
            next: NodeRef::default(),
            author: Author::new(&asker, ctx.link().callback(Msg::Author)),
            asker,
            line: None,
            handing: None,
            hand_name: String::new(),
            class: None,
            arriving: None,
            sheet: None,
            built: 0,
            _listening: [
                keys::listen(),
                foreign::listen(ctx.link().callback(|()| Msg::Foreign)),
            ],
        };
        tutor.read_kept();
        tutor.fetch(ctx);
        tutor
    }

    fn update(&mut self, ctx: &Context<Self>, msg: Msg) -> bool {
        // The card of the tour brings the focus back by itself.
        self.had_focus |= self.tour.is_none() && has_focus();
        let is_followed = matches!(msg, Msg::Open(_));
        match msg {
            Msg::Do(Action::Page(message)) if self.tour.is_some() => {
                self.guide(tour::Action::Page(message));
            }
            Msg::Do(action) if self.heard_of_work(ctx, &action) => {}
            Msg::Do(action) => self.act(ctx, action),
            Msg::Hand(msg) => self.hand(ctx, msg),
            Msg::Class(msg) => self.collect(ctx, msg),
            Msg::Author(msg) => self.author(ctx, msg),
            Msg::Tour(action) => self.guide(action),
            Msg::Open(name) if name == tour::NAME => self.begin_tour(ctx),
            Msg::Open(name) if name == NEXT => self.begin(ctx),
            Msg::Open(address) if Came::is_in(&address) => {
                self.collect(ctx, ClassMsg::Came(Came::all(&address)));
            }
            Msg::Open(address) if is_own(&address) => self.arrive(ctx, address),
            Msg::Open(address) => {
                if let Some(place) = Place::read(&address) {
                    self.enter(ctx, place);
                } else {
                    self.guide(tour::Action::End);
                    self.show(Some(Page::Lessons));
                    if !address.is_empty() {
                        self.missing = Some(no_lesson(&address));
                    }
                }
            }
            Msg::Enter(place) => self.enter(ctx, place),
            Msg::Remove(id) => self.remove_own(&id),
            Msg::BringBack => self.bring_back(),
            Msg::Told(told) => Self::turn(ctx, told),
            Msg::Spoken => self.reword(ctx),
            Msg::Shelved(shelf) => self.shelved(ctx, shelf),
            Msg::Fetched(place, lesson) => self.fetched(ctx, place, lesson),
            Msg::Elsewhere => self.read_kept(),
            Msg::Show(page) => self.show(page),
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
            Msg::Foreign => self.built += 1,
            Msg::Present => {
                if let Some(line) = &self.line {
                    line.say(&ToPage::Present);
                }
            }
            Msg::Speak(tag) => {
                if let Some(line) = &self.line {
                    line.say(&ToPage::Speak(tag.to_owned()));
                }
            }
            Msg::Print => {
                // One that no browser told the end of goes first.
                self.sheet = None;
                self.sheet = Sheet::new(ctx.link().callback(|msg: Msg| msg));
            }
            Msg::Printed => self.sheet = None,
        }
        // What did not arrive is tried again whenever the contents are opened.
        if self.page.is_some() && self.missing.is_none() {
            self.fetch(ctx);
        }
        // The page has taken the link out of the address.
        if is_followed {
            address::show(self.learner.open.as_ref());
        }
        true
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let send = ctx.link().callback(|msg: Msg| msg);
        html! {
            <Anew key={self.built}>
                if let (Some(open), Some(shelf)) = (&self.learner.open, &self.shelf) {
                    { lesson::show(self, open, shelf, &send) }
                    if let Some(sheet) = &self.sheet { { sheet.show(&open.id, &open.lesson) } }
                }
                if let Some(tour) = &self.tour {
                    { part::<Guide>(GuideProps { tour: tour.clone(), spoken: language::tag(), send: send.clone() }) }
                }
                if let Some(page) = &self.page {
                    { part::<Contents>(ContentsProps { spoken: language::tag(), page: *page, shelf: self.shelf.clone(), progress: self.learner.progress.clone(), own: self.own.clone(), missing: self.missing.clone(), send: send.clone() }) }
                }
                if let Some(class) = &self.class {
                    if class.shows == Shows::Table {
                        { part::<ClassTable>(ClassProps { content: class.content(&send), version: (class.version(), language::tag()), send: send.clone() }) }
                    }
                    if class.shows == Shows::Work { { class::show_work(self, class, &send) } }
                }
                { self.author_view(&send) }
            </Anew>
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
        if std::mem::take(&mut self.had_focus) {
            refocus();
        }
        if std::mem::take(&mut self.has_said) {
            bring_into_view();
        }
        if let Some(sheet) = &mut self.sheet {
            sheet.print();
        }
    }
}
