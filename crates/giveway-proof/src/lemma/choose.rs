//! Which lemmas are tried for a claim.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cost, Instance};

use super::refine::Refining;
use super::{Hint, Least, Lemma};
use crate::plain::SumLimit;
use crate::{Budget, Claim};

/// The most agents of a core that builds on others for which a lemma is tried.
const FEW_AGENTS: usize = 12;

/// What is guessed for one claim.
pub(super) struct Chooser<'a> {
    instance: &'a Instance,
    claim: &'a Claim,
    /// The cost that the claim is about, the last of its objective.
    cost: Cost,
    hints: &'a [Hint],
    budget: &'a Budget<'a>,
    least: BTreeMap<(String, Cost), u32>,
}

impl<'a> Chooser<'a> {
    pub(super) const fn new(
        (instance, claim, cost): (&'a Instance, &'a Claim, Cost),
        hints: &'a [Hint],
        budget: &'a Budget<'a>,
    ) -> Self {
        Self {
            instance,
            claim,
            cost,
            hints,
            budget,
            least: BTreeMap::new(),
        }
    }

    /// The cores of the claim's cost, in their order.
    pub(super) fn cores(&self) -> impl Iterator<Item = &'a Hint> + use<'a> {
        let cost = self.cost;
        self.hints.iter().filter(move |hint| hint.cost == cost)
    }

    /// The lemma of a core; `None` where it is about too many agents.
    pub(super) fn of_core(&mut self, hint: &Hint) -> Option<Lemma> {
        if hint.is_clause && is_arrival(self.cost) {
            self.clause(&hint.limits)
        } else if hint.agents.len() > FEW_AGENTS {
            None // others are found sooner
        } else {
            self.count(&hint.agents, hint.more)
        }
    }

    /// A lemma for all cores that share agents.
    pub(super) fn of_groups(&mut self) -> Option<Vec<Lemma>> {
        let own: Vec<&Hint> = self.cores().collect();
        let mut lemmas = Vec::new();
        for (agents, more) in groups(&own) {
            let agents: Vec<String> = agents.into_iter().collect();
            lemmas.push(if self.cost == Cost::Makespan {
                self.clause(&agents.iter().map(|name| (name.clone(), u32::MAX)).collect())?
            } else {
                self.count(&agents, more)?
            });
        }
        Some(lemmas)
    }

    /// That these agents cannot all arrive by these times.
    fn clause(&mut self, limits: &BTreeMap<String, u32>) -> Option<Lemma> {
        let agents: Vec<String> = limits.keys().cloned().collect();
        let mut lemma = self.within_claim(&agents)?;
        for (name, by) in &mut lemma.by {
            if let Some(&limit) = limits.get(name) {
                *by = limit.min(*by);
            }
        }
        if self.cost == Cost::SumOfCosts {
            lemma.most.remove(&Cost::SumOfCosts);
        }
        Some(lemma)
    }

    /// How the checker finds the least of each agent: by distances, where the search finds no more.
    pub(super) fn by(&mut self) -> Option<Least> {
        let costs: Vec<Cost> = self.claim.most.keys().copied().collect();
        for (index, agent) in self.instance.agents().iter().enumerate() {
            for &cost in &costs {
                let near = Least::Distance.of(self.instance, index, cost, self.budget)?;
                if self.least(&agent.name, cost)? > near {
                    return Some(Least::Search);
                }
            }
        }
        Some(Least::Distance)
    }

    /// The claim as far as it is about arrivals, and what it leaves the agents of the instance.
    pub(super) fn refining(&mut self) -> Option<(Claim, Refining<'a>)> {
        let mut claim = self.claim.clone();
        claim.most.retain(|cost, _| is_arrival(*cost));
        let least = self.arrivals()?;
        let slack = claim.most.get(&Cost::SumOfCosts).map_or(u32::MAX, |&most| {
            let each = least.iter();
            each.fold(most, |left, &own| left.saturating_sub(own))
        });
        let makespan = claim.most.get(&Cost::Makespan).copied();
        let latest = |own: &u32| own.saturating_add(slack).min(makespan.unwrap_or(u32::MAX));
        let refining = Refining {
            instance: self.instance,
            budget: self.budget,
            latest: least.iter().map(latest).collect(),
            least,
        };
        Some((claim, refining))
    }

    /// Whether cores that hold only with further agents are worth the search for these: where agents have
    /// batteries, or arrivals do not say it all. Else other lemmas are found sooner.
    pub(super) fn may_need_further_agents(&self) -> bool {
        let is_constrained = self.instance.constraints_in_force().next().is_some();
        let mut agents = self.instance.agents().iter();
        let has_battery = agents.any(|agent| agent.battery.is_some());
        !is_constrained && (has_battery || !is_arrival(self.cost))
    }

    /// The lemma of a core that holds only with further agents, which arrive by the latest times that lemmas
    /// leave them.
    pub(super) fn with_further_agents(
        &mut self,
        hint: &Hint,
        (least, lemmas): (Least, &[&Lemma]),
    ) -> Option<Lemma> {
        let (claim, refining) = self.refining()?;
        let mut by = refining.latest(&claim, (least, lemmas))?;
        let all = self.instance.agents();
        let of_arrival = is_arrival(self.cost);
        let mut own = Vec::new();
        for (agent, by) in all.iter().zip(&mut by) {
            if let Some(&limit) = hint.limits.get(&agent.name).filter(|_| of_arrival) {
                *by = limit.min(*by);
            }
        }
        for (index, agent) in all.iter().enumerate() {
            if hint.agents.contains(&agent.name) {
                own.push(index);
            }
        }
        let limit = if of_arrival {
            None
        } else {
            let mut most = hint.more.checked_sub(1)?;
            for name in &hint.agents {
                most = most.saturating_add(self.least(name, self.cost)?);
            }
            Some(SumLimit {
                cost: self.cost,
                agents: own.clone(),
                most,
            })
        };
        let mut agents = refining.core(&by, limit.as_ref())?;
        let mut lemma = Lemma::default();
        if limit.is_some() {
            agents.extend(own);
            let mut most = hint.more.checked_sub(1)?;
            agents.sort_unstable();
            agents.dedup();
            for &agent in &agents {
                most = most.saturating_add(self.least(&all[agent].name, self.cost)?);
            }
            lemma.most.insert(self.cost, most);
        }
        let named = agents
            .iter()
            .map(|&agent| (all[agent].name.clone(), by[agent]));
        lemma.by = named.collect();
        Some(lemma)
    }

    /// The least arrival of each agent.
    pub(super) fn arrivals(&mut self) -> Option<Vec<u32>> {
        let agents = self.instance.agents().iter();
        agents
            .map(|agent| self.least(&agent.name, Cost::SumOfCosts))
            .collect()
    }

    /// That these agents together have so much more than the least of each.
    pub(super) fn count(&mut self, agents: &[String], more: u32) -> Option<Lemma> {
        let mut lemma = self.within_claim(agents)?;
        let below = more.saturating_sub(1);
        let mut most = below;
        for name in agents {
            most = most.saturating_add(self.least(name, self.cost)?);
        }
        if self.cost == Cost::SumOfCosts {
            for (name, by) in &mut lemma.by {
                *by = (*by).min(self.least(name, Cost::SumOfCosts)?.saturating_add(below));
            }
        }
        let limit = lemma.most.entry(self.cost).or_insert(most);
        *limit = most.min(*limit);
        Some(lemma)
    }

    /// What the claim leaves these agents, where all others have the least of each.
    fn within_claim(&mut self, agents: &[String]) -> Option<Lemma> {
        let mut lemma = Lemma::default();
        let inside: BTreeSet<&String> = agents.iter().collect();
        let claim = self.claim;
        let mut slack = u32::MAX;
        for (&cost, &most) in &claim.most {
            if cost == Cost::Makespan {
                continue;
            }
            let (mut own, mut others) = (0u32, 0u32);
            for agent in self.instance.agents() {
                let least = self.least(&agent.name, cost)?;
                let sum = if inside.contains(&agent.name) {
                    &mut own
                } else {
                    &mut others
                };
                *sum = sum.saturating_add(least);
            }
            let left = most.checked_sub(others)?;
            if cost == Cost::SumOfCosts {
                slack = left.checked_sub(own)?;
            }
            lemma.most.insert(cost, left);
        }
        let makespan = claim.most.get(&Cost::Makespan).copied();
        for name in agents {
            let late = self.least(name, Cost::SumOfCosts)?.saturating_add(slack);
            lemma
                .by
                .insert(name.clone(), late.min(makespan.unwrap_or(u32::MAX)));
        }
        Some(lemma)
    }

    fn least(&mut self, name: &str, cost: Cost) -> Option<u32> {
        let key = (name.to_owned(), cost);
        if let Some(&known) = self.least.get(&key) {
            return Some(known);
        }
        let mut agents = self.instance.agents().iter();
        let agent = agents.position(|agent| agent.name == name)?;
        let least = Least::Search.of(self.instance, agent, cost, self.budget)?;
        self.least.insert(key, least);
        (least < u32::MAX).then_some(least)
    }
}

/// Whether a cost is told by arrivals alone.
const fn is_arrival(cost: Cost) -> bool {
    matches!(cost, Cost::Makespan | Cost::SumOfCosts)
}

/// Agents that cores connect, each group with the number of its cores.
fn groups(hints: &[&Hint]) -> Vec<(BTreeSet<String>, u32)> {
    let mut groups: Vec<(BTreeSet<String>, u32)> = Vec::new();
    for hint in hints {
        let mut joined: (BTreeSet<String>, u32) = (hint.agents.iter().cloned().collect(), 1);
        groups.retain(|(agents, cores)| {
            let is_apart = agents.is_disjoint(&joined.0);
            if !is_apart {
                joined.0.extend(agents.iter().cloned());
                joined.1 += cores;
            }
            is_apart
        });
        groups.push(joined);
    }
    groups
}
