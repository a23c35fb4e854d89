//! The answer to a question, as the inspector shows it.

mod about;
mod coming;
mod costs;
mod could;
mod groups;
mod heading;
mod late;
mod missing;
mod parts;
mod pays;
mod pieces;
mod tight;
mod title;
mod verdict;

use std::collections::BTreeSet;

use giveway_model::words::and;
use giveway_model::{Question, tr};
use giveway_solve::explain::{
    Core, ExplainAnswer, Fact, Layer, Repair, edits_in_words, facts_claim, facts_title, helps_mark,
    witness_title,
};
use giveway_solve::words::reach;

use super::signs::{edit_icon, fact_icon, gives_up};
use crate::{Asking, Lit, State, beside, words};

pub(crate) use coming::layers;
pub use coming::{Coming, Held, LayerStep, Reached};
pub use costs::CostRow;
pub use could::CouldRow;
pub(crate) use could::{instead, other_name};
pub(crate) use groups::numbers_groups;
pub use groups::{GroupMark, GroupRow};
pub use missing::Missing;
pub use parts::{Badge, Card, FactRow, Facts, Happening, Offered, Other, VerdictPart, WhoPays};
pub use pieces::Piece;
pub use tight::{Tight, TightRow};

use coming::coming;
use could::could;
use missing::missing;
use pays::pays;
use verdict::verdict;

/// The most robots that are named as those about whom a reason is.
const MOST_OTHERS: usize = 4;

/// The most things that go wrong that are told one by one.
const HAPPENINGS: usize = 30;

/// What the card shows; nothing where nothing was asked.
pub fn card(state: &State) -> Option<Card> {
    let asking = state.document.mode.asking()?;
    let mut card = Card {
        question: words::question(asking.question()),
        about: about::about(asking),
        verdict: None,
        pays: None,
        could: could(asking),
        other: None,
        differences: beside::rows(state),
        more_differences: beside::more_rows(state),
        tight: None,
        witness: Vec::new(),
        cores: Vec::new(),
        repairs: Vec::new(),
        more_repairs: None,
        missing: Vec::new(),
        holds_places: layers(asking.question()).contains(&Layer::Near),
        coming: None,
        standing: None,
    };
    let Some(told) = asking.told.as_deref() else {
        card.coming = coming(state, asking, &card);
        return Some(card);
    };
    card.verdict = verdict(state, asking, told);
    if let Some(other) = &asking.other {
        card.pays = pays(asking, other);
        card.other = Some(Other {
            which: could::which(asking, &card.could),
            is_shown: asking.shows_other,
            is_beside: state.view.is_wide,
            is_better: asking.is_bettered(),
        });
    }
    card.witness = witness(asking);
    card.cores = facts(state, asking, told);
    card.tight = tight::tight(asking, told, !card.cores.is_empty());
    let repairs = told.repairs.iter();
    card.repairs = repairs
        .filter(|_| asking.can_be_repaired())
        .map(|repair| Offered {
            icon: repair.edits.first().map_or("check", edit_icon),
            gives_up: repair.edits.iter().any(gives_up),
            // Its costs stand below it.
            text: if repair.least {
                words::unnested(&edits_in_words(&repair.edits))
            } else {
                let repair = words::unnested(&edits_in_words(&repair.edits));
                tr!("{repair}. Perhaps less would do.", repair)
            },
            costs: costs_of(repair, asking),
            difference: costs::of_repair(asking, repair),
        })
        .collect();
    card.more_repairs = (told.further_repairs > 0 && !card.repairs.is_empty()).then(|| {
        tr!("{n} more would help, too." | "{n} more would help, too." % told.further_repairs)
    });
    if !state.is_looking() {
        card.standing = reach(told.reach);
    }
    card.missing = missing(state, asking, told, &card);
    card.coming = coming(state, asking, &card);
    Some(card)
}

/// What would go wrong, or does, by the class of rules that may be broken.
fn witness(asking: &Asking) -> Vec<(String, Vec<Happening>)> {
    let violations: Vec<_> = asking.violations().enumerate().take(HAPPENINGS).collect();
    let classes = violations.chunk_by(|(_, (a, _)), (_, (b, _))| a == b);
    classes
        .map(|violations| {
            let happenings = violations.iter().map(|&(index, (_, violation))| Happening {
                number: (!numbers_facts(asking) && !numbers_groups(asking)).then_some(index + 1),
                index,
                text: violation.message.clone(),
                time: violation.time,
                is_lit: asking.lit == Some(Lit::Witness(index)),
            });
            let (_, (class, _)) = violations[0];
            (
                witness_title(asking.question(), class),
                happenings.collect(),
            )
        })
        .collect()
}

/// The sets of facts, the first one first.
fn facts(state: &State, asking: &Asking, told: &ExplainAnswer) -> Vec<Facts> {
    let mut index = 0..;
    let sets = told.core.iter().flat_map(Core::sets).enumerate();
    sets.map(|(set, core)| Facts {
        title: if set == 0 && !core.groups.is_empty() {
            tr!("Because of")
        } else {
            facts_title(told.verdict, core, set > 0)
        },
        summary: (set == 0 && !core.groups.is_empty())
            .then(|| tr!("in {n} group" | "in {n} groups" % core.groups.len() as u32)),
        claim: claim(told, core, set),
        groups: if set == 0 {
            groups::groups(asking, core)
        } else {
            Vec::new()
        },
        facts: core
            .facts
            .iter()
            .zip(index.by_ref())
            .map(|(fact, index)| FactRow {
                number: numbers_facts(asking).then_some(index + 1),
                icon: fact_icon(fact),
                text: words::unnested(&fact.text),
                time: fact.time,
                loosens: loosens(state, asking, fact),
                mark: helps_mark(&told.question, told.verdict, core, fact),
                index,
                is_lit: asking.lit == Some(Lit::Fact(index)),
            })
            .collect(),
    })
    .collect()
}

/// The claim of a set; of the first one also whom it is about, where the plan lets others pass.
fn claim(told: &ExplainAnswer, core: &Core, set: usize) -> String {
    let claim = facts_claim(&told.question, told.verdict, core);
    match about_others(told, core).filter(|_| set == 0) {
        Some(others) => format!("{claim} {others}"),
        None => claim,
    }
}

/// Whom the facts are about, where they name none of the robots that are let pass.
fn about_others(told: &ExplainAnswer, core: &Core) -> Option<String> {
    let (asked, passing) = (told.question.agent()?, late::let_pass(told));
    let named = core.facts.iter().flat_map(|fact| &fact.agents);
    let named: BTreeSet<&String> = named.filter(|name| *name != asked).collect();
    if passing.is_empty() || named.is_empty() || passing.iter().any(|name| named.contains(name)) {
        return None;
    }
    let mut others: Vec<&String> = named.into_iter().collect();
    let more = others.len().saturating_sub(MOST_OTHERS);
    others.truncate(MOST_OTHERS);
    let (passing, others) = (and(&passing), and(&others));
    Some(if more == 0 {
        tr!(
            "{asked} lets {passing} pass here; what decides lies between it and {others}.",
            asked,
            passing,
            others
        )
    } else {
        tr!(
            "{asked} lets {passing} pass here; what decides lies between it, {others} and {more} more.",
            asked,
            passing,
            others,
            more
        )
    })
}

/// What a repair leads to, in the order of the objective; when the robot arrives that is asked about comes
/// first.
fn costs_of(repair: &Repair, asking: &Asking) -> String {
    let costs = words::values(asking.objective(), &repair.costs);
    let costs = match (asking.question().arriving(), repair.arrival) {
        (Some(name), Some(arrival)) => {
            tr!("{name} arrives at {arrival}; {costs}", name, arrival, costs)
        }
        _ => costs,
    };
    if repair.proved {
        costs
    } else {
        tr!("costs that were found" => "{costs}, or less", costs)
    }
}

/// The rule that a fact is, where there is no plan and it can be loosened in the list of rules.
fn loosens(state: &State, asking: &Asking, fact: &Fact) -> Option<usize> {
    let is_asked = numbers_facts(asking) && state.can_write_rules() && asking.can_be_repaired();
    let index = fact.index.filter(|_| is_asked)? as usize;
    let rule = state.document.draft.scene().constraints.get(index)?;
    crate::rules::can_loosen(rule).then_some(index)
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

/// What is claimed of the best other plan, where no variation is looked at: that none as good is
/// closer to this one, where that is proved.
pub fn closeness(state: &State) -> Option<&'static str> {
    let asking = state.document.mode.asking()?;
    let is_proved = asking.told.as_deref()?.closest && asking.chosen.is_none();
    is_proved.then_some(tr!("closest to this plan"))
}
