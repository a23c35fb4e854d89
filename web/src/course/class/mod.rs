//! A class's hand-ins: files come in, each task is judged anew, and a table tells what came of
//! it. What is judged, and how, is decided in `giveway_course::grade`.

mod arrive;
mod board;
mod collect;
mod foot;
mod keys;
mod side;
mod table;
mod work;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_course::grade::{Came, Class, LookAction, Looking, csv};
use giveway_course::learner::{Action, AskNumber};
use giveway_course::lesson::{Id, Lesson};
use giveway_course::port::BoardNumber;
use giveway_model::tr;
use gloo::file::Blob;
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use super::asker::Asker;
use crate::{copy, files};

pub(super) use table::ClassProps;
pub(super) use table::ClassTable;
pub(super) use work::show as show_work;

/// The number of the board that shows a student's work; none of a lesson or a tour has it.
const BOARD: BoardNumber = BoardNumber(u32::MAX);

/// What is known of a class. Nothing of it is kept: when the page is closed, the names are gone.
pub(super) struct Collected {
    pub(super) class: Class,
    /// Which of it is looked at.
    looking: Looking,
    /// What is shown.
    pub(super) shows: Shows,
    asker: Asker,
    /// What the solver is asked.
    asked: Option<AskNumber>,
    /// Lessons that were looked for.
    sought: BTreeSet<Id>,
    /// How many links came without a name.
    links: usize,
    /// What became of the table when it was saved or copied.
    told: String,
    /// How often anything changed.
    version: u32,
    /// Goes on to judge after a pause.
    pause: Option<Timeout>,
}

/// What is shown of a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shows {
    /// Nothing.
    Nothing,
    /// The table, over the page.
    Table,
    /// A student's work, on the board.
    Work,
}

/// What happens to a class.
#[derive(Clone)]
pub(super) enum ClassMsg {
    /// The table is opened.
    Open,
    /// Files or links came.
    Came(Vec<Came>),
    /// A lesson of the course is there, or is not.
    Fetched(Id, Result<Rc<Lesson>, String>),
    /// The solver answered, or broke down.
    Solver(Action),
    /// Goes on to judge.
    Step,
    /// A person stops it.
    Cancel,
    /// A person lets it go on.
    GoOn,
    /// The table is closed; the class stays.
    Close,
    /// The class is forgotten.
    Forget,
    /// Another part of it is looked at.
    Look(LookAction),
    /// From the work back to the table.
    Back,
    /// The table is saved as CSV.
    Save,
    /// The table is copied as CSV.
    Copy,
    /// What is given back to the student whose work is shown is copied.
    CopyWork,
    /// What became of the copy.
    Told(String),
}

impl Collected {
    fn new(asker: Asker) -> Self {
        Self {
            class: Class::new([]),
            looking: Looking::default(),
            shows: Shows::Nothing,
            asker,
            asked: None,
            sought: BTreeSet::new(),
            links: 0,
            told: String::new(),
            version: 0,
            pause: None,
        }
    }

    /// Shows the table of a lesson of which there are hand-ins, where the one that is shown has
    /// none.
    fn settle(&mut self) {
        let tables = self.class.tables();
        if let Some(first) = tables.first()
            && !tables.contains(&self.looking.lesson)
        {
            self.looking = self.looking.reduce(LookAction::Lesson(*first), &self.class);
        }
    }

    /// What the solver said.
    fn hear(&mut self, action: Action) {
        match action {
            Action::Answered { number, response } => {
                self.asked = None;
                self.class.answered(number, *response);
            }
            Action::Failed { number, sentence } => {
                self.asked = None;
                self.class.failed(number, sentence);
            }
            // An asker says nothing else.
            _ => {}
        }
    }

    fn save(&mut self) {
        let text = csv::csv(&self.class, self.looking.order);
        let blob = Blob::new_with_options(text.as_str(), Some("text/csv"));
        files::save_as("hand-ins.csv", blob);
        self.told = tr!("Saved as {name}.", name = "hand-ins.csv");
    }

    fn copy(&self, tell: Callback<ClassMsg>) {
        let text = csv::csv(&self.class, self.looking.order);
        copied(tr!("table"), &text, tr!("Table copied."), tell);
    }

    /// Copies what is given back to the student whose work is shown.
    fn copy_work(&self, tell: Callback<ClassMsg>) {
        if let Some(text) = self.looking.to_give_back(&self.class) {
            copied(
                tr!("text"),
                &text,
                tr!("Copied, to be sent to the student."),
                tell,
            );
        }
    }
}

/// Copies a text, and tells whether that went well.
fn copied(what: &'static str, text: &str, well: &'static str, tell: Callback<ClassMsg>) {
    copy::text(what, text, move |done| {
        tell.emit(ClassMsg::Told(match done {
            Ok(()) => well.to_owned(),
            Err(notice) => notice.sentence(),
        }));
    });
}
