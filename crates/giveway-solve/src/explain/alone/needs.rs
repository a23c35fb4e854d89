//! The least cost of some agents alone, solved.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Condition, Cost, Instance, Objective};

use crate::{
    Status,
    budget::Budget,
    explain::{
        ask::{Ask, best},
        budgets::further_search,
        causes::Refuted,
        fitting::FittingQuestion,
        growing::only,
    },
    impose::bearer,
    problem::Relaxed,
};

/// Sets that are solved.
const MOST_SOLVED: usize = 150;

/// The least of one cost of sets of agents, each solved once.
pub(super) struct Needs<'a, 'h> {
    refuted: Refuted<'a>,
    conditions: Vec<Condition>,
    objective: Objective,
    cost: Cost,
    /// What costs that matter more may be.
    caps: BTreeMap<Cost, u32>,
    horizon: u32,
    budget: &'a Rc<Budget<'h>>,
    known: BTreeMap<BTreeSet<usize>, Option<u32>>,
}

impl<'a, 'h> Needs<'a, 'h> {
    /// Of a question about a plan; `None` where there is no such objective.
    pub(super) fn new(
        case: &FittingQuestion<'a>,
        refuted: Refuted<'a>,
        cost: Cost,
        budget: &'a Rc<Budget<'h>>,
    ) -> Option<Self> {
        let before = case.objective().costs().iter();
        let before = before.take_while(|&&earlier| earlier != cost);
        let mut caps = BTreeMap::new();
        for &earlier in before {
            caps.insert(earlier, case.costs.get(earlier));
        }
        // What all agents may cost says nothing of what some need.
        let own = |it: &&Condition| !matches!(it, Condition::Below { agent: None, .. });
        Some(Self {
            refuted,
            conditions: case.conditions().filter(own).cloned().collect(),
            objective: Objective::new(vec![cost]).ok()?,
            cost,
            caps,
            horizon: case.costs.makespan,
            budget,
            known: BTreeMap::new(),
        })
    }

    /// Takes over what is proved of a set.
    pub(super) fn know(&mut self, agents: &BTreeSet<usize>, least: u32) {
        self.known.insert(agents.clone(), Some(least));
    }

    pub(super) const fn cost(&self) -> Cost {
        self.cost
    }

    pub(super) const fn instance(&self) -> &'a Instance {
        self.refuted.instance
    }

    /// The least that some agents alone need; `None` where that is not known.
    pub(super) fn least(&mut self, agents: &BTreeSet<usize>) -> Option<u32> {
        if let Some(&known) = self.known.get(agents) {
            return known;
        }
        if self.known.len() >= MOST_SOLVED || self.budget.check().is_err() {
            return None;
        }
        let found = self.solved(agents);
        self.known.insert(agents.clone(), found);
        found
    }

    /// What they need where each is alone.
    pub(super) fn own(&mut self, agents: &BTreeSet<usize>) -> Option<u32> {
        let mut own = 0_u32;
        for &agent in agents {
            let alone = self.least(&BTreeSet::from([agent]))?;
            own = match self.cost {
                Cost::Makespan => own.max(alone),
                Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
                    own.saturating_add(alone)
                }
            };
        }
        Some(own)
    }

    fn solved(&self, agents: &BTreeSet<usize>) -> Option<u32> {
        let variant = only(&self.refuted, agents);
        let borne = |it: &&Condition| bearer(it, &variant.instance).is_ok();
        let mut ways: Vec<&[Condition]> = self
            .conditions
            .iter()
            .filter(borne)
            .map(std::slice::from_ref)
            .collect();
        if ways.is_empty() {
            ways.push(&[]);
        }
        let mut least: Option<u32> = None;
        for conditions in ways {
            let part = further_search(self.budget);
            let found = best(
                &Ask {
                    instance: &variant.instance,
                    relaxed: &Relaxed::default(),
                    conditions,
                    objective: &self.objective,
                    caps: &self.caps,
                    within: variant.within,
                    at_least_within: self.horizon,
                },
                &part,
            );
            self.budget.absorb(&part);
            match (found.status, found.costs, found.reach) {
                (Status::Optimal, Some(costs), Some(reach)) if reach.covers(self.refuted.reach) => {
                    let own = costs.get(self.cost);
                    least = Some(least.map_or(own, |least| least.min(own)));
                }
                (Status::Impossible, _, Some(reach)) if reach.covers(self.refuted.reach) => {}
                (Status::Optimal | Status::Impossible | Status::Feasible | Status::Unknown, ..) => {
                    return None;
                }
            }
        }
        least
    }
}
