//! Which lemmas are tried for a claim.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cost, Instance};

use super::{Hint, Least, Lemma};
use crate::guess::Guesser;
use crate::plain::{self, Lit, Name};
use crate::{Budget, Claim};

/// The most agents of a core that builds on others for which a lemma is tried.
const FEW_AGENTS: usize = 12;

/// How finely a claim is taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Grain {
    /// A lemma for each core.
    Cores,
    /// A lemma for all cores that share agents.
    Groups,
}

/// What is guessed for one claim.
pub(super) struct Chooser<'a> {
    instance: &'a Instance,
    claim: &'a Claim,
    /// The cost that the claim is about, the last of its objective.
    cost: Cost,
    hints: &'a [Hint],
    budget: &'a Budget<'a>,
    least: BTreeMap<(String, Cost), u32>,
    /// The latest arrival that lemmas about arrivals leave an agent, as far as it is known.
    latest: BTreeMap<String, u32>,
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
            latest: BTreeMap::new(),
        }
    }

    /// The lemmas for the cores of the claim's cost, each once, in the order of the cores; `None` where the
    /// search of one agent ends too early.
    pub(super) fn lemmas(&mut self, grain: Grain) -> Option<Vec<Lemma>> {
        let own: Vec<&Hint> = self
            .hints
            .iter()
            .filter(|it| it.cost == self.cost)
            .collect();
        let mut lemmas: Vec<Lemma> = Vec::new();
        let mut add = |lemma: Lemma| {
            if !lemmas.contains(&lemma) {
                lemmas.push(lemma);
            }
        };
        match grain {
            Grain::Cores => {
                for hint in own {
                    let is_arrival = matches!(self.cost, Cost::Makespan | Cost::SumOfCosts);
                    let lemma = if hint.is_clause && is_arrival {
                        self.clause(&hint.limits)?
                    } else if hint.agents.len() > FEW_AGENTS {
                        continue; // others are found sooner
                    } else {
                        self.count(&hint.agents, hint.more)?
                    };
                    add(lemma);
                }
            }
            Grain::Groups => {
                for (agents, more) in groups(&own) {
                    let agents: Vec<String> = agents.into_iter().collect();
                    let lemma = if self.cost == Cost::Makespan {
                        self.clause(&agents.iter().map(|name| (name.clone(), u32::MAX)).collect())?
                    } else {
                        self.count(&agents, more)?
                    };
                    add(lemma);
                }
            }
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

    /// Finds the latest arrivals that lemmas leave the agents of a later cost.
    pub(super) fn limit_arrivals(&mut self, lemmas: &[&Lemma]) -> Option<()> {
        let is_arrival = |cost: &Cost| matches!(cost, Cost::Makespan | Cost::SumOfCosts);
        if is_arrival(&self.cost) || lemmas.is_empty() {
            return Some(());
        }
        let mut claim = self.claim.clone();
        claim.most.retain(|cost, _| is_arrival(cost));
        let least = self.by()?;
        let formula = plain::of_lemmas(self.instance, &claim, (least, lemmas), self.budget).ok()?;
        let mut levels: BTreeMap<usize, BTreeMap<u32, Lit>> = BTreeMap::new();
        for (lit, name) in (1..).zip(formula.names()) {
            if let &Name::Level(agent, Cost::SumOfCosts, level) = name {
                levels.entry(agent).or_default().insert(level, lit);
            }
        }
        let mut guesser = Guesser::new(&formula, self.budget);
        for (agent, levels) in levels {
            let levels: Vec<(u32, Lit)> = levels.into_iter().collect();
            // It can have so many of the levels, and no more.
            let (mut low, mut high) = (0, levels.len() + 1);
            while low + 1 < high {
                let middle = low.midpoint(high);
                if guesser.excludes(&[levels[middle - 1].1])? {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            let name = self.instance.agents()[agent].name.clone();
            let latest = match low.checked_sub(1) {
                Some(last) => levels[last].0,
                None => least.of(self.instance, agent, Cost::SumOfCosts, self.budget)?,
            };
            self.latest.insert(name, latest);
        }
        Some(())
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
            let known = self.latest.get(name).copied();
            let latest = [makespan, known].into_iter().flatten().min();
            lemma
                .by
                .insert(name.clone(), late.min(latest.unwrap_or(u32::MAX)));
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
