//! Words and headings around an answer to a question.

use giveway_model::Question;

use crate::explain::{Core, ExplainAnswer, Verdict};

/// The verdict in a word.
pub fn verdict_word(answer: &ExplainAnswer) -> &'static str {
    if answer.valid == Some(false) {
        return "Against the rules";
    }
    match (&answer.question, answer.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => "Impossible",
        (Question::Plan, Verdict::Needless) => "Optimal",
        (_, Verdict::Needless) => "Needless",
        (_, Verdict::Improvable) => "Improvable",
        (_, Verdict::Costly) => "Costly",
        (_, Verdict::Necessary) => "Necessary",
        (_, Verdict::Unknown) => "Not known",
    }
}

/// What stands above the things that would go wrong, or that a plan breaks.
pub fn witness_title(question: &Question) -> String {
    match question {
        Question::Wait { agent, .. } => format!("If {agent} did not wait"),
        Question::Unsolvable => "At the least, this would go wrong".to_owned(),
        Question::Plan => "What is against the rules".to_owned(),
        _ => "What would go wrong if only this changed".to_owned(),
    }
}

/// What stands above the facts that together make it so.
pub const fn facts_title(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Costly => "These facts together rule out a cheaper plan",
        _ => "These facts together rule it out",
    }
}

/// Whether all of these facts are needed.
pub const fn facts_claim(core: &Core) -> &'static str {
    if core.minimal {
        "Drop any one of them and it becomes possible."
    } else {
        "Some of these may not be needed."
    }
}
