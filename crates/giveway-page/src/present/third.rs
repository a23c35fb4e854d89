//! The lower third: the question that was asked, and its answer with the verdict first.

use giveway_model::words::and;
use giveway_model::{Question, tr};
use giveway_solve::explain::{Core, ExplainAnswer, Verdict, facts_title};

use super::Presenting;
use crate::{Asking, State, ask};

/// The most sentences that are read from the last row.
const SENTENCES: usize = 2;

/// What stands in the lower third.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Third {
    /// The question.
    pub question: String,
    /// The verdict in a few words; nothing before it is known.
    pub verdict: Option<&'static str>,
    /// Two sentences of the answer at most; else what is looked for.
    pub text: String,
    /// Why there is no plan: each set of facts that rules it out.
    pub causes: Vec<Cause>,
}

/// A set of facts that rules out every plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// The numbers of its facts on the board: `3\u{2013}10`.
    pub numbers: String,
    /// Its heading, and the robots that it is about.
    pub text: String,
}

/// The question that was asked, with its answer; nothing where there is none, where the
/// board is shown alone, and in a lesson, which tells by itself.
pub fn third(state: &State) -> Option<Third> {
    if state.view.presenting != Presenting::Told || state.lesson().is_some() {
        return None;
    }
    let card = ask::card(state)?;
    let asking = state.document.mode.asking()?;
    let told = asking.told.as_deref();
    let text = match &card.verdict {
        Some(verdict) => opening(&verdict.sentence, SENTENCES),
        None => card.coming.as_ref().map_or("", |coming| &coming.doing),
    };
    Some(Third {
        verdict: told.map(verdict),
        text: text.to_owned(),
        causes: causes(asking),
        question: card.question,
    })
}

/// The causes; none where the numbers on the board are not those of facts.
fn causes(asking: &Asking) -> Vec<Cause> {
    let told = asking.told.as_deref();
    let Some(told) = told.filter(|_| ask::numbers_facts(asking)) else {
        return Vec::new();
    };
    let mut before = 0;
    let sets = told.core.iter().flat_map(Core::sets).enumerate();
    sets.map(|(set, core)| {
        let (first, last) = (before + 1, before + core.facts.len());
        before = last;
        let mut agents: Vec<&String> = Vec::new();
        for agent in core.facts.iter().flat_map(|fact| &fact.agents) {
            if !agents.contains(&agent) {
                agents.push(agent);
            }
        }
        let title = facts_title(told.verdict, core, set > 0);
        Cause {
            numbers: if first == last {
                first.to_string()
            } else {
                format!("{first}\u{2013}{last}")
            },
            text: if agents.is_empty() {
                title.to_owned()
            } else {
                format!("{title}: {}", and(&agents))
            },
        }
    })
    .collect()
}

/// The verdict as one says it, whatever was asked.
fn verdict(told: &ExplainAnswer) -> &'static str {
    if told.valid == Some(false) {
        return tr!("a verdict, spoken" => "It breaks a rule.");
    }
    match (&told.question, told.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => tr!("a verdict, spoken" => "There is none."),
        (Question::Plan, Verdict::Needless) => tr!("a verdict, spoken" => "No plan is better."),
        (_, Verdict::Needless) => tr!("a verdict, spoken" => "No: another plan avoids it."),
        (_, Verdict::Improvable) => tr!("a verdict, spoken" => "There is a better way."),
        (_, Verdict::Costly) => tr!("a verdict, spoken" => "It would cost more."),
        (_, Verdict::Necessary) => tr!("a verdict, spoken" => "It must."),
        (_, Verdict::Unknown) => tr!("a verdict, spoken" => "Not known yet."),
    }
}

/// The first sentences of a text.
fn opening(text: &str, sentences: usize) -> &str {
    let mut ends = text.match_indices(". ");
    ends.nth(sentences - 1).map_or(text, |(at, _)| &text[..=at])
}

#[cfg(test)]
mod tests {
    use super::opening;

    #[test]
    fn two_sentences_are_enough() {
        assert_eq!(opening("One.", 2), "One.");
        assert_eq!(opening("One. Two at 1.5.", 2), "One. Two at 1.5.");
        assert_eq!(opening("One. Two. Three. Four.", 2), "One. Two.");
        assert_eq!(opening("", 2), "");
    }
}
