//! The arithmetic of lemmas as a formula: what the agents need beyond the least of each.
//!
//! A level says that an agent has at least so much of a cost, in order encoding: arrivals are the costs of
//! one agent in the makespan and in the sum of costs. A lemma is a clause over levels: one of its agents
//! arrives later, or its agents cost more together. With the limits of a claim the lemmas contradict each
//! other, which shows the claim: the formula knows nothing of the map.
//!
//! Least costs of each agent alone are distances, or searched ([`Least`]). Sums are totalizers (Bailleux and Boufkhad
//! 2003), in both directions.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cost, Instance};

use super::{Cnf, Lit, Name, NoFormula, check, count};
use crate::lemma::{Least, Lemma};
use crate::{Budget, Claim};

/// The formula that is satisfiable exactly where lemmas leave room for a plan of the kind that the claim
/// excludes.
///
/// # Errors
/// Where it is larger than the budget, the search of an agent alone is, or a lemma has an unknown agent.
pub fn of_lemmas(
    instance: &Instance,
    claim: &Claim,
    (least, lemmas): (Least, &[&Lemma]),
    budget: &Budget<'_>,
) -> Result<Cnf, NoFormula> {
    let mut levels = Levels {
        instance,
        claim,
        budget,
        by: least,
        least: BTreeMap::new(),
        of: BTreeMap::new(),
        slack: BTreeMap::new(),
    };
    let mut cnf = Cnf::default();
    let agents = levels.agents(lemmas)?;
    for cost in levels.costs() {
        levels.limit(&mut cnf, cost, &agents)?;
        check(&cnf, budget)?;
    }
    for lemma in lemmas {
        levels.require(&mut cnf, lemma)?;
        check(&cnf, budget)?;
    }
    Ok(cnf)
}

/// The levels of agents that lemmas are about.
struct Levels<'a> {
    instance: &'a Instance,
    claim: &'a Claim,
    budget: &'a Budget<'a>,
    /// How the least of each agent is found.
    by: Least,
    /// What an agent alone has of a cost at the least, as far as it was asked for.
    least: BTreeMap<(usize, Cost), u32>,
    /// By agent and cost: it has at least one more than the least, two more, and so on.
    of: BTreeMap<(usize, Cost), Vec<Lit>>,
    /// What all agents may have together beyond the least of each.
    slack: BTreeMap<Cost, u32>,
}

impl Levels<'_> {
    /// The agents of the lemmas, those of one lemma beside each other, so that the tree of a sum has them in
    /// one branch.
    fn agents(&self, lemmas: &[&Lemma]) -> Result<Vec<usize>, NoFormula> {
        let mut larger: Vec<&&Lemma> = lemmas.iter().collect();
        larger.sort_by_key(|lemma| std::cmp::Reverse(lemma.by.len()));
        let mut agents = Vec::new();
        let mut seen = BTreeSet::new();
        for lemma in larger {
            for name in lemma.by.keys() {
                let agent = self.index(name)?;
                if seen.insert(agent) {
                    agents.push(agent);
                }
            }
        }
        Ok(agents)
    }

    fn index(&self, name: &str) -> Result<usize, NoFormula> {
        let mut agents = self.instance.agents().iter();
        agents
            .position(|agent| agent.name == name)
            .ok_or(NoFormula::NoAgent)
    }

    /// The costs that the claim limits; arrivals stand for the makespan and the sum of costs.
    fn costs(&self) -> BTreeSet<Cost> {
        let as_level = |&cost: &Cost| match cost {
            Cost::Makespan => Cost::SumOfCosts,
            other => other,
        };
        self.claim.most.keys().map(as_level).collect()
    }

    /// The least of an agent alone.
    fn least(&mut self, agent: usize, cost: Cost) -> Result<u32, NoFormula> {
        if let Some(&known) = self.least.get(&(agent, cost)) {
            return Ok(known);
        }
        let found = self.by.of(self.instance, agent, cost, self.budget);
        let found = found.ok_or(NoFormula::TooLarge)?;
        self.least.insert((agent, cost), found);
        Ok(found)
    }

    /// The levels of one cost, and the limits of the claim on it.
    fn limit(&mut self, cnf: &mut Cnf, cost: Cost, agents: &[usize]) -> Result<(), NoFormula> {
        let all = self.instance.agents().len();
        let mut needed: u32 = 0;
        for agent in 0..all {
            needed = needed.saturating_add(self.least(agent, cost)?);
        }
        let slack = self
            .claim
            .most
            .get(&cost)
            .map(|&most| most.checked_sub(needed));
        let makespan = match cost {
            Cost::SumOfCosts => self.claim.most.get(&Cost::Makespan).copied(),
            _ => None,
        };
        let Some(slack) = slack.unwrap_or(Some(u32::MAX)) else {
            cnf.clause([]); // the agents alone need more
            return Ok(());
        };
        self.slack.insert(cost, slack);
        let mut groups = Vec::new();
        for &agent in agents {
            let least = self.least(agent, cost)?;
            let own = makespan.map(|last| last.checked_sub(least));
            let Some(own) = own.unwrap_or(Some(u32::MAX)) else {
                cnf.clause([]); // alone it takes longer
                return Ok(());
            };
            // One level more is enough to say that it has too much.
            let most = slack.min(own).saturating_add(1);
            if most as usize > self.budget.clauses {
                return Err(NoFormula::TooLarge);
            }
            let levels: Vec<Lit> = (1..=most)
                .map(|more| cnf.variable(Name::Level(agent, cost, least.saturating_add(more))))
                .collect();
            for pair in levels.windows(2) {
                cnf.implies(&[pair[1]], [pair[0]]);
            }
            if own <= slack
                && let Some(&late) = levels.get(own as usize)
            {
                cnf.clause([-late]);
            }
            groups.push(levels.clone());
            self.of.insert((agent, cost), levels);
        }
        if self.claim.most.contains_key(&cost) {
            let name = |more| Name::Beyond(cost, more);
            count::at_most(
                cnf,
                &name,
                &groups,
                true,
                slack as usize,
                self.budget.clauses,
            );
        }
        Ok(())
    }

    /// One of the limits of a lemma is broken.
    fn require(&mut self, cnf: &mut Cnf, lemma: &Lemma) -> Result<(), NoFormula> {
        let mut agents = Vec::new();
        for name in lemma.by.keys() {
            agents.push(self.index(name)?);
        }
        let mut clause = Vec::new();
        if self.slack.contains_key(&Cost::SumOfCosts) {
            for (&agent, &by) in agents.iter().zip(lemma.by.values()) {
                let Some(more) = self.beyond(agent, Cost::SumOfCosts, by)? else {
                    return Ok(()); // alone it is later
                };
                clause.extend(self.level(agent, Cost::SumOfCosts, more));
            }
        } else {
            return Ok(()); // nothing is known of arrivals
        }
        for (&cost, &most) in &lemma.most {
            let Some(&slack) = self.slack.get(&cost) else {
                return Ok(()); // nothing is known of this cost
            };
            let mut needed: u32 = 0;
            for &agent in &agents {
                needed = needed.saturating_add(self.least(agent, cost)?);
            }
            let Some(room) = most.checked_sub(needed) else {
                return Ok(()); // alone they need more
            };
            let more = room.min(slack).saturating_add(1);
            let groups: Vec<Vec<Lit>> = agents
                .iter()
                .filter_map(|&agent| self.of.get(&(agent, cost)).cloned())
                .collect();
            let name = |more| Name::Beyond(cost, more);
            let limit = self.budget.clauses;
            clause.push(count::at_least(cnf, &name, &groups, more as usize, limit));
        }
        cnf.clause(clause);
        Ok(())
    }

    /// How much beyond its least an agent has with one more than this; `None` where the least is more.
    fn beyond(&mut self, agent: usize, cost: Cost, most: u32) -> Result<Option<u32>, NoFormula> {
        let least = self.least(agent, cost)?;
        Ok(most.checked_sub(least).map(|room| room.saturating_add(1)))
    }

    /// The literal of a level; the highest one where it is above it, which says less.
    fn level(&self, agent: usize, cost: Cost, more: u32) -> Option<Lit> {
        let levels = self.of.get(&(agent, cost))?;
        let index = (more as usize).min(levels.len());
        levels.get(index.checked_sub(1)?).copied()
    }
}
