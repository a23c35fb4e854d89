//! What happens to a class, and what is done outside of it then.

use std::rc::Rc;

use giveway_course::grade::{Came, Given, LookAction, Next};
use giveway_course::learner::Action;
use giveway_course::lesson::{Id, Lesson};
use giveway_course::port::{FromPage, Happened, ToPage};
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use super::{BOARD, ClassMsg, Collected, Shows};
use crate::course::language;
use crate::course::tutor::{Msg, Tutor};

/// For so many milliseconds tasks are judged without a pause, where the solver is not asked.
const AT_ONCE_MS: f64 = 8.0;

impl Tutor {
    /// What happens to a class.
    pub(in crate::course) fn collect(&mut self, ctx: &Context<Self>, msg: ClassMsg) {
        match msg {
            ClassMsg::Open => self.open_class(ctx, Vec::new()),
            ClassMsg::Came(files) => self.open_class(ctx, files),
            ClassMsg::Fetched(id, lesson) => {
                match lesson {
                    Ok(lesson) => {
                        self.lessons.insert(id.clone(), Rc::clone(&lesson));
                        self.give(id, &lesson);
                    }
                    Err(sentence) => self.of_class(|it| it.told = sentence),
                }
                self.judge_on(ctx);
            }
            ClassMsg::Solver(action) => {
                self.of_class(|it| it.hear(action));
                self.judge_on(ctx);
            }
            ClassMsg::Step => self.judge_on(ctx),
            ClassMsg::Cancel => self.of_class(|it| {
                it.class.cancel();
                it.asked = None;
                it.asker.end();
            }),
            ClassMsg::GoOn => {
                self.of_class(|it| it.class.go_on());
                self.judge_on(ctx);
            }
            ClassMsg::Close => {
                self.leave_work();
                self.of_class(|it| it.shows = Shows::Nothing);
            }
            ClassMsg::Forget => {
                self.leave_work();
                if let Some(it) = self.class.take() {
                    it.asker.end();
                }
                self.open_class(ctx, Vec::new());
            }
            ClassMsg::Look(action) => {
                self.of_class(|it| it.looking = it.looking.reduce(action, &it.class));
                self.of_class(|it| it.told.clear());
                match action {
                    LookAction::Choose(_) | LookAction::LookAt(_) => self.show_work(),
                    LookAction::Lesson(_) | LookAction::Order(_) => {}
                }
            }
            ClassMsg::Back => {
                self.leave_work();
                self.of_class(|it| it.shows = Shows::Table);
            }
            ClassMsg::Save => self.of_class(Collected::save),
            ClassMsg::Copy => {
                let tell = ctx.link().callback(Msg::Class);
                self.of_class(|it| it.copy(tell));
            }
            ClassMsg::CopyWork => {
                let tell = ctx.link().callback(Msg::Class);
                self.of_class(|it| it.copy_work(tell));
            }
            ClassMsg::Told(told) => self.of_class(|it| it.told = told),
        }
    }

    /// What the page tells of the board with a student's work; whether it is about that.
    pub(in crate::course) fn heard_of_work(
        &mut self,
        ctx: &Context<Self>,
        action: &Action,
    ) -> bool {
        match action {
            Action::Page(FromPage { number, what }) if *number == BOARD => {
                if *what == Happened::Closed {
                    self.collect(ctx, ClassMsg::Back);
                }
                true
            }
            _ => false,
        }
    }

    /// Whether the table of a class is shown.
    pub(in crate::course) fn is_class_open(&self) -> bool {
        self.class
            .as_ref()
            .is_some_and(|it| it.shows == Shows::Table)
    }

    fn of_class(&mut self, change: impl FnOnce(&mut Collected)) {
        if let Some(it) = &mut self.class {
            it.version = it.version.wrapping_add(1);
            change(it);
        }
    }

    /// Opens the table with files that came, as soon as the course is there.
    fn open_class(&mut self, ctx: &Context<Self>, files: Vec<Came>) {
        let Some(shelf) = self.shelf.clone() else {
            self.arriving.get_or_insert_default().extend(files);
            return self.fetch(ctx);
        };
        self.author.leave();
        self.close_contents();
        if self.learner.open.is_some() {
            self.act(ctx, Action::Close);
        }
        self.tour = None;
        let asker = &self.asker;
        let hear = || {
            ctx.link()
                .callback(|action| Msg::Class(ClassMsg::Solver(action)))
        };
        let it = self
            .class
            .get_or_insert_with(|| Collected::new(asker.beside(hear())));
        it.add(files, &shelf.glossary);
        if it.shows == Shows::Work {
            self.leave_work();
        }
        self.of_class(|it| it.shows = Shows::Table);
        self.seek_lessons(ctx);
        self.judge_on(ctx);
    }

    /// Opens the class whose files came before the course was there.
    pub(in crate::course) fn class_late(&mut self, ctx: &Context<Self>) {
        if let Some(files) = self.arriving.take() {
            self.open_class(ctx, files);
        }
    }

    /// Looks for the lessons of hand-ins, in the course and among those of one's own.
    fn seek_lessons(&mut self, ctx: &Context<Self>) {
        let (Some(it), Some(shelf)) = (&mut self.class, self.shelf.clone()) else {
            return;
        };
        for id in it.missing_lessons() {
            if !it.sought.insert(id.clone()) {
                continue;
            }
            if shelf.entry(&id).is_none() {
                continue;
            }
            let link = ctx.link().clone();
            let (shelf, known) = (Rc::clone(&shelf), self.lessons.get(&id).cloned());
            yew::platform::spawn_local(async move {
                let lesson = match known {
                    Some(lesson) => Ok(lesson),
                    None => shelf.lesson(&id).await.map(Rc::new),
                };
                link.send_message(Msg::Class(ClassMsg::Fetched(id, lesson)));
            });
        }
        let missing = self.class.as_ref().map(Collected::missing_lessons);
        for id in missing.unwrap_or_default() {
            if let Some(lesson) = self.own(&id) {
                self.of_class(|it| it.class.give(Given::new(id, lesson)));
            }
        }
    }

    /// A lesson against which hand-ins are judged, in the words of the language that is spoken.
    fn give(&mut self, id: Id, lesson: &Rc<Lesson>) {
        let said = Rc::new(language::said(&**lesson));
        self.of_class(|it| it.class.give(Given::new(id, said)));
    }

    /// Tells the lessons of the course in the words of the language that is spoken now.
    pub(in crate::course) fn reword_class(&mut self) {
        let lessons = self.lessons.iter();
        let said: Vec<(Id, Rc<Lesson>)> = lessons
            .map(|(id, lesson)| (id.clone(), Rc::new(language::said(&**lesson))))
            .collect();
        self.of_class(|it| {
            for (id, lesson) in &said {
                it.class.reword(id, lesson);
            }
        });
    }

    /// Judges until the solver must be asked, or for a moment.
    fn judge_on(&mut self, ctx: &Context<Self>) {
        let Some(it) = &mut self.class else {
            return;
        };
        it.version = it.version.wrapping_add(1);
        it.settle();
        it.pause = None;
        let begin = js_sys::Date::now();
        loop {
            match it.class.step() {
                Next::Ask { number, request } => {
                    if it.asked != Some(number) {
                        it.asked = Some(number);
                        it.asker.ask(number, *request);
                    }
                    return;
                }
                Next::Again if js_sys::Date::now() - begin < AT_ONCE_MS => {}
                Next::Again => {
                    let link = ctx.link().clone();
                    let go_on = move || link.send_message(Msg::Class(ClassMsg::Step));
                    it.pause = Some(Timeout::new(0, go_on));
                    return;
                }
                Next::Done => {
                    if it.asked.take().is_some() {
                        it.asker.end();
                    }
                    return;
                }
            }
        }
    }

    /// A person's own board comes back.
    fn leave_work(&mut self) {
        if self
            .class
            .as_ref()
            .is_some_and(|it| it.shows == Shows::Work)
        {
            self.say(&ToPage::Close);
            self.tell_lesson(false);
        }
    }

    fn show_work(&mut self) {
        let Some((board, evidence)) = self.class.as_ref().and_then(Collected::board) else {
            return;
        };
        self.of_class(|it| it.shows = Shows::Work);
        self.is_new = true;
        self.say(&ToPage::Open(Box::new(board)));
        if let Some(evidence) = evidence {
            self.say(&ToPage::Show(Box::new(evidence)));
        }
        self.tell_lesson(true);
    }
}
