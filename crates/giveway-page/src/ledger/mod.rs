//! Who costs whom: the ledger of delays of the plan on the board, as a table and as a heat map.

mod column;
mod heat;
mod signs;
mod verdict;

use std::rc::Rc;

use giveway_model::{Cost, Question, tr};
use giveway_solve::delays::{DelaysAnswer, DelaysRequest};
use giveway_solve::{Limits, SolveAnswer, Status};

use crate::{Activity, Answer, Document, Selection, State, Task};

pub use column::{Because, CauseRow, Column, LossRow, PlaceRow, TITLE, column};
pub use heat::{Frame, Heat, Shade, heat};
pub use signs::{legend, notes};

/// What a person does with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LedgerAction {
    /// Opens it, or leaves it.
    Show(bool),
    /// Turns the table round: who costs others.
    Turn(bool),
    /// Lights a robot or a place up, or nothing.
    Light(Option<LedgerLit>),
    /// Adds up what is not known, without showing it: a report tells it.
    AddUp,
}

/// What is lit up: only its cells stay on the heat map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LedgerLit {
    /// A robot that loses steps, by its index.
    Robot(usize),
    /// A place, by its rank from 0.
    Place(usize),
}

/// The delays of a plan, as far as they are known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ledger {
    /// The plan that it is about.
    pub(crate) about: Rc<Answer>,
    /// What the solver was asked.
    pub(crate) request: Rc<DelaysRequest>,
    /// What is known.
    pub(crate) told: Option<Rc<DelaysAnswer>>,
    /// Whether it was asked for a report, in little time and without a proof of its own.
    pub(crate) is_of_report: bool,
}

/// The most seconds that a report is kept waiting.
const MOST_SECONDS: u8 = 5;

/// How the ledger is shown. It is shown where it is of the plan on the board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LedgerView {
    pub(crate) is_open: bool,
    pub(crate) is_turned: bool,
    pub(crate) lit: Option<LedgerLit>,
}

impl Ledger {
    /// A request about a plan; `None` without one. The search for a proof is left out where
    /// the plan is proved to be a best one: that proof says all.
    pub(crate) fn about(answer: &Rc<Answer>, limits: Limits) -> Option<Self> {
        let request = Rc::new(DelaysRequest {
            scene: answer.draft.scene().clone(),
            plan: Some(answer.plan()?.clone()),
            changes: answer.course.as_ref().map(|course| course.changes.clone()),
            at: None,
            objective: answer.request.objective.clone(),
            within: answer.request.within,
            ledger_only: is_proved(answer),
            limits,
        });
        Some(Self {
            about: Rc::clone(answer),
            request,
            told: None,
            is_of_report: false,
        })
    }

    /// A request for a report.
    pub(crate) fn of_report(answer: &Rc<Answer>) -> Option<Self> {
        let limits = Limits {
            seconds: Some(f64::from(MOST_SECONDS)),
            ..Limits::default()
        };
        let mut begun = Self::about(answer, limits)?;
        Rc::make_mut(&mut begun.request).ledger_only = true;
        begun.is_of_report = true;
        Some(begun)
    }

    /// Whether there is nothing more to be asked.
    pub(crate) fn is_whole(&self) -> bool {
        let told = self.told.as_deref();
        told.is_some_and(|told| {
            !self.is_of_report || (is_proved(&self.about) && told.reason.is_none())
        })
    }

    /// The answer with a greater bound of the sum of costs, where the ledger proves more of it than
    /// the search for the plan did.
    pub(crate) fn raised(&self, told: &DelaysAnswer) -> Option<SolveAnswer> {
        let mut solved = Some(&self.about)
            .filter(|it| it.is_searched())?
            .solved
            .clone();
        let bound = told.raised_bound(&solved)?;
        solved.bounds.insert(Cost::SumOfCosts, bound);
        Some(solved)
    }

    /// Takes in what became known. The bounds of the plan prove a part of it, or all.
    pub(crate) fn learn(&mut self, mut told: DelaysAnswer) {
        let own = told.proof.take();
        let is_pending = told.pending;
        if self.about.is_searched() {
            told.prove_by(&self.about.solved);
        }
        let least = |proof: &Option<giveway_solve::delays::DelayProof>| {
            proof.as_ref().map(|proof| proof.at_least)
        };
        if least(&own) >= least(&told.proof) {
            told.proof = own;
        }
        told.pending = is_pending;
        self.told = Some(Rc::new(told));
    }
}

/// Whether a search proved that no plan is better, in a world that does not change.
fn is_proved(answer: &Answer) -> bool {
    answer.solved.status == Status::Optimal && answer.course.is_none()
}

impl Document {
    /// The ledger, where it is of the plan that there is.
    pub(crate) fn ledger(&self) -> Option<&Rc<Ledger>> {
        let found = self.found_ledger.as_ref()?;
        let is_of = Rc::ptr_eq(&found.about, self.fresh_answer()?);
        is_of.then_some(found)
    }
}

impl State {
    /// The ledger, where it is open and the board has nothing else to show: whoever selects a
    /// robot or a cell looks at that.
    pub(crate) fn ledger(&self) -> Option<&Rc<Ledger>> {
        let is_elsewhere = self.view.selection != Selection::Nothing;
        let is_hidden = is_elsewhere || self.is_inside() || self.hides_answers();
        let is_open = self.view.ledger.is_open && self.document.mode.is_editing() && !is_hidden;
        if is_open {
            self.document.ledger()
        } else {
            None
        }
    }

    /// Whether the delays are being looked for.
    pub(crate) fn is_adding_up(&self) -> bool {
        matches!(self.work.task(), Some(Task::Delays(_)))
    }

    /// Whether the board shows where steps are lost, in the place of robots and their ways.
    pub fn shows_losses(&self) -> bool {
        let told = self.ledger().and_then(|ledger| ledger.told.as_deref());
        told.is_some_and(|told| told.reason.is_none())
    }
}

/// Whether the question can be asked of the plan on the board, and is worth it.
pub fn is_offered(state: &State) -> bool {
    let document = &state.document;
    let answer = document.fresh_answer();
    let has_plan = answer.is_some_and(|answer| answer.plan().is_some());
    let is_idle = document.mode.activity == Activity::Editing && document.mode.asking().is_none();
    let is_of_the_plan = !matches!(state.view.selection, Selection::Cell(_));
    let is_own = state.lesson().is_none();
    has_plan && is_idle && is_of_the_plan && is_own && document.agents().len() > 1
}

/// What is being done, for the status.
pub(crate) fn doing(state: &State) -> &'static str {
    let ledger = state.document.ledger();
    if ledger.is_some_and(|ledger| ledger.told.is_some()) {
        tr!("Looking for a proof of what is lost.")
    } else {
        tr!("Adding up who costs whom.")
    }
}

/// The question about the largest loss.
pub(crate) fn largest(told: &DelaysAnswer) -> Option<Question> {
    let first = told.agents.first().filter(|row| row.delay > 0)?;
    Some(asked_of(first.agent.clone()))
}

/// The question about the loss of a robot.
const fn asked_of(agent: String) -> Question {
    Question::Arrival { agent }
}
