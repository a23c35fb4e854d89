//! The questions that fit what is selected at the time shown.
//!
//! Only what is so is offered: every question here can be asked of the plan
//! that is shown ([`giveway_model::question::fits`]).

mod agent;
mod card;
mod cell;
mod plan;

pub(crate) use card::numbers_facts;
pub use card::{
    Badge, Card, CostRow, FactRow, Facts, Happening, Offered, Other, card, closeness,
    offers_next_step,
};
use giveway_model::{Question, question::fits};

use crate::{Answer, Selection, State, words};

/// A question to choose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offer {
    /// The question.
    pub question: Question,
    /// The name of its icon.
    pub icon: &'static str,
    /// The question as a sentence.
    pub text: String,
    /// What else there is to know, in a few words.
    pub detail: Option<String>,
}

impl Offer {
    fn new(icon: &'static str, question: Question) -> Self {
        let text = words::question(&question);
        Self {
            question,
            icon,
            text,
            detail: None,
        }
    }

    fn with(mut self, detail: impl Into<String>) -> Self {
        self.detail = Some(detail.into());
        self
    }
}

/// Questions under one heading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The heading.
    pub title: String,
    /// The questions, the likeliest first; never none.
    pub offers: Vec<Offer>,
}

/// Why nothing can be asked of a plan that went on where the world changed.
pub const NO_QUESTIONS: &str = "Questions are answered of a plan in one world: of one that went \
     on where the world changed they are not answered yet.";

/// Why nothing is offered, where a person would look for questions.
pub fn no_offers(state: &State) -> Option<&'static str> {
    let is_course = state
        .document
        .fresh_answer()
        .is_some_and(|a| a.course.is_some());
    (is_course && state.document.mode.changing().is_none()).then_some(NO_QUESTIONS)
}

/// The questions to offer, by heading. None while the plan is not that of the
/// scene as it stands.
pub fn offers(state: &State) -> Vec<Group> {
    let Some(answer) = state.document.answer.as_deref() else {
        return Vec::new();
    };
    let is_busy =
        state.document.mode.changing().is_some() || state.document.mode.steering().is_some();
    if state.document.is_stale() || is_busy || answer.course.is_some() {
        return Vec::new();
    }
    if answer.plan().is_none() {
        return plan::without(answer);
    }
    let groups = match state.view.selection {
        Selection::Agent(index) => {
            let mut groups = agent::groups(answer, index, state.view.playback.time);
            groups.extend(plan::groups(answer));
            groups
        }
        Selection::Cell(cell) => cell::groups(answer, cell),
        Selection::Nothing => plan::groups(answer),
    };
    keep_fitting(answer, groups)
}

/// Leaves out what is not so, and headings with nothing below them.
fn keep_fitting(answer: &Answer, mut groups: Vec<Group>) -> Vec<Group> {
    let (Ok(instance), Some(plan)) = (answer.draft.instance(), answer.plan()) else {
        return Vec::new();
    };
    for group in &mut groups {
        let fitting = |offer: &Offer| fits(&offer.question, instance, plan).is_ok();
        group.offers.retain(fitting);
    }
    groups.retain(|group| !group.offers.is_empty());
    groups
}

#[cfg(test)]
mod tests;
