//! The questions that fit what is selected at the time shown.
//!
//! Only what is so is offered: every question here can be asked of the plan
//! that is shown ([`giveway_model::question::fits`]).

mod agent;
mod asked;
mod card;
mod cell;
mod later;
mod plan;
mod signs;

pub(crate) use asked::{is_answered, remember};
pub(crate) use signs::other_causes;

pub use card::{
    Badge, Card, Coming, CostRow, CouldRow, FactRow, Facts, GroupMark, GroupRow, Happening, Held,
    LayerStep, Missing, Offered, Other, Piece, Reached, Tight, TightRow, VerdictPart, WhoPays,
    card, closeness, offers_next_step,
};
pub(crate) use card::{instead, layers, numbers_facts, numbers_groups, other_name};
use giveway_model::{Cost, Question, question::fits, tr};

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
    pub(crate) fn new(icon: &'static str, question: Question) -> Self {
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
    /// What they are about.
    pub about: About,
}

/// What questions are about, in the order in which they stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// What the selected robot does at the time shown.
    Moment,
    /// The robot or cell that is selected.
    Selected,
    /// The plan as a whole.
    Plan,
}

/// Why nothing is offered, where a person would look for questions.
pub fn no_offers(state: &State) -> Option<String> {
    let answer = state.document.fresh_answer()?;
    let changed = answer.changed_last()?;
    let is_past = state.view.playback.time < changed;
    let is_asked = state.document.mode.changing().is_none();
    (is_past && is_asked).then(|| {
        tr!(
            "What came before time {changed} is settled. Show a later time to ask about the plan.",
            changed
        )
    })
}

/// The questions to offer, by heading. None while the plan is not that of the
/// scene as it stands.
pub fn offers(state: &State) -> Vec<Group> {
    let document = &state.document;
    let Some(answer) = document.fresh_answer() else {
        return Vec::new();
    };
    // Questions are about the plan itself, not about the late one on the board.
    if state.late_plan().is_some()
        || document.mode.changing().is_some()
        || document.mode.steering().is_some()
    {
        return Vec::new();
    }
    if answer.plan().is_none() {
        return plan::without(answer);
    }
    let time = state.view.playback.time;
    if answer.changed_last().is_some_and(|changed| time < changed) {
        return Vec::new();
    }
    let groups = match state.view.selection {
        Selection::Agent(index) => {
            let mut groups = agent::groups(answer, index, time);
            groups.extend(plan::groups(answer));
            groups
        }
        Selection::Cell(cell) => {
            let asker = state
                .view
                .asker
                .and_then(|agent| answer.agent(state.world(), agent));
            cell::groups(answer, cell, asker)
        }
        Selection::Nothing => plan::groups(answer),
    };
    match answer.changed_last() {
        None => keep_fitting(answer, groups),
        Some(changed) => keep(groups, |question| later::is_later(question, changed)),
    }
}

/// The question why a cost of the plan is not less, where it can be asked.
pub fn of_cost(state: &State, cost: Cost) -> Option<Offer> {
    let (_, question) = plan::of_cost(cost);
    let offers = offers(state).into_iter().flat_map(|group| group.offers);
    let mut same = offers.filter(|offer| offer.question == question);
    same.next()
}

/// Leaves out what is not so.
fn keep_fitting(answer: &Answer, groups: Vec<Group>) -> Vec<Group> {
    let (Ok(instance), Some(plan)) = (answer.draft.instance(), answer.plan()) else {
        return Vec::new();
    };
    keep(groups, |question| fits(question, instance, plan).is_ok())
}

/// Leaves out all other questions, and headings with nothing below them.
fn keep(mut groups: Vec<Group>, is_kept: impl Fn(&Question) -> bool) -> Vec<Group> {
    for group in &mut groups {
        group.offers.retain(|offer| is_kept(&offer.question));
    }
    groups.retain(|group| !group.offers.is_empty());
    groups
}

#[cfg(test)]
mod tests;
