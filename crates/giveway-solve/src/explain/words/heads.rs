//! Words and headings around an answer to a question.

use giveway_model::{Question, tr};

use crate::explain::{Core, ExplainAnswer, Fact, Helps, Verdict};

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

/// What stands above a further set of such facts.
pub fn further_title(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Costly => tr!("These facts alone rule out a cheaper plan, too"),
        _ => tr!("These facts alone rule it out, too"),
    }
}

/// What is claimed of a set: that it suffices, whether each of its facts is needed
/// for that, and which of them help when they alone are left out.
pub fn facts_claim(question: &Question, verdict: Verdict, core: &Core) -> String {
    let set = match (core.minimal, verdict) {
        (false, _) => tr!("Some of these may not be needed."),
        (true, Verdict::Costly) => {
            tr!("These facts alone rule out a cheaper plan, and each of them is needed for that.")
        }
        (true, _) => tr!("These facts alone rule it out, and each of them is needed for that."),
    };
    let alone = alone(question, verdict, core).map(|sentence| format!(" {sentence}"));
    format!("{set}{}", alone.unwrap_or_default())
}

/// What leaving out one fact of a set alone does, as a sentence about all of them.
fn alone(question: &Question, verdict: Verdict, core: &Core) -> Option<&'static str> {
    let count = |helps| core.facts.iter().filter(|fact| fact.helps == helps).count();
    match [Helps::Yes, Helps::No, Helps::Unknown].map(count) {
        [0, 0, 0] => None,
        [_, 0, 0] => Some(match (question, verdict) {
            (_, Verdict::Costly) => tr!("Without any one of them there is a cheaper plan."),
            (Question::Unsolvable, _) => tr!("Without any one of them there is a plan."),
            _ => tr!("Without any one of them there is such a plan."),
        }),
        [_, _, 0] => no_help(core),
        [0, ..] => Some(tr!(
            "It is not known for all of them whether leaving out only that one helps."
        )),
        _ => Some(tr!(
            "It is not known for all of the others whether leaving out only that one helps."
        )),
    }
}

/// That leaving out one fact of a set, or one of those without a mark, does not help:
/// where that is so.
pub(super) fn no_help(core: &Core) -> Option<&'static str> {
    let has = |helps| core.facts.iter().any(|fact| fact.helps == helps);
    let sentence = if has(Helps::Yes) {
        tr!("Leaving out only one of the others does not help.")
    } else {
        tr!("Leaving out only one of them does not help.")
    };
    (has(Helps::No) && !has(Helps::Unknown)).then_some(sentence)
}

/// What stands behind facts that help when they alone are left out.
pub(super) struct Marks {
    /// Behind one fact.
    pub(super) one: &'static str,
    /// Behind several of a kind.
    pub(super) any_of_these: &'static str,
}

pub(super) fn marks(question: &Question, verdict: Verdict) -> Marks {
    let (one, any_of_these) = match (question, verdict) {
        (_, Verdict::Costly) => (
            tr!("without it there is a cheaper plan"),
            tr!("without any one of these there is a cheaper plan"),
        ),
        (Question::Unsolvable, _) => (
            tr!("without it there is a plan"),
            tr!("without any one of these there is a plan"),
        ),
        _ => (
            tr!("without it there is such a plan"),
            tr!("without any one of these there is such a plan"),
        ),
    };
    Marks { one, any_of_these }
}

/// What stands behind a fact that helps when it alone is left out; nothing where that
/// is so of all facts of its set, since its claim says so.
pub fn helps_mark(
    question: &Question,
    verdict: Verdict,
    core: &Core,
    fact: &Fact,
) -> Option<&'static str> {
    let helps = |fact: &Fact| fact.helps == Helps::Yes;
    (helps(fact) && !core.facts.iter().all(helps)).then(|| marks(question, verdict).one)
}
