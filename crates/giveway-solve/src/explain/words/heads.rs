//! Words and headings around an answer to a question.

use giveway_model::words::capital;
use giveway_model::{Question, tr};

use crate::explain::{Core, ExplainAnswer, Fact, Verdict};

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
        tr!("These facts alone rule it out, and each of them is needed for that.")
    } else {
        tr!("Some of these may not be needed.")
    }
}

/// A fact as a sentence, with a remark where leaving only this one out of the whole
/// scene helps. Where that is so of all facts of its set, [`facts_remark`] says it.
pub fn fact_sentence(fact: &Fact, core: &Core, verdict: Verdict) -> String {
    let text = capital(&fact.text);
    if fact.helps != Some(true) || helps_all(core, Some(true)) {
        return text + ".";
    }
    match verdict {
        Verdict::Costly => tr!("{text}. Without this one there is a cheaper plan.", text),
        _ => tr!("{text}. Without this one there is a plan.", text),
    }
}

/// What is known of leaving out single facts of the whole scene, beside the remarks of
/// [`fact_sentence`].
pub fn facts_remark(core: &Core, verdict: Verdict) -> Option<&'static str> {
    if core.facts.is_empty() || helps_all(core, None) {
        None
    } else if helps_all(core, Some(true)) {
        Some(match verdict {
            Verdict::Costly => tr!("Without any single one of them there is a cheaper plan."),
            _ => tr!("Without any single one of them there is a plan."),
        })
    } else if helps_all(core, Some(false)) {
        Some(tr!(
            "Leaving out only one of them does not help: other facts rule it out, too."
        ))
    } else if core.facts.iter().any(|fact| fact.helps.is_none()) {
        Some(tr!(
            "For some of them it is not known whether leaving out only that one would help."
        ))
    } else {
        None
    }
}

fn helps_all(core: &Core, helps: Option<bool>) -> bool {
    core.facts.iter().all(|fact| fact.helps == helps)
}

/// What stands above a further set of facts.
pub fn further_facts_title() -> &'static str {
    tr!("These facts rule it out as well")
}
