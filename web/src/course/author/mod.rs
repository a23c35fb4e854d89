//! A lesson of one's own: the editor in which it is written, and what is done with a
//! lesson that comes as a file or in a link.
//!
//! What is written, and what is wrong with it, is decided in `giveway_course::author`;
//! here it becomes a dialog, and a text that the browser keeps.

mod adapt;
mod arrive;
mod check;
mod desk;
mod fields;
mod kept;
mod notes;
mod preview;
mod share;
mod steps;
mod todo;
mod top;

use std::rc::Rc;

use giveway_course::author::check::{Action as CheckAction, LessonCheck, Standing};
use giveway_course::author::{Action, Draft, Looked, Whose, reduce};
use giveway_course::learner;
use giveway_course::lesson::{Glossary, Picture};
use giveway_course::port::{Happened, ToPage};
use giveway_model::{Fault, tr};
use gloo::events::EventListener;
use yew::prelude::*;

use super::asker::Asker;
use super::kept::hear;
use super::tutor::{Msg, Tutor};
use crate::board::Film;
use crate::course::author::{desk::DeskProps, share::RefusedProps};
use crate::part::{keyed_part, part};

use desk::Desk;
use notes::Notes;
use share::{Refusal, Refused};

pub(super) use arrive::is_own;

/// What is done in the editor.
#[derive(Clone)]
pub(in crate::course) enum AuthorMsg {
    /// It is opened, with what was kept.
    Open,
    /// It is opened with a copy of the lesson on the board, which is left.
    Adapt,
    /// It is closed; what is written stays.
    Close,
    /// Something happens to the draft.
    Act(Action),
    /// The board on the page is asked for.
    Take,
    /// The page tells what is on its board.
    Heard(Happened),
    /// The board of the step goes onto the page, to be changed there.
    ToPage,
    /// The step is tried as the learner has it.
    Try,
    /// The lesson is saved as a file.
    Save,
    /// Something happens to the check before the lesson is shared.
    Check(CheckAction),
    /// The lesson is copied as a link, once it is checked; or although it is not known
    /// whether all of its tasks are right.
    Copy { anyway: bool },
    /// Something was done, or not: a sentence.
    Told(String),
    /// Another tab has kept a draft.
    Elsewhere,
    /// The draft of the other tab is taken.
    TakeElsewhere,
    /// A file was chosen, with this text.
    File(String),
    /// The refusal with this number was read.
    Dismiss(u32),
}

/// The editor.
pub(in crate::course) struct Author {
    pub(super) draft: Rc<Draft>,
    pub(super) looked: Option<Rc<Looked>>,
    /// The board of the step that is shown.
    pub(super) film: Option<Rc<Film>>,
    is_open: bool,
    /// Whether what is missing is told, too: after somebody wanted to go on.
    pub(super) is_strict: bool,
    /// What was done last, as a sentence.
    pub(super) told: String,
    /// What another tab has kept since, and whether that is put aside.
    theirs: Option<(String, bool)>,
    /// Whether the browser does not keep the draft.
    pub(super) is_unkept: bool,
    /// What is wrong with a lesson that came as a file or in a link.
    refusal: Option<Refusal>,
    /// How many lessons were refused.
    refusals: u32,
    /// A lesson that came before the glossary was there.
    arriving: Option<String>,
    /// The check before the lesson is shared.
    check: LessonCheck,
    /// Asks the solver for it.
    checker: Asker,
    send: Callback<AuthorMsg>,
    _listening: EventListener,
}

impl Author {
    /// The editor, closed.
    pub(in crate::course) fn new(asker: &Asker, send: Callback<AuthorMsg>) -> Self {
        let listening = hear(kept::NAME, send.reform(|()| AuthorMsg::Elsewhere));
        Self {
            draft: Rc::default(),
            looked: None,
            film: None,
            is_open: false,
            is_strict: false,
            told: String::new(),
            theirs: None,
            is_unkept: false,
            refusal: None,
            refusals: 0,
            arriving: None,
            check: LessonCheck::default(),
            checker: asker.beside(check::hear(&send)),
            send,
            _listening: listening,
        }
    }

    /// Something happens to the draft, which is kept at once.
    fn act(&mut self, action: Action, glossary: &Glossary) {
        let is_kept = matches!(&action, Action::Kept(_) | Action::Before(_) | Action::Go(_));
        let is_other = matches!(
            &action,
            Action::New | Action::Open(_) | Action::Take(_) | Action::Undo
        );
        let same_board = matches!(&action, Action::Write { whose, field, .. }
            if *whose == Whose::Lesson || (field != "time" && field != "plan"));
        if !matches!(action, Action::Go(_)) {
            self.check(CheckAction::Cancel);
        }
        self.told.clear();
        self.draft = Rc::new(reduce((*self.draft).clone(), action));
        if same_board {
            self.looked = Some(Rc::new(self.draft.look(glossary)));
        } else {
            self.look(glossary);
        }
        if !is_kept {
            self.keep();
        }
        if is_other {
            self.keep_before();
        }
    }

    fn look(&mut self, glossary: &Glossary) {
        let looked = self.draft.look(glossary);
        let at = self.draft.at();
        let step = looked.step(at);
        self.film = self.draft.scene(at).and_then(|scene| {
            Film::of(&Picture {
                scene: scene.clone(),
                plan: step.and_then(|step| step.plan.clone()),
                time: step.map_or(0, |step| step.time),
            })
        });
        self.looked = Some(Rc::new(looked));
    }

    /// Tells what is wrong with a lesson that came, in the place of what was told before.
    fn refuse(&mut self, faults: Vec<Fault>) {
        self.refusals += 1;
        self.refusal = Some(Refusal {
            number: self.refusals,
            faults: faults.into(),
        });
    }

    /// A lesson that is whole; else what is missing is told from now on.
    fn whole(&mut self) -> Option<giveway_course::lesson::Lesson> {
        let whole = self.looked.as_ref()?.whole().ok().cloned();
        if whole.is_none() {
            self.is_strict = true;
            tr!("Something is still missing, or not as it must be.").clone_into(&mut self.told);
        }
        whole
    }
}

impl Tutor {
    /// Something is done in the editor.
    pub(super) fn author(&mut self, ctx: &Context<Self>, msg: AuthorMsg) {
        let Some(shelf) = self.shelf.clone() else {
            return;
        };
        let glossary = &shelf.glossary;
        let author = &mut self.author;
        match msg {
            AuthorMsg::Open => {
                self.close_contents();
                self.author.open(glossary);
            }
            AuthorMsg::Adapt => self.adapt(ctx),
            AuthorMsg::Close => author.leave(),
            AuthorMsg::Act(action) => author.act(action, glossary),
            AuthorMsg::Take => self.say(&ToPage::Take),
            AuthorMsg::Heard(happened) => {
                let action = match happened {
                    Happened::Board(scene) => Action::TakeScene(scene),
                    Happened::Led(plan) => Action::TakePlan(plan),
                    Happened::Time(time) => Action::TakeTime(time),
                    _ => return,
                };
                author.act(action, glossary);
                tr!("Board copied into this step.").clone_into(&mut author.told);
            }
            AuthorMsg::ToPage => {
                if share::show_on_page(&author.draft) {
                    author.leave();
                }
            }
            AuthorMsg::Try => {
                let at = author.draft.at();
                let to_try = author.looked.as_ref().and_then(|looked| looked.to_try(at));
                let Some((lesson, at)) = to_try else {
                    drop(author.whole());
                    return;
                };
                author.leave();
                let lesson = Rc::new(lesson);
                self.warm();
                self.act(ctx, learner::Action::Try { lesson, at });
            }
            AuthorMsg::Save => {
                if let Some(lesson) = author.whole() {
                    let is_checked = author.check.standing(&lesson) == Standing::Passed;
                    author.told = share::save(&lesson, is_checked);
                }
            }
            AuthorMsg::Check(action) => author.check(action),
            AuthorMsg::Copy { anyway } => {
                if let Some(lesson) = author.whole().map(Rc::new) {
                    author.check(CheckAction::Share { lesson, anyway });
                }
            }
            AuthorMsg::Told(told) => author.told = told,
            AuthorMsg::Elsewhere => author.hear(),
            AuthorMsg::TakeElsewhere => author.take(glossary),
            AuthorMsg::File(text) => match arrive::from_file(&text, glossary) {
                Ok(lesson) => author.act(Action::Open(Box::new(lesson)), glossary),
                Err(faults) => author.refuse(faults),
            },
            // The browser tells late that a dialog was closed; another one may be there by then.
            AuthorMsg::Dismiss(number) => {
                author.refusal.take_if(|refusal| refusal.number == number);
            }
        }
    }

    /// What lies over the page: the editor, or what is wrong with a lesson that came.
    pub(super) fn author_view(&self, send: &Callback<Msg>) -> Html {
        let author = &self.author;
        let write = send.reform(Msg::Author);
        html! {
            <>
                if let (true, Some(shelf), Some(looked)) = (author.is_open, &self.shelf, &author.looked) {
                    { part::<Desk>(DeskProps { draft: Rc::clone(&author.draft), looked: Rc::clone(looked), film: author.film.clone(), shelf: Rc::clone(shelf), notes: author.notes(), send: send.clone() }) }
                }
                if let Some(refusal) = &author.refusal {
                    { keyed_part::<Refused>(refusal.number, RefusedProps { refusal: refusal.clone(), send: write }) }
                }
            </>
        }
    }
}

impl Author {
    /// The editor is closed; what it is at is of no more use.
    pub(in crate::course) fn leave(&mut self) {
        self.is_open = false;
        self.check(CheckAction::Cancel);
        self.told.clear();
    }

    /// The lesson that was tried was left.
    pub(in crate::course) fn back(&mut self) {
        self.is_open = true;
    }
}
