//! What the inspector lists of a plan of elsewhere: how it was read, what it
//! breaks, what it costs.

use giveway_model::check::{Rule, Violation};
use giveway_model::compare::{ClaimedBound, ClaimedCost, claimed_bounds, claimed_loss, claims};
use giveway_model::words::{and, capital};
use giveway_model::{Plan, tr};

use super::gap::Known;
use super::{Audit, Dropped};
use crate::words::{at, title};

/// How the file was read, or what it says: a title, what is so, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// What it is about.
    pub title: String,
    /// What is so.
    pub what: String,
    /// Why, or by whom; empty where there is nothing to say.
    pub why: String,
}

/// A broken rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ViolationRow {
    /// Which of all of them it is.
    pub index: usize,
    /// What goes wrong.
    pub text: String,
    /// Where, or why; empty where there is nothing to say.
    pub detail: String,
    /// When, in steps.
    pub time: u32,
    /// Whether that is the time shown.
    pub is_now: bool,
}

/// A cost of the plan, what is proved of it, and what others say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostRow {
    /// Which cost.
    pub title: String,
    /// Of this plan.
    pub this: u32,
    /// What every plan costs at least, where that is proved.
    pub least: Option<u32>,
}

impl CostRow {
    /// The difference in words: `+1`, `0`; empty where nothing is proved.
    pub fn difference(&self) -> String {
        let Some(least) = self.least else {
            return String::new();
        };
        match i64::from(self.this) - i64::from(least) {
            0 => "0".to_owned(),
            more => format!("{more:+}").replace('-', "\u{2212}"),
        }
    }
}

/// How the file was read, with why; and what it claims, where that is not so.
pub(super) fn facts(audit: &Audit, known: &Known) -> Vec<Fact> {
    let plan = &*audit.plan;
    let file = &plan.file;
    if plan.is_own() {
        return Vec::new();
    }
    let mut facts = vec![Fact {
        title: tr!("Format").to_owned(),
        what: file.format.looks().to_owned(),
        why: tr!("as {makers}", makers = file.format.makers()),
    }];
    for (index, (about, how)) in file.words.iter().enumerate() {
        facts.push(Fact {
            title: capital(about),
            what: capital(how),
            why: if index == 0 {
                file.why.clone()
            } else {
                String::new()
            },
        });
    }
    facts.extend(claimed(plan));
    facts.extend(claimed_of_all(audit, known));
    facts
}

/// What the file says of all plans, beside what is known here.
fn claimed_of_all(audit: &Audit, known: &Known) -> Vec<Fact> {
    let plan = &*audit.plan;
    let Ok(instance) = plan.answer.draft.instance() else {
        return Vec::new();
    };
    let ours = audit.better().and_then(|ours| ours.plan());
    let plans: Vec<&Plan> = std::iter::once(&plan.file.plan).chain(ours).collect();
    // A bound of a later cost holds for some plans only.
    let first = audit.objective().costs().first();
    let mut proved = known.bounds.clone();
    let ours = audit.ours.as_ref();
    let is_for_ever = ours.is_some_and(|ours| ours.solved.reach.is_complete());
    proved.retain(|cost, _| Some(cost) == first && is_for_ever);
    let bounds = claimed_bounds(instance, &plans, plan.file.bounds, &proved);
    let sentences = bounds.iter().map(ClaimedBound::sentence);
    let loss = claimed_loss(instance, &plan.file.plan, plan.file.bounds);
    let fact = |what| Fact {
        title: tr!("It says").to_owned(),
        what,
        why: String::new(),
    };
    sentences.chain(loss).map(fact).collect()
}

/// What the file says that its plan costs, where we count otherwise.
fn claimed(plan: &Dropped) -> Vec<Fact> {
    let Ok(instance) = plan.answer.draft.instance() else {
        return Vec::new();
    };
    let file = &plan.file;
    let all = claims(instance, &file.plan, file.claimed, file.written);
    let fact = |claim: ClaimedCost| {
        let own = claim.counted.filter(|_| !claim.agrees())?;
        let why = match claim.definition {
            Some(definition) => tr!(
                "{definition} Here it is {own}.",
                definition = definition.sentence(),
                own
            ),
            None => {
                tr!(
                    "By our count it is {own}: steps until each robot stays at its goal.",
                    own
                )
            }
        };
        Some(Fact {
            title: tr!("It says").to_owned(),
            what: format!("{} {}", title(claim.cost), claim.claimed),
            why,
        })
    };
    all.into_iter().filter_map(fact).collect()
}

/// The costs of the objective, each with what is proved of it.
pub(super) fn costs(audit: &Audit, known: &Known) -> Vec<CostRow> {
    let Some(costs) = audit.plan.answer.solved.costs else {
        return Vec::new();
    };
    let own = audit.objective().costs();
    let rows = own.iter().map(|&cost| CostRow {
        title: title(cost).to_owned(),
        this: costs.get(cost),
        least: known.bounds.get(&cost).copied(),
    });
    rows.collect()
}

/// A broken rule as it stands in the list.
pub(super) fn violation(
    plan: &Dropped,
    violation: &Violation,
    index: usize,
    is_now: bool,
) -> ViolationRow {
    let (text, detail) =
        words(plan, violation).unwrap_or((violation.message.clone(), String::new()));
    ViolationRow {
        index,
        text,
        detail,
        time: violation.time,
        is_now,
    }
}

/// A collision in few words: its time stands beside it. `None` for other rules.
fn words(plan: &Dropped, violation: &Violation) -> Option<(String, String)> {
    let [one, two] = violation.agents.as_slice() else {
        return None;
    };
    match (violation.rule, violation.cell, violation.edge) {
        (Rule::Vertex, Some(cell), _) => {
            let stays = |name: &String| {
                let agents = plan.answer.draft.agents();
                let agent = agents.iter().position(|agent| agent.name == *name)?;
                let since = plan.answer.arrivals.get(agent).copied().flatten()?;
                (since < violation.time).then_some(since)
            };
            Some(match (stays(one), stays(two)) {
                (Some(since), None) => (
                    tr!("{two} enters {cell}", two, cell = at(cell)),
                    tr!("where {one} stays from time {since}", one, since),
                ),
                (None, Some(since)) => (
                    tr!("{one} enters {cell}", one, cell = at(cell)),
                    tr!("where {two} stays from time {since}", two, since),
                ),
                _ => (
                    tr!(
                        "{one} and {two} are both at {cell}",
                        one,
                        two,
                        cell = at(cell)
                    ),
                    String::new(),
                ),
            })
        }
        (Rule::Swap | Rule::SlowSwap, _, Some([from, to])) => Some((
            tr!("{one} and {two} swap cells", one, two),
            and(&[at(from), at(to)]),
        )),
        _ => None,
    }
}
