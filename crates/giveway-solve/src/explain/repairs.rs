//! Repairs: edits after which there is a plan, each tried.
//!
//! An edit can help only if it weakens a fact of every set of facts that excludes a
//! plan; so single edits come from the first set. A pair must weaken every set, too: its
//! first edit comes from the first set, its second from a set that excludes a plan after
//! the first edit (`pairs`; a tree of hitting sets, Reiter 1987). Two facts are
//! exceptions: a slow zone that becomes normal is no mere relaxation (see `group_mus.rs`),
//! and an agent that is to charge cannot without its battery. Where a set holds without
//! such a fact, edits outside of it may still help.
//!
//! Of many agents without a small set, edits are guessed: those of facts about agents in the answer.

mod candidate;
mod least;
mod likewise;
mod order;
mod pairs;
mod search;
mod suspects;

use std::collections::BTreeMap;

use giveway_model::{Costs, Instance, Objective, Plan, check::costs};

use super::{
    answer::{Edit, Repair},
    group::{Group, Variant, has_slow_edge},
    group_mus::Inquiry,
    whole::WholePlan,
};
use crate::search::Proved;
use candidate::{Candidate, candidates};
use order::first_of_each_kind;
use search::{Effort, RepairSearch};
pub(crate) use suspects::suspects;

/// A question that can also be answered by the best plan.
pub(crate) trait Solver: Inquiry {
    /// The best plan that can be had in time.
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan>;
    /// The same where it may cost more than was asked for.
    fn cheapest(&mut self, variant: &Variant) -> Option<EditedPlan>;
    /// A plan as asked for that is near to a known one, looked for briefly.
    fn near_to(&mut self, plan: &Plan, variant: &Variant) -> Option<Plan>;
}

/// A plan of an edited instance.
pub(crate) struct EditedPlan {
    pub(crate) plan: Plan,
    pub(crate) costs: Costs,
    /// Whether it is proved that none is better, as far as is looked.
    pub(crate) proved: bool,
}

/// One that may not be the best.
fn unproved(variant: &Variant, plan: Plan) -> Option<EditedPlan> {
    let costs = costs(&variant.instance, &plan)?;
    Some(EditedPlan {
        plan,
        costs,
        proved: false,
    })
}

/// An instance without a plan, or without one as asked for.
pub(crate) struct Unsolved<'a> {
    pub(crate) instance: &'a Instance,
    /// Whether that is a large floor, where what is soon found out comes first.
    pub(crate) is_large: bool,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    pub(crate) objective: &'a Objective,
    /// The plan that is asked about, where there is one.
    pub(crate) plan: Option<&'a Plan>,
    /// Agents that are never left out.
    pub(crate) asked: &'a [usize],
    /// The agent whose arrival is asked about.
    pub(crate) arriving: Option<&'a str>,
    /// The agent that is to charge.
    pub(crate) charging: Option<usize>,
    /// How far it is proved that there is none.
    pub(crate) reach: Proved,
    /// Sets of facts that exclude a plan, one at least; none where no set is known.
    pub(crate) cores: Vec<Vec<Group>>,
    /// Where no set is known: facts of which edits are tried.
    pub(crate) suspects: Vec<Group>,
    /// The plan of which the instance is the rest.
    pub(crate) whole: WholePlan<'a>,
}

/// The edits that would help.
pub(crate) struct Repairs {
    /// The first of them, the best of each kind before all others.
    pub(crate) first: Vec<Repair>,
    /// How many more help.
    pub(crate) further: u32,
    /// Whether all repairs of one or two edits were tried, each to its end.
    pub(crate) exhaustive: bool,
}

/// Single edits that were tried.
#[derive(Default)]
pub(crate) struct TriedEdits {
    /// Whether they help; `None` is not known.
    outcomes: BTreeMap<Candidate, Option<bool>>,
    found: Vec<Repair>,
}

impl TriedEdits {
    /// Those that help, the best first.
    pub(crate) fn repairs(&self, objective: &Objective) -> Vec<Repair> {
        first_of_each_kind(self.found.clone(), objective).0
    }

    /// The repair that leaves one fact out, if that helps.
    pub(crate) fn without(&self, fact: Group, instance: &Instance) -> Option<&Repair> {
        let fact = candidates(instance, &[fact], &[]).0;
        let is_it = |edit: &Edit| fact.contains(&Candidate::Edit(edit.clone()));
        let mut found = self.found.iter();
        found.find(|repair| matches!(&repair.edits[..], [edit] if is_it(edit)))
    }
}

/// Tries to leave out each of these facts alone, of agents, waypoints and rules; `tried` are edits that
/// were tried before.
pub(crate) fn try_each(
    broken: &Unsolved,
    facts: &[Group],
    tried: TriedEdits,
    solver: &mut dyn Solver,
) -> TriedEdits {
    let mut search = RepairSearch::new(broken, tried, solver);
    let mut each = search.candidates(broken.instance, facts);
    each.retain(Candidate::leaves_fact_out);
    search.try_each(Effort::Usual, &each);
    // What was not found out may be looked for longer.
    search.tried.outcomes.retain(|_, helps| helps.is_some());
    search.tried
}

/// Finds repairs of one and of two edits; `tried` are those that were tried before.
pub(crate) fn repairs(broken: &Unsolved, tried: TriedEdits, solver: &mut dyn Solver) -> Repairs {
    let known = broken.cores.first();
    let mut first = known.unwrap_or(&broken.suspects).clone();
    let is_slow = first.contains(&Group::Slow) || !has_slow_edge(broken.instance.grid());
    let mut battery = broken.charging.map(Group::Battery);
    battery.take_if(|it| first.contains(it));
    first.extend(battery);
    let mut search = RepairSearch::new(broken, tried, solver);
    search.exhaustive = known.is_some() && is_slow && battery.is_none();
    let mut singles = search.candidates(broken.instance, &first);
    if known.is_none() {
        // A charger may be anywhere: too many for a guess.
        singles.retain(|it| !matches!(it, Candidate::Edit(Edit::AddCharger { .. })));
    }
    if known.is_some() && broken.is_large {
        search.try_each(Effort::Usual, &singles);
        search.tried.outcomes.retain(|_, helps| helps.is_some());
    }
    let effort = known.map_or(Effort::Brief, |_| Effort::Long);
    search.try_each(effort, &singles);
    if known.is_some() {
        search.try_pairs(&singles);
    }
    let (exhaustive, found) = (search.exhaustive, search.tried.found);
    let (first, further) = first_of_each_kind(found, broken.objective);
    Repairs {
        first,
        further,
        exhaustive,
    }
}
