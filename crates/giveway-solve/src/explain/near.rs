//! The layer `near`: small variations of the plan that are as asked for, each passed by the
//! judge, so that the cheapest bounds what the best other plan costs.
//!
//! `slides` moves the wait along the way; `walks` gives the agent another walk, all others as
//! they are or, on a large floor, only later (`retimed`), or lets it go first, and repairs and
//! improves what collides then.

mod retimed;
mod slides;
mod walks;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Condition, Costs, Plan, sorting::sort_by_key};

use super::{
    fitting::FittingQuestion,
    how::{AgentDifference, differences, way},
    layers::{Near, Variation, VariationKind},
    words,
};
use crate::{Limits, budget::Budget};

/// Units of work of the whole layer.
const WORK: u64 = 1_000_000;
/// Alternatives of a contrast that are looked at.
const MOST_WAYS: usize = 3;
/// Variations that are told; beyond them the first of each other kind.
const MOST_TOLD: usize = 24;

/// Called each time more is known, with the cheapest plan where it became cheaper.
pub(crate) type TellNear<'a> = &'a mut dyn FnMut(Near, Option<(Plan, Costs)>);

/// Looks for variations, and tells of them as they are found: at the end at least once.
pub(crate) fn near(case: &FittingQuestion, budget: &Rc<Budget>, tell: TellNear) {
    let limits = Limits {
        work: Some(WORK),
        ..Limits::default()
    };
    let part = Rc::new(budget.part(limits));
    let mut found = Variations {
        case,
        before: case.whole.costs(case.costs, case.plan),
        plans: Vec::new(),
        told: 0,
        best: None,
    };
    for condition in case.conditions().take(MOST_WAYS) {
        slides::slide(&mut found, condition);
        found.tell(tell);
        // (Where the budget is spent, what was found stands.)
        let _ = walks::vary(&mut found, condition, &part, tell);
    }
    budget.absorb(&part);
    found.told = 0;
    found.tell(tell);
}

/// A plan that is offered as a variation.
struct Offer<'a> {
    kind: VariationKind,
    /// The agent that is to go first, or is asked about.
    agent: &'a str,
    /// Of a swap: who waits.
    other: Option<&'a str>,
    plan: Plan,
}

/// The variations that were found.
struct Variations<'a> {
    case: &'a FittingQuestion<'a>,
    /// The costs of the whole plan that is asked about.
    before: Costs,
    /// The cheapest first, with their costs in the order of the objective.
    plans: Vec<(Vec<u32>, Variation)>,
    /// How many were told.
    told: usize,
    /// The cheapest, in the times of the instance.
    best: Option<(Plan, Costs)>,
}

impl Variations<'_> {
    /// Takes a plan where the judge passes it and it is as asked for; its costs.
    fn offer(&mut self, condition: &Condition, offer: Offer) -> Option<Costs> {
        let case = self.case;
        let own = case.accepts(&offer.plan)?;
        if condition.holds(case.instance, &offer.plan) != Some(true) {
            return None;
        }
        let vector = own.vector(case.objective());
        self.take(own, offer, vector)
    }

    /// Takes a plan that was judged, where it is a new one worth telling.
    fn take(&mut self, own: Costs, offer: Offer, vector: Vec<u32>) -> Option<Costs> {
        let case = self.case;
        let pays = differences(case.instance, (case.plan, &offer.plan), case.whole);
        let mut plan = case.whole.plan(&offer.plan);
        let differs = |name: &String| pays.iter().any(|it| it.agent == *name);
        plan.paths.retain(|name, _| differs(name));
        plan.charges.retain(|name, _| differs(name));
        plan.until.retain(|name, _| differs(name));
        plan.slept.retain(|name, _| differs(name));
        if pays.is_empty() || self.plans.iter().any(|(_, known)| known.plan == plan) {
            return None;
        }
        let waits = |it: &AgentDifference| it.other > it.arrival || it.more_waits > 0;
        let is_other = |it: &&AgentDifference| Some(it.agent.as_str()) == offer.other;
        let gives_way = pays.iter().find(is_other).is_some_and(waits);
        let wait = slides::first_other_wait(case, offer.agent, &offer.plan);
        let only_times = way(case.plan, offer.agent) == way(&offer.plan, offer.agent);
        let kind = match offer.kind {
            VariationKind::OtherWay if only_times && wait.is_some() => VariationKind::Elsewhere,
            VariationKind::Swapped if !gives_way => VariationKind::Others,
            kind @ (VariationKind::Elsewhere
            | VariationKind::OtherWay
            | VariationKind::Swapped
            | VariationKind::Others) => kind,
        };
        let wait = wait.filter(|_| kind == VariationKind::Elsewhere);
        // Many robots that move differently are told only where that is cheaper.
        let is_known = |(least, _): &(Vec<u32>, Variation)| *least <= vector;
        if kind == VariationKind::Others && self.plans.first().is_some_and(is_known) {
            return None;
        }
        let mut variation = Variation {
            kind,
            other: offer.other.map(str::to_owned),
            cell: wait.map(|(cell, _)| cell),
            from: wait.map(|(_, from)| case.whole.time(from)),
            costs: case.whole.costs(own, &offer.plan),
            deltas: std::collections::BTreeMap::new(),
            pays,
            plan,
            text: String::new(),
        };
        let (after, before) = (variation.costs, self.before);
        let more = |cost| i64::from(after.get(cost)) - i64::from(before.get(cost));
        let objective = case.objective().costs().iter();
        variation.deltas = objective.map(|&cost| (cost, more(cost))).collect();
        variation.text = words::variation(case, offer.agent, &variation, &before);
        let is_better = |(_, best): &(Plan, Costs)| vector < best.vector(case.objective());
        if self.best.as_ref().is_none_or(is_better) {
            self.best = Some((offer.plan, own));
        }
        self.plans.push((vector, variation));
        sort_by_key(&mut self.plans, |(vector, it)| {
            (vector.clone(), it.kind, it.pays.len())
        });
        Some(own)
    }

    /// Tells what was found, where there is more than was told before.
    fn tell(&mut self, tell: TellNear) {
        let size = self.plans.len() + 1;
        if self.told == size {
            return;
        }
        self.told = size;
        let mut cells = BTreeSet::new();
        let each = self.plans.iter().map(|(_, variation)| variation);
        // Of the times at a place the first is told.
        let is_first = |it: &&Variation| it.cell.is_none_or(|cell| cells.insert(cell));
        // Places that cost the same must not crowd out the other kinds.
        let mut kinds = BTreeSet::new();
        let mut places = 0;
        let is_told = |it: &&Variation| {
            places += 1;
            kinds.insert((it.kind, it.other.clone())) || places <= MOST_TOLD
        };
        let mut near = Near {
            variations: each.filter(is_first).filter(is_told).cloned().collect(),
            at_most: self.plans.first().map(|(_, cheapest)| cheapest.costs),
            words: String::new(),
        };
        near.words = words::near_sentence(&near);
        tell(near, self.best.clone());
    }
}
