//! What can happen in a lesson, and what must be done outside of it then.

use std::rc::Rc;

use giveway_solve::change::Method;
use giveway_solve::{Request, Response};

use super::{AskNumber, Progress};
use crate::lesson::{Id, Lesson, Value};
use crate::port::{FromPage, Lit, ToPage};

/// Something that happens.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// A lesson is opened, at a step from 0, or where it was left.
    Open {
        /// Its short name.
        id: Id,
        /// The lesson.
        lesson: Rc<Lesson>,
        /// The step.
        at: Option<usize>,
    },
    /// A lesson that is open goes on in the words of another language.
    Reword {
        /// Its short name.
        id: Id,
        /// The same lesson in those words.
        lesson: Rc<Lesson>,
    },
    /// A lesson that is being written is tried, at a step from 0: it leaves no traces.
    Try {
        /// The lesson.
        lesson: Rc<Lesson>,
        /// The step.
        at: usize,
    },
    /// To the next step; after the last one the lesson was read to its end.
    Next,
    /// To the step before.
    Back,
    /// To a step, from 0.
    Go(usize),
    /// The page says something.
    Page(FromPage),
    /// A value is said.
    Guess(Value),
    /// No value is said: the answer is wanted.
    Reveal,
    /// An answer is picked, by its index.
    Choose(usize),
    /// The robots are put in an order, by their names.
    Order(Vec<String>),
    /// It is said that no order works.
    NoOrder,
    /// A method is picked.
    Went(Method),
    /// This robot, by its name, is led from now on.
    Lead(String),
    /// The robot that is led waits for a step.
    Wait,
    /// The proof of the plan is to be checked.
    CheckProof,
    /// A byte of the proof is changed, or is again what it was.
    ChangeByte,
    /// The next hint.
    Hint,
    /// What shows the verdict is to be seen.
    ShowEvidence,
    /// The last thing that was done is taken back.
    TakeBack,
    /// The step begins anew.
    Afresh,
    /// The solver has answered.
    Answered {
        /// Which question.
        number: AskNumber,
        /// The answer.
        response: Box<Response>,
    },
    /// The solver has broken down.
    Failed {
        /// At which question.
        number: AskNumber,
        /// What happened, as a sentence.
        sentence: String,
    },
    /// A link to a robot or a cell is pointed at, or no longer.
    Light(Option<Lit>),
    /// A link to a time is followed.
    Time(u32),
    /// Progress was read that had been kept, perhaps by another tab: it comes to what
    /// there is.
    Kept(Progress),
    /// All progress is forgotten.
    Reset,
    /// The lesson is left.
    Close,
}

/// Something that must be done outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Asks the solver; whatever it is at is of no more use.
    Ask {
        /// The number that the answer must carry.
        number: AskNumber,
        /// The question.
        request: Box<Request>,
    },
    /// What the solver is at is of no more use.
    Forget,
    /// Tells the page something.
    Page(ToPage),
    /// Keeps the progress.
    Keep(Progress),
    /// Brings the focus to the button that goes on.
    FocusNext,
}
