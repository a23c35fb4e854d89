//! Words and headings around an answer to a question.

use giveway_model::{Question, tr};

use crate::explain::{Core, ExplainAnswer, Verdict};

/// The verdict in a word.
pub fn verdict_word(answer: &ExplainAnswer) -> &'static str {
    if answer.valid == Some(false) {
        return tr!("a verdict" => "Against the rules");
    }
    match (&answer.question, answer.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => tr!("a verdict" => "Impossible"),
        (Question::Plan, Verdict::Needless) => tr!("a verdict" => "Optimal"),
        (_, Verdict::Needless) => tr!("a verdict" => "Needless"),
        (_, Verdict::Improvable) => tr!("a verdict" => "Improvable"),
        (_, Verdict::Costly) => tr!("a verdict" => "Costly"),
        (_, Verdict::Necessary) => tr!("a verdict" => "Necessary"),
        (_, Verdict::Unknown) => tr!("a verdict" => "Not known"),
    }
}

/// What stands above the things that would go wrong, or that a plan breaks.
pub fn witness_title(question: &Question) -> String {
    match question {
        Question::Wait { agent, .. } => tr!("If {agent} did not wait", agent),
        Question::Unsolvable => tr!("At the least, this would go wrong").to_owned(),
        Question::Plan => tr!("What is against the rules").to_owned(),
        _ => tr!("What would go wrong if only this changed").to_owned(),
    }
}

/// What stands above the facts that together make it so.
pub fn facts_title(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Costly => tr!("These facts together rule out a cheaper plan"),
        _ => tr!("These facts together rule it out"),
    }
}

/// Whether all of these facts are needed.
pub fn facts_claim(core: &Core) -> &'static str {
    if core.minimal {
        tr!("Drop any one of them and it becomes possible.")
    } else {
        tr!("Some of these may not be needed.")
    }
}
