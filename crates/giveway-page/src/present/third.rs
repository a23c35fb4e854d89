//! The lower third: the question that was asked, and its answer with the verdict first.

use giveway_model::{Question, tr};
use giveway_solve::explain::{ExplainAnswer, Verdict};

use super::Presenting;
use crate::{State, ask};

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
}

/// The question that was asked, with its answer; nothing where there is none, where the
/// board is shown alone, and in a lesson, which tells by itself.
pub fn third(state: &State) -> Option<Third> {
    if state.view.presenting != Presenting::Told || state.lesson().is_some() {
        return None;
    }
    let card = ask::card(state)?;
    let told = state.document.mode.asking()?.told.as_deref();
    let text = match &card.verdict {
        Some((_, words)) => opening(words, SENTENCES),
        None => card.pending.first().copied().unwrap_or_default(),
    };
    Some(Third {
        verdict: told.map(verdict),
        text: text.to_owned(),
        question: card.question,
    })
}

/// The verdict as one says it, whatever was asked.
fn verdict(told: &ExplainAnswer) -> &'static str {
    if told.valid == Some(false) {
        return tr!("a verdict, spoken" => "It breaks a rule.");
    }
    match (&told.question, told.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => tr!("a verdict, spoken" => "There is none."),
        (Question::Plan, Verdict::Needless) => tr!("a verdict, spoken" => "No plan is better."),
        (_, Verdict::Needless) => tr!("a verdict, spoken" => "It need not."),
        (_, Verdict::Improvable) => tr!("a verdict, spoken" => "There is a better way."),
        (_, Verdict::Costly) => tr!("a verdict, spoken" => "It would cost more."),
        (_, Verdict::Necessary) => tr!("a verdict, spoken" => "It must."),
        (_, Verdict::Unknown) => tr!("a verdict, spoken" => "Nobody knows yet."),
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
