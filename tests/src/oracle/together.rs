//! What a question asks of several agents together.

use giveway_model::{Cell, Cost, Question};

use super::contrast::Contrast;

/// What a question asks of all agents, or between two of them.
pub(super) enum Together<'a> {
    /// Less of a cost.
    Less(Cost),
    /// The first agent is at the cell before the second.
    Before(&'a str, &'a str, Cell),
}

impl<'a> Contrast<'a> {
    /// What the question asks of several agents; `None` where it is about one, or any one.
    pub(super) fn together(&self) -> Option<Together<'a>> {
        match self.question {
            Question::Makespan => Some(Together::Less(Cost::Makespan)),
            Question::SumOfCosts => Some(Together::Less(Cost::SumOfCosts)),
            Question::Charges { agent: None } => Some(Together::Less(Cost::Charges)),
            Question::Moves { agent: None } => Some(Together::Less(Cost::Moves)),
            Question::Waits { agent: None } => Some(Together::Less(Cost::Waits)),
            Question::Yield { agent, to, at } => Some(Together::Before(agent, to, *at)),
            Question::Wait { .. }
            | Question::Charge { .. }
            | Question::NoCharge { .. }
            | Question::Visit { .. }
            | Question::NoVisit { .. }
            | Question::Move { .. }
            | Question::NoMove { .. }
            | Question::Slow { .. }
            | Question::Order { .. }
            | Question::Arrival { .. }
            | Question::Length { .. }
            | Question::Charges { agent: Some(_) }
            | Question::Moves { agent: Some(_) }
            | Question::Waits { agent: Some(_) }
            | Question::Penalty
            | Question::Rule { .. }
            | Question::Unsolvable
            | Question::Plan => None,
        }
    }
}
