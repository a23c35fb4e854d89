//! Further lemmas, where those that the search suggests are not enough.
//!
//! By implicit hitting sets (Moreno-Centeno and Karp 2013): what the lemmas leave is a level of each agent.
//! A formula of all agents at these levels tells some that cannot keep them, which is a further lemma; if not
//! all, then the levels would be those of a plan. A lemma is made as strong as it holds: each of its
//! arrivals as late as can be. Nothing here is believed: lemmas made of it are proved.
//!
//! A core of the search may rest on what it had excluded of other agents before. Then the same formula, with the
//! others as late as the lemmas so far leave them, tells whom the lemma needs beside the agents of the core.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance};

use super::{Least, Lemma};
use crate::plain::{self, Cnf, Lit, Name, SumLimit};
use crate::prove::guess::{Guess, Guesser};
use crate::{Budget, Claim};

/// The most agents of which the arrivals of a lemma are made later.
const FEW_AGENTS: usize = 6;

/// So much later at the most.
const WIDER: u32 = 8;

/// Whether further lemmas can be found: about arrivals alone, where no rule of the scene's own is in force.
pub(super) fn can_refine(instance: &Instance, claim: &Claim) -> bool {
    let is_arrival = |cost: &Cost| matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    claim.most.keys().all(is_arrival) && instance.constraints_in_force().next().is_none()
}

/// What is looked for: agents of an instance that cannot keep arrivals, which a claim leaves them.
pub(super) struct Refining<'a> {
    pub(super) instance: &'a Instance,
    pub(super) budget: &'a Budget<'a>,
    /// The least arrival of each agent.
    pub(super) least: Vec<u32>,
    /// The latest arrival that the claim leaves each agent.
    pub(super) latest: Vec<u32>,
}

/// Agents that cannot keep what lemmas leave them.
pub(super) struct Excluded {
    /// That they cannot arrive by these times.
    pub(super) lemma: Lemma,
    /// How much later than their least the arrivals are that were left to them, together.
    pub(super) late: u32,
}

impl Refining<'_> {
    /// The arrivals that lemmas leave, by the formula that puts them together; `None` where they leave none,
    /// or the budget ran out.
    pub(super) fn left(&self, formula: &Cnf) -> Option<Vec<u32>> {
        let Guess::Model(model) = Guesser::new(formula, self.budget).guess(&[])? else {
            return None;
        };
        let mut arrivals = self.least.clone();
        for (name, lit) in formula.names().iter().zip(model) {
            if let &Name::Level(agent, Cost::SumOfCosts, level) = name
                && lit > 0
                && let Some(arrival) = arrivals.get_mut(agent)
            {
                *arrival = level.max(*arrival);
            }
        }
        Some(arrivals)
    }

    /// Agents that cannot keep these arrivals: several sets, which share none.
    pub(super) fn excluded(&self, arrivals: &[u32]) -> Option<Vec<Excluded>> {
        let (formula, asked) = plain::of_some(self.instance, arrivals, None, self.budget).ok()?;
        let mut guesser = Guesser::new(&formula, self.budget);
        let mut open = asked.clone();
        let mut found = Vec::new();
        while let Guess::Core(core) = guesser.guess(&open)? {
            open.retain(|asks| !core.contains(asks));
            let agents: Vec<usize> = (0..asked.len())
                .filter(|&agent| core.contains(&asked[agent]))
                .collect();
            if agents.is_empty() {
                return None;
            }
            found.push(self.excluded_of(&agents, arrivals)?);
        }
        Some(found)
    }

    /// Agents that cannot keep these arrivals and a limit, if there are such.
    pub(super) fn core(&self, arrivals: &[u32], limit: Option<&SumLimit>) -> Option<Vec<usize>> {
        let formula = plain::of_some(self.instance, arrivals, limit, self.budget);
        let (formula, asked) = formula.ok()?;
        let Guess::Core(core) = Guesser::new(&formula, self.budget).guess(&asked)? else {
            return None;
        };
        let is_in = |agent: &usize| core.contains(&asked[*agent]);
        Some((0..asked.len()).filter(is_in).collect())
    }

    /// The latest arrivals that lemmas leave within a claim about arrivals.
    pub(super) fn latest(
        &self,
        claim: &Claim,
        (by, lemmas): (Least, &[&Lemma]),
    ) -> Option<Vec<u32>> {
        let formula = |claim: &Claim| {
            let formula = plain::of_lemmas(self.instance, claim, (by, lemmas), self.budget);
            formula.ok()
        };
        let of_claim = formula(claim)?;
        let mut levels: BTreeMap<usize, Vec<(u32, Lit)>> = BTreeMap::new();
        for (lit, name) in (1..).zip(of_claim.names()) {
            if let &Name::Level(agent, Cost::SumOfCosts, level) = name {
                levels.entry(agent).or_default().push((level, lit));
            }
        }
        let mut latest = self.latest.clone();
        if let Some(&most) = claim.most.get(&Cost::SumOfCosts) {
            // Those of no lemma have what is left beyond the least of all together.
            let least: u32 = self.least.iter().sum();
            let (mut low, mut high) = (least.checked_sub(1)?, most);
            while low + 1 < high {
                let middle = low.midpoint(high);
                let mut less = claim.clone();
                less.most.insert(Cost::SumOfCosts, middle);
                match Guesser::new(&formula(&less)?, self.budget).guess(&[])? {
                    Guess::Core(_) => low = middle,
                    Guess::Model(_) => high = middle,
                }
            }
            for (latest, &least) in latest.iter_mut().zip(&self.least) {
                *latest = (*latest).min(least.saturating_add(most - high));
            }
        }
        let mut guesser = Guesser::new(&of_claim, self.budget);
        for (agent, levels) in levels {
            // It can have so many of the levels, and not so many.
            let (mut low, mut high) = (0, levels.len() + 1);
            while low + 1 < high {
                let middle = low.midpoint(high);
                if guesser.excludes(&[levels[middle - 1].1])? {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            let most = low.checked_sub(1).map(|last| levels[last].0);
            latest[agent] = most.unwrap_or(self.least[agent]).min(self.latest[agent]);
        }
        Some(latest)
    }

    fn excluded_of(&self, agents: &[usize], arrivals: &[u32]) -> Option<Excluded> {
        let all = self.instance.agents();
        let mut by: BTreeMap<usize, u32> = agents
            .iter()
            .map(|&agent| (agent, arrivals[agent]))
            .collect();
        let late = agents
            .iter()
            .map(|&agent| arrivals[agent] - self.least[agent]);
        let late = late.fold(0, u32::saturating_add);
        if agents.len() <= FEW_AGENTS {
            self.widen(&mut by)?;
        }
        let named = by
            .into_iter()
            .map(|(agent, by)| (all[agent].name.clone(), by));
        let lemma = Lemma {
            by: named.collect(),
            ..Lemma::default()
        };
        Some(Excluded { lemma, late })
    }

    /// Makes each arrival as late as the agents still cannot keep them, and leaves out who is not needed.
    fn widen(&self, by: &mut BTreeMap<usize, u32>) -> Option<()> {
        let agents: Vec<usize> = by.keys().copied().collect();
        let mut scene = self.instance.clone();
        let all = self.instance.agents();
        scene.retain_agents(|agent| agents.iter().any(|&one| all[one].name == agent.name));
        let latest = |&agent: &usize| by[&agent].saturating_add(WIDER).min(self.latest[agent]);
        let latest: Vec<u32> = agents.iter().map(latest).collect();
        let (formula, asked) = plain::of_some(&scene, &latest, None, self.budget).ok()?;
        let done: BTreeMap<(usize, u32), Lit> = (1..)
            .zip(formula.names())
            .filter_map(|(lit, name)| match *name {
                Name::Done(agent, time) => Some(((agent, time), lit)),
                _ => None,
            })
            .collect();
        let mut guesser = Guesser::new(&formula, self.budget);
        let assumed = |by: &BTreeMap<usize, u32>| -> Vec<Lit> {
            let each = agents.iter().enumerate();
            let each = each.filter_map(|(index, agent)| Some((index, by.get(agent)?)));
            each.flat_map(|(index, &by)| [Some(asked[index]), done.get(&(index, by)).copied()])
                .flatten()
                .collect()
        };
        for (index, &agent) in agents.iter().enumerate() {
            let mut without = by.clone();
            without.remove(&agent);
            if guesser.excludes(&assumed(&without))? {
                *by = without;
                continue;
            }
            // It holds up to `low`, and not from `high` on.
            let (mut low, mut high) = (by[&agent], latest[index] + 1);
            while low + 1 < high {
                let middle = low.midpoint(high);
                by.insert(agent, middle);
                if guesser.excludes(&assumed(by))? {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            by.insert(agent, low);
        }
        Some(())
    }
}
