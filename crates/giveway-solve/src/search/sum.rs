//! The least sum of a cost over all agents, by unsatisfiable cores.
//!
//! OLL (Andres et al. 2012; Morgado, Dodaro and Marques-Silva 2014): assume
//! that every agent has the least cost it could have. A core names agents that
//! cannot all have it; so the bound rises by one, each of them may have one
//! more, and a totalizer allows one violation among them, which is assumed in
//! turn. When the assumptions hold together, the bound is met. Only agents that
//! a core names ever get larger diagrams.
//!
//! Cores that share nothing are collected first: what a core sets free stays
//! free until no further core is found.

use std::collections::BTreeMap;

use giveway_model::Cost;

use super::stage::{End, Search};
use crate::{
    encode::{collisions::AgentId, totalizer::totalizer},
    meter::Stop,
    sat::{Lit, Outcome},
};

/// A core of more literals ends a round: what is left without them is seldom
/// unsatisfiable, and asking takes as long as going on.
const LARGE_CORE: usize = 6;

/// What an assumption bounds.
#[derive(Clone, Copy, Debug)]
enum Soft {
    /// The cost of an agent is at most this.
    Agent(AgentId, u32),
    /// At most `k` inputs of a totalizer are true.
    Total { totalizer: usize, k: usize },
}

/// The state of one core-guided stage.
pub(crate) struct SumStage {
    cost: Cost,
    bound: u32,
    known: bool,
    softs: BTreeMap<Lit, Soft>,
    /// What cores set free, to be assumed again with the next round.
    waiting: Vec<Soft>,
    /// Violations of cores, to become totalizers with the next round.
    cores: Vec<Vec<Lit>>,
    totalizers: Vec<Vec<Lit>>,
}

impl SumStage {
    /// Minimises the sum of a cost. Where its optimum is `known`, and a limit
    /// of the search, a plan is all that is looked for.
    ///
    /// # Errors
    /// When the budget is spent. `bound` holds what was proved up to then.
    pub(crate) fn run(
        search: &mut Search,
        cost: Cost,
        known: Option<u32>,
        bound: &mut u32,
    ) -> Result<End, Stop> {
        let mut stage = Self {
            cost,
            bound: search.sum_of_minima(cost)?.max(known.unwrap_or(0)),
            known: known.is_some(),
            softs: BTreeMap::new(),
            waiting: Vec::new(),
            cores: Vec::new(),
            totalizers: Vec::new(),
        };
        *bound = stage.bound;
        search.report_bound(cost, stage.bound);
        search.begin(cost);
        for agent in search.above_minimum(cost)? {
            search.enter(agent)?;
        }
        for agent in search.team.insiders() {
            stage.adopt(search, agent)?;
        }
        loop {
            if search.incumbent_meets(cost, stage.bound) {
                stage.assume_waiting(search)?;
                stage.harden(search);
                return Ok(End::Least(stage.bound));
            }
            // The deadlines of a sum of costs guard the diagrams themselves.
            let guards = match cost {
                Cost::SumOfCosts => BTreeMap::new(),
                _ => search.guards(),
            };
            let mut assumptions: Vec<Lit> = stage.softs.keys().copied().collect();
            assumptions.extend(guards.keys().filter(|lit| !stage.softs.contains_key(lit)));
            match search.team.solve(&assumptions)? {
                Outcome::Sat if stage.is_waiting() => stage.assume_waiting(search)?,
                Outcome::Sat => {
                    let entered = search.settle()?;
                    if entered.is_empty() && !search.incumbent_meets(cost, stage.bound) {
                        return Err(Stop::Contradiction);
                    }
                    for agent in entered {
                        stage.adopt(search, agent)?;
                    }
                }
                Outcome::Unsat(core) => {
                    if core.is_empty() {
                        return Ok(End::None);
                    }
                    stage.learn(search, &core, &guards)?;
                    *bound = stage.bound;
                    search.polish()?;
                    if core.len() > LARGE_CORE {
                        stage.assume_waiting(search)?;
                    }
                }
            }
        }
    }

    fn is_waiting(&self) -> bool {
        !self.waiting.is_empty() || !self.cores.is_empty()
    }

    /// Assumes that an agent inside has the least cost it can have alone.
    fn adopt(&mut self, search: &mut Search, agent: AgentId) -> Result<(), Stop> {
        if self.known {
            return Ok(());
        }
        let least = match self.cost {
            Cost::SumOfCosts => search.problem.optima[agent],
            cost => search.team.least(agent, cost)?,
        };
        self.assume(search, Soft::Agent(agent, least))
    }

    /// Assumes a soft, or nothing where it holds anyway.
    fn assume(&mut self, search: &mut Search, soft: Soft) -> Result<(), Stop> {
        let lit = match soft {
            Soft::Agent(agent, most) if self.cost == Cost::SumOfCosts => {
                search.grow(agent, most)?;
                if most >= search.cap(agent) {
                    return Ok(());
                }
                search.team.by(agent, most)
            }
            Soft::Agent(agent, most) => search
                .team
                .more_than(agent, self.cost, most)?
                .map(|lit| !lit),
            Soft::Total { totalizer, k } => self.totalizers[totalizer].get(k).map(|&lit| !lit),
        };
        if let Some(lit) = lit {
            self.softs.insert(lit, soft);
        }
        Ok(())
    }

    /// Takes a core in: grows diagrams, or raises the bound.
    fn learn(
        &mut self,
        search: &mut Search,
        core: &[Lit],
        guards: &BTreeMap<Lit, AgentId>,
    ) -> Result<(), Stop> {
        let mut grown = false;
        for lit in core {
            if !self.softs.contains_key(lit)
                && let Some(&agent) = guards.get(lit)
            {
                grown |= search.grow_further(agent, u32::MAX)?;
            }
        }
        if grown {
            return Ok(());
        }
        if self.known {
            return Err(Stop::Contradiction);
        }
        self.bound += 1;
        search.report_bound(self.cost, self.bound);
        for lit in core {
            match self.softs.remove(lit) {
                Some(Soft::Agent(agent, most)) => {
                    self.waiting.push(Soft::Agent(agent, most + 1));
                }
                Some(Soft::Total { totalizer, k }) => {
                    self.waiting.push(Soft::Total {
                        totalizer,
                        k: k + 1,
                    });
                }
                None => {}
            }
        }
        if let [lit] = core {
            search.team.harden(!*lit);
        } else {
            self.cores.push(core.iter().map(|&lit| !lit).collect());
        }
        Ok(())
    }

    /// Begins a new round: all that cores set free is bounded again.
    fn assume_waiting(&mut self, search: &mut Search) -> Result<(), Stop> {
        for soft in std::mem::take(&mut self.waiting) {
            self.assume(search, soft)?;
        }
        for violations in std::mem::take(&mut self.cores) {
            let outputs = totalizer(&violations, search.team.clauses());
            let totalizer = self.totalizers.len();
            self.totalizers.push(outputs);
            // One violation is paid for by the core itself.
            self.assume(search, Soft::Total { totalizer, k: 1 })?;
        }
        Ok(())
    }

    /// The bound is met: every plan that meets it keeps all assumptions, so
    /// they become clauses, and every other plan is of no interest any more.
    fn harden(&mut self, search: &mut Search) {
        for (&lit, soft) in &self.softs {
            if !matches!(soft, Soft::Agent(..)) || self.cost != Cost::SumOfCosts {
                search.team.harden(lit);
            }
        }
        if self.cost == Cost::SumOfCosts {
            let mut caps = search.problem.optima.clone();
            for agent in search.team.insiders() {
                caps[agent] = search.cap(agent);
            }
            for soft in self.softs.values() {
                if let Soft::Agent(agent, most) = *soft {
                    caps[agent] = most;
                }
            }
            for (agent, cap) in caps.into_iter().enumerate() {
                search.lower_cap(agent, cap);
            }
        }
    }
}
