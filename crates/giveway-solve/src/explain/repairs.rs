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
mod order;
mod pairs;
mod suspects;

use std::collections::BTreeMap;

use giveway_model::{
    Costs, Instance, Objective, Plan,
    check::{costs, own_costs},
    constraint::ConstraintKind,
    sorting::sort_by_key,
};

use super::{
    answer::{Edit, Repair},
    edits::edited,
    group::{Group, Variant, has_slow_edge},
    group_mus::{Inquiry, Tried},
    whole::WholePlan,
    words,
};
use crate::search::Proved;
use candidate::{Candidate, candidates};
use order::{first_of_each_kind, rank};
pub(crate) use suspects::suspects;

/// A question that can also be answered by the best plan.
pub(crate) trait Solver: Inquiry {
    /// The best plan that can be had in time.
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan>;
    /// The same where it may cost more than was asked for.
    fn cheapest(&mut self, variant: &Variant) -> Option<EditedPlan>;
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

/// Finds repairs of one and of two edits.
pub(crate) fn repairs(broken: &Unsolved, solver: &mut dyn Solver) -> Repairs {
    let known = broken.cores.first();
    let mut first = known.unwrap_or(&broken.suspects).clone();
    let is_slow = first.contains(&Group::Slow) || !has_slow_edge(broken.instance.grid());
    let mut battery = broken.charging.map(Group::Battery);
    battery.take_if(|it| first.contains(it));
    first.extend(battery);
    let mut search = RepairSearch {
        broken,
        solver,
        exhaustive: known.is_some() && is_slow && battery.is_none(),
        tried: BTreeMap::new(),
        found: Vec::new(),
    };
    let mut singles = search.candidates(broken.instance, &first);
    if known.is_none() {
        // A charger may be anywhere: too many for a guess.
        singles.retain(|it| !matches!(it, Candidate::Edit(Edit::AddCharger { .. })));
    }
    for candidate in &singles {
        search.try_alone(candidate);
    }
    if known.is_some() {
        search.try_pairs(&singles);
    }
    let (exhaustive, found) = (search.exhaustive, search.found);
    let (first, further) = first_of_each_kind(found, broken.objective);
    Repairs {
        first,
        further,
        exhaustive,
    }
}

struct RepairSearch<'a> {
    broken: &'a Unsolved<'a>,
    solver: &'a mut dyn Solver,
    exhaustive: bool,
    /// Whether single edits help, where they were tried; `None` is not known.
    tried: BTreeMap<Candidate, Option<bool>>,
    found: Vec<Repair>,
}

impl RepairSearch<'_> {
    fn candidates(&mut self, instance: &Instance, facts: &[Group]) -> Vec<Candidate> {
        let (candidates, are_all) = candidates(instance, facts, self.broken.asked);
        self.exhaustive &= are_all;
        candidates
    }

    /// Whether a single edit helps; where it does, it is kept.
    fn try_alone(&mut self, candidate: &Candidate) -> Option<bool> {
        if let Some(&outcome) = self.tried.get(candidate) {
            return outcome;
        }
        let outcome = self.attempt(&[candidate]);
        self.tried.insert(candidate.clone(), outcome);
        outcome
    }

    /// Tries edits together, each as far-reaching as it can be; keeps the least that
    /// help. `None` where it is not known whether they help.
    fn attempt(&mut self, candidates: &[&Candidate]) -> Option<bool> {
        let instance = self.broken.instance;
        let strongest = |candidate: &&Candidate| candidate.strongest(instance);
        let mut edits: Vec<Option<Edit>> = candidates.iter().map(strongest).collect();
        let has_deadline = candidates.iter().any(|c| matches!(c, Candidate::Deadline));
        let within = self.broken.within.filter(|_| !has_deadline);
        let outcome = self.helps(&flat(&edits), within);
        if outcome != Some(true) {
            return outcome;
        }
        let mut is_least = true;
        for (index, candidate) in candidates.iter().enumerate() {
            is_least &= self.lessen(candidate, index, &mut edits, within);
        }
        let mut edits = flat(&edits);
        if edits.iter().any(|edit| is_as_good_as_off(edit, instance)) {
            return outcome; // its rule is also switched off
        }
        let whole = self.broken.whole;
        let Some(mut best) = self.best(&edited(instance, &edits, within, whole)) else {
            self.exhaustive = false;
            return outcome;
        };
        if has_deadline && let Some(within) = self.broken.within {
            let (least, shown) = self.least_deadline(&edits, within, best.costs.makespan);
            is_least &= shown;
            edits.push(Edit::Deadline { within: least });
            let sooner = edited(instance, &edits, Some(within), whole);
            let Some(sooner) = self.solver.best(&sooner) else {
                self.exhaustive = false;
                return outcome;
            };
            // The least deadline is told; with a later one it may cost less.
            let [now, later] = [&sooner, &best].map(|best| self.vector(&best.costs));
            self.exhaustive &= now <= later;
            best = sooner;
        }
        self.exhaustive &= best.proved && is_least;
        sort_by_key(&mut edits, rank);
        let arriving = self.broken.arriving;
        let arrival = arriving.and_then(|name| own_costs(instance, name, &best.plan));
        let mut repair = Repair {
            edits,
            least: is_least,
            costs: best.costs,
            arrival: arrival.map(|costs| self.broken.whole.time(costs.makespan)),
            proved: best.proved,
            plan: best.plan,
            text: String::new(),
        };
        repair.text = words::repair(&repair, arriving);
        self.found.push(repair);
        outcome
    }

    fn vector(&self, costs: &Costs) -> Vec<u32> {
        costs.vector(self.broken.objective)
    }

    /// The best plan; of a large floor without a known set any plan that costs little enough,
    /// where the best is not found in time. Where it is not proved, what is left of the plan that
    /// is asked about may be better.
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan> {
        let mut best = self.solver.best(variant);
        if best.is_none()
            && self.broken.cores.is_empty()
            && let Tried::Plan(plan) = self.solver.search_briefly(variant)
        {
            best = unproved(variant, plan);
        }
        let is_proved = best.as_ref().is_some_and(|best| best.proved);
        let rest = self.rest(variant).filter(|_| !is_proved);
        best.into_iter()
            .chain(rest)
            .min_by_key(|it| self.vector(&it.costs))
    }

    /// The plan that is asked about without the agents that are left out, where it is as asked for.
    fn rest(&self, variant: &Variant) -> Option<EditedPlan> {
        let mut plan = self.broken.plan?.clone();
        let agents = variant.instance.agents();
        let is_there = |name: &String| agents.iter().any(|agent| agent.name == *name);
        plan.paths.retain(|name, _| is_there(name));
        plan.charges.retain(|name, _| is_there(name));
        let is_as_asked = self.solver.accepts(variant, &plan);
        unproved(variant, plan).filter(|_| is_as_asked)
    }

    /// Whether there is a plan after some edits; `None` where that is not known.
    fn helps(&mut self, edits: &[Edit], within: Option<u32>) -> Option<bool> {
        if self.solver.is_over() {
            self.exhaustive = false;
            return None;
        }
        let variant = edited(self.broken.instance, edits, within, self.broken.whole);
        let tried = self.search(&variant);
        match tried.reaching(&variant, self.broken.reach) {
            Tried::Plan(_) => Some(true),
            Tried::None { .. } => Some(false),
            Tried::Unknown => {
                self.exhaustive = false;
                None
            }
        }
    }

    /// Looks for a plan of an edited instance: long where a set of facts is known, and briefly where
    /// edits are guessed.
    fn search(&mut self, variant: &Variant) -> Tried {
        if self.broken.cores.is_empty() {
            return self.solver.search_briefly(variant);
        }
        let tried = self.solver.search(variant);
        if matches!(tried, Tried::Unknown) && !self.solver.is_over() {
            return self.solver.search_longer(variant);
        }
        tried
    }
}

/// Whether a limit is raised to the number of agents that it counts.
fn is_as_good_as_off(edit: &Edit, instance: &Instance) -> bool {
    let Edit::AllowMore { index, most, .. } = edit else {
        return false;
    };
    let mut rules = instance.constraints_in_force();
    let rule = rules.find(|rule| rule.index == *index as usize);
    rule.is_some_and(|rule| {
        let is_capacity = matches!(rule.constraint.kind, ConstraintKind::Capacity { .. });
        is_capacity && *most as usize >= rule.agents.len()
    })
}

/// The edits that are there: a deadline that is given up is none.
fn flat(edits: &[Option<Edit>]) -> Vec<Edit> {
    edits.iter().flatten().cloned().collect()
}
