//! What can happen to questions.

use giveway_model::{Cell, Question};

use crate::Lit;

/// Questions.
#[derive(Clone, Debug, PartialEq)]
pub enum AskAction {
    /// Ask a question about the plan that is shown.
    Ask(Question),
    /// Go on with the question whose answer was cut off: what is known stands meanwhile.
    Again,
    /// Leave the question.
    Close,
    /// Show the other plan, or this one again.
    ShowOther(bool),
    /// Light something of the answer up on the map.
    Light(Option<Lit>),
    /// Light a cell up that a sentence names, and bring it into view; or no longer.
    GoTo(Cell),
    /// Open a group of facts and light it up, or close it.
    Group(usize),
    /// Look at a variation as the other plan, by its place; `None`: at the best that is known.
    Choose(Option<usize>),
    /// Give each robot that differs a row.
    Unfold,
    /// Make the other plan the plan.
    TakeOther,
    /// Make the better plan that a question found the plan, after the question was left.
    TakeFound,
    /// Make the edits of a repair, by its index.
    TakeRepair(usize),
}
