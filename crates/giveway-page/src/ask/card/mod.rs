//! The answer to a question, as the inspector shows it.

mod costs;
mod parts;

use giveway_model::Question;
use giveway_solve::explain::edits_in_words;

use super::signs::{badge, edit_icon, fact_icon, pending, verdict_words, would};
use crate::{Asking, Lit, State, words};

pub use costs::CostRow;
pub use parts::{Badge, Card, FactRow, Facts, Happening, Offered, Other};

use costs::rows;

/// Of a plan that breaks a rule nothing else is asked.
const BROKEN: Badge = Badge {
    word: "Against the rules",
    icon: "collision",
    class: "necessary",
};

/// The most things that go wrong that are told one by one.
const HAPPENINGS: usize = 30;

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
    let badge = match told.valid {
        Some(false) => BROKEN,
        _ => badge(asking, told.verdict),
    };
    card.verdict = Some((badge, verdict_words(state, asking, told).to_owned()));
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
    card.witness = (!happenings.is_empty()).then(|| (would(asking), happenings));
    card.core = told.core.as_ref().map(|core| Facts {
        title: "These facts together rule it out",
        claim: if core.minimal {
            "Drop any one of them and it becomes possible."
        } else {
            "Some of these may not be needed."
        },
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
    } else if told.complete {
        card.standing = Some("This holds no matter how many steps you allow.".to_owned());
    } else if let Some(within) = told.within {
        card.standing = Some(format!("This holds up to makespan {within}."));
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
