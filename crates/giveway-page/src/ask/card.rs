//! The answer to a question, as the inspector shows it.

use giveway_model::{Cost, Question};
use giveway_solve::explain::{edits_in_words, facts_claim, facts_title, witness_title};
use giveway_solve::words::reach;

use super::signs::{badge, edit_icon, fact_icon, pending, verdict_words};
use crate::timeline::Lane;
use crate::{Answer, Asking, Lit, State, words};

/// What is said, part by part, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// The question.
    pub question: String,
    /// The verdict with all that is known in words; nothing before it is there.
    pub verdict: Option<(Badge, String)>,
    /// Costs and arrivals of both plans; none without an other plan.
    pub rows: Vec<CostRow>,
    /// Whether the other plan can be shown and taken, and whether it is shown.
    pub other: Option<Other>,
    /// What would happen, with its heading.
    pub witness: Option<(String, Vec<Happening>)>,
    /// What together makes it impossible.
    pub core: Option<Facts>,
    /// What would help.
    pub repairs: Vec<Offered>,
    /// What is still looked for, as quiet lines.
    pub pending: Vec<&'static str>,
    /// What the claim rests on, once the answer is whole.
    pub standing: Option<String>,
}

/// A verdict's word, icon and class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Badge {
    /// The word.
    pub word: &'static str,
    /// The icon's name.
    pub icon: &'static str,
    /// The class in the style sheet.
    pub class: &'static str,
}

/// The most things that go wrong that are told one by one.
const HAPPENINGS: usize = 30;

/// A cost of both plans.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostRow {
    /// Which cost, or whose arrival.
    pub title: String,
    /// The agent whose arrival it is, by its index.
    pub agent: Option<usize>,
    /// Of this plan.
    pub this: u32,
    /// Of the other plan.
    pub other: u32,
}

impl CostRow {
    /// The difference in words: `same`, `+1`.
    pub fn difference(&self) -> String {
        match i64::from(self.other) - i64::from(self.this) {
            0 => "same".to_owned(),
            more => format!("{more:+}").replace('-', "\u{2212}"),
        }
    }
}

/// The other plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Other {
    /// Whether the board shows it in the place of this one.
    pub is_shown: bool,
    /// Whether it is shown beside this one.
    pub is_beside: bool,
    /// Whether it is proved that no other is closer to this plan.
    pub is_closest: bool,
}

/// Something that would go wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Happening {
    /// Its number on the map, from 1; `None` where the facts have the numbers.
    pub number: Option<usize>,
    /// What.
    pub text: String,
    /// When.
    pub time: u32,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// The minimal set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The heading.
    pub title: &'static str,
    /// What is claimed of it.
    pub claim: &'static str,
    /// The facts.
    pub facts: Vec<FactRow>,
}

/// A fact of the minimal set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FactRow {
    /// Its number on the map, from 1; `None` where what would happen has the numbers.
    pub number: Option<usize>,
    /// The icon of its kind.
    pub icon: &'static str,
    /// What.
    pub text: String,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// A repair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offered {
    /// The icon of its first edit.
    pub icon: &'static str,
    /// What it does.
    pub text: String,
    /// What the plan would cost.
    pub costs: String,
}

/// What the card shows; nothing where nothing was asked.
pub fn card(state: &State) -> Option<Card> {
    let asking = state.document.mode.asking()?;
    let mut card = Card {
        question: words::question(asking.question()),
        verdict: None,
        rows: Vec::new(),
        other: None,
        witness: None,
        core: None,
        repairs: Vec::new(),
        pending: Vec::new(),
        standing: None,
    };
    let Some(told) = asking.told.as_deref() else {
        card.pending.push("Looking for the verdict");
        return Some(card);
    };
    card.verdict = Some((badge(told), verdict_words(state, asking, told).to_owned()));
    if let Some(other) = &asking.other {
        card.rows = rows(asking, other);
        card.other = Some(Other {
            is_shown: asking.shows_other,
            is_beside: state.view.is_wide,
            is_closest: told.closest,
        });
    }
    let happenings = asking.violations().enumerate().take(HAPPENINGS);
    let happenings = happenings.map(|(index, violation)| Happening {
        number: (!numbers_facts(asking)).then_some(index + 1),
        text: violation.message.clone(),
        time: violation.time,
        is_lit: asking.lit == Some(Lit::Witness(index)),
    });
    let happenings: Vec<Happening> = happenings.collect();
    card.witness = (!happenings.is_empty()).then(|| (witness_title(asking.question()), happenings));
    card.core = told.core.as_ref().map(|core| Facts {
        title: facts_title(told.verdict),
        claim: facts_claim(core),
        facts: core
            .facts
            .iter()
            .enumerate()
            .map(|(index, fact)| FactRow {
                number: numbers_facts(asking).then_some(index + 1),
                icon: fact_icon(fact),
                text: fact.text.clone(),
                is_lit: asking.lit == Some(Lit::Fact(index)),
            })
            .collect(),
    });
    let objective = asking.about.draft.scene().objective.clone();
    let objective = asking.request.objective.as_ref().unwrap_or(&objective);
    let repairs = told.repairs.iter();
    card.repairs = repairs
        .filter(|_| asking.can_be_repaired())
        .map(|repair| Offered {
            icon: repair.edits.first().map_or("check", edit_icon),
            // Its costs stand below it.
            text: edits_in_words(&repair.edits),
            costs: words::values(objective, &repair.costs),
        })
        .collect();
    if state.is_looking() {
        card.pending = told.pending.iter().map(|&part| pending(part)).collect();
    } else {
        card.standing = reach(told.complete, told.within);
    }
    Some(card)
}

/// Whether the answer itself offers the next step: another plan, or a repair.
pub fn offers_next_step(state: &State) -> bool {
    state.document.mode.asking().is_some_and(|asking| {
        let told = asking.told.as_deref();
        asking.other.is_some() || told.is_some_and(|told| !told.repairs.is_empty())
    })
}

/// Whether the numbers on the map are those of the facts: where there is no plan at
/// all. Else they are those of what would happen.
pub(crate) fn numbers_facts(asking: &Asking) -> bool {
    matches!(asking.question(), Question::Unsolvable)
}

/// What is claimed of the other plan: that none as good is closer to this one,
/// where that is proved.
pub fn closeness(state: &State) -> Option<&'static str> {
    let told = state.document.mode.asking()?.told.as_deref()?;
    told.closest.then_some("closest to this plan")
}

/// The costs of the objective, then the arrivals that differ.
fn rows(asking: &Asking, other: &Answer) -> Vec<CostRow> {
    let this = &asking.about;
    let (Some(before), Some(after)) = (this.solved.costs, other.solved.costs) else {
        return Vec::new();
    };
    let scene = this.draft.scene();
    let objective = asking
        .request
        .objective
        .as_ref()
        .unwrap_or(&scene.objective);
    let others = Cost::ALL
        .into_iter()
        .filter(|cost| !objective.costs().contains(cost) && before.get(*cost) != after.get(*cost));
    let costs = objective.costs().iter().copied().chain(others);
    let mut rows: Vec<CostRow> = costs
        .map(|cost| CostRow {
            title: words::title(cost).to_owned(),
            agent: None,
            this: before.get(cost),
            other: after.get(cost),
        })
        .collect();
    for (agent, who) in this.draft.agents().iter().enumerate() {
        let arrival = |answer| Lane::of(answer, agent).map(|lane| lane.arrival);
        if let (Some(before), Some(after)) = (arrival(this), arrival(other))
            && before != after
        {
            rows.push(CostRow {
                title: format!("{} arrives", who.name),
                agent: Some(agent),
                this: before,
                other: after,
            });
        }
    }
    rows
}
