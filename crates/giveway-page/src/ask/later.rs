//! Which questions are about what comes after the world has changed.

use giveway_model::Question;

/// Whether a question that fits a plan is about what it does from a time on: what
/// came before is settled, and nobody is asked why.
pub(super) fn is_later(question: &Question, since: u32) -> bool {
    let later = |time: &Option<u32>| time.is_some_and(|time| time >= since);
    match question {
        Question::Wait { from, .. } => later(from),
        Question::Charge { time, .. }
        | Question::Visit { time, .. }
        | Question::Move { time, .. } => later(time),
        // They are about all of a plan, or name no time.
        Question::Order { .. } | Question::Slow { .. } | Question::Yield { .. } => false,
        Question::NoCharge { .. }
        | Question::NoVisit { .. }
        | Question::NoMove { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => true,
    }
}
