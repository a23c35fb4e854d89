//! The least sum of a cost over all agents, by unsatisfiable cores.
//!
//! OLL (Andres et al. 2012; Morgado, Dodaro and Marques-Silva 2014): assume
//! that every agent has the least cost it could have. A core names agents that
//! cannot all have it; so the bound rises by one, each of them may have one
//! more, and a totalizer allows one violation among them, which is assumed in
//! turn. When the assumptions hold together, the bound is met. Only agents that
//! a core names ever get larger MDDs.
//!
//! Cores that share nothing are collected first: what a core sets free stays
//! free until no further core is found. A core that comes again with the next
//! levels of the same agents is *stretched*: two agents that meet in a corridor
//! are a core for as many levels as the corridor is long, and all of these are
//! learnt at once. A small core is *exhausted* ([`core_exhaustion`]): its agents are
//! looked at by themselves until they hold together. What the best plan so far
//! excludes is made clauses ([`hardening`]); better plans come out of models
//! ([`upper_bound`]).

mod core_exhaustion;
mod hardening;
mod last_phase;
mod lineage;
mod soft;
mod upper_bound;

use std::collections::BTreeMap;

use giveway_model::Cost;

use super::{
    growing::{CoreEffort, Growing, Until},
    stage::{End, Search},
};
use crate::{budget::Stop, encode::collisions::AgentId, sat::Lit};
use giveway_model::sorting::{sort, sort_by_key};
use lineage::Lineage;
use soft::Soft;

/// A core of more literals ends a round: little is left to be unsatisfiable
/// without them, and asking takes as long as going on.
const LARGE_CORE: usize = 10;

/// Agents of a core that is tried at higher levels.
const STRETCHED: usize = 2;

/// The state of one core-guided stage.
pub(crate) struct SumStage {
    cost: Cost,
    bound: u32,
    known: bool,
    /// No further cost is minimised: nothing is of interest but a better plan.
    last: bool,
    /// No agent has a battery. Where one has, calls that end with a model take
    /// so long that smaller cores cost more than they save, as measured.
    light: bool,
    softs: BTreeMap<Lit, Soft>,
    /// What cores set free, to be assumed again with the next round.
    waiting: Vec<Soft>,
    /// Violations of cores, to become totalizers with the next round.
    cores: Vec<PaidCore>,
    totalizers: Vec<Vec<Lit>>,
    /// How often some agents have been a core.
    seen: BTreeMap<Vec<AgentId>, u32>,
    /// The best plan's cost and the bound of when levels were last excluded.
    hardened: Option<(u32, u32)>,
    /// How many cores raised the bound.
    paid: usize,
    /// What each core builds on.
    lineage: Lineage,
}

/// A core that raised the bound.
struct PaidCore {
    /// As the n-th, from 0.
    number: usize,
    /// Its assumptions, each violated.
    violations: Vec<Lit>,
}

impl SumStage {
    /// Minimises the sum of a cost. Where its optimum is `known`, and a limit
    /// of the search, a plan is all that is looked for. Where the cost is the
    /// `last` one, the search is of no use afterwards.
    ///
    /// # Errors
    /// When the budget is spent. `bound` holds what was proved up to then.
    pub(crate) fn run(
        search: &mut Search,
        cost: Cost,
        known: Option<u32>,
        last: bool,
        bound: &mut u32,
    ) -> Result<End, Stop> {
        let mut stage = Self {
            cost,
            bound: search.sum_of_minima(cost)?.max(known.unwrap_or(0)),
            known: known.is_some(),
            last,
            light: search.problem.tasks.iter().all(|t| t.reserve.is_none()),
            softs: BTreeMap::new(),
            waiting: Vec::new(),
            cores: Vec::new(),
            totalizers: Vec::new(),
            seen: BTreeMap::new(),
            hardened: None,
            paid: 0,
            lineage: Lineage::default(),
        };
        *bound = stage.bound;
        search.report_bound(cost, stage.bound);
        search.begin(cost);
        search.tell_phase(cost)?;
        search.minimise_cores(stage.light);
        let above = search.above_minimum(cost)?;
        for &agent in &above {
            search.enter(agent)?;
        }
        search.tell_entered(&above, &BTreeMap::new());
        for agent in search.team.insiders() {
            stage.adopt(search, agent)?;
        }
        loop {
            if search.incumbent_meets(cost, stage.bound) {
                stage.begin_phase(search)?;
                stage.harden(search);
                return Ok(End::Least(stage.bound));
            }
            stage.harden_by_gap(search);
            if let Some(end) = stage.close(search)? {
                *bound = stage.bound;
                return Ok(end);
            }
            // The deadlines of a sum of costs guard the MDDs themselves.
            let until = match cost {
                Cost::SumOfCosts => Until::Guarded,
                _ => Until::EVER,
            };
            match search.solve_growing(stage.in_order(), until)? {
                Growing::Model if stage.is_waiting() => {
                    stage.improve_upper_bound(search)?;
                    stage.begin_phase(search)?;
                }
                Growing::Model => {
                    let entered = search.settle()?;
                    if entered.is_empty() && !search.incumbent_meets(cost, stage.bound) {
                        return Err(Stop::Contradiction);
                    }
                    for agent in entered {
                        stage.adopt(search, agent)?;
                    }
                }
                Growing::Grown(literals) => {
                    search.polish(cost, stage.bound)?;
                    if literals > LARGE_CORE {
                        stage.begin_phase(search)?;
                    }
                }
                Growing::Core(core) => {
                    let effort = core.effort();
                    let core = core.lits();
                    if core.is_empty() {
                        let best = stage.excluded();
                        if let Some(best) = best {
                            search.tell_closed(cost, (stage.bound, best), effort);
                        }
                        *bound = best.unwrap_or(stage.bound);
                        return Ok(best.map_or(End::None, End::Least));
                    }
                    let learnt = stage.add_core(search, core, effort);
                    *bound = stage.bound;
                    learnt?;
                    search.polish(cost, stage.bound)?;
                    if core.len() > LARGE_CORE {
                        stage.begin_phase(search)?;
                    }
                }
            }
        }
    }

    /// The best plan's cost, where plans that are not better are excluded.
    fn excluded(&self) -> Option<u32> {
        self.hardened.filter(|_| self.last).map(|(best, _)| best)
    }

    /// All that is assumed. Assumptions are made in this order. Without
    /// batteries totalizers come first, so that what many agents share is
    /// settled before what only one of them does: measured, that gives smaller
    /// cores and fewer conflicts.
    fn in_order(&self) -> Vec<Lit> {
        let is_agent = |soft: &Soft| matches!(soft, Soft::Agent(..));
        let mut softs: Vec<(&Lit, &Soft)> = self.softs.iter().collect();
        if self.light {
            sort_by_key(&mut softs, |(_, soft)| is_agent(soft));
        }
        softs.into_iter().map(|(&lit, _)| lit).collect()
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
            Cost::SumOfCosts => search.problem.least_cost(agent),
            cost => search.team.least(agent, cost)?,
        };
        self.assume(search, Soft::Agent(agent, least))
    }

    /// Assumes a soft, or nothing where it holds anyway.
    fn assume(&mut self, search: &mut Search, soft: Soft) -> Result<(), Stop> {
        if let Some(lit) = self.literal(search, soft)? {
            self.softs.insert(lit, soft);
        }
        Ok(())
    }

    /// The literal of a soft; `None` where it holds anyway.
    fn literal(&mut self, search: &mut Search, soft: Soft) -> Result<Option<Lit>, Stop> {
        match soft {
            Soft::Agent(agent, most) if self.cost == Cost::SumOfCosts => {
                let time = search.problem.time_of(agent, most);
                search.grow(agent, time)?;
                if time >= search.cap(agent) {
                    return Ok(None);
                }
                Ok(search.team.by(agent, time))
            }
            Soft::Agent(agent, most) => {
                let more = search.team.more_than(agent, self.cost, most)?;
                Ok(more.map(|lit| !lit))
            }
            Soft::Total { totalizer, k } => Ok(self.totalizers[totalizer].get(k).map(|&lit| !lit)),
        }
    }

    /// Takes a core in: raises the bound.
    fn add_core(
        &mut self,
        search: &mut Search,
        core: &[Lit],
        effort: CoreEffort,
    ) -> Result<(), Stop> {
        if self.known {
            return Err(Stop::Contradiction);
        }
        let softs: Vec<Soft> = core
            .iter()
            .filter_map(|lit| self.softs.remove(lit))
            .collect();
        let first = self.cores.len();
        self.pay(search, core, &softs, effort);
        let further = self.exhaust_core(search, &softs)?;
        let raised = softs.iter().map(|soft| soft.raised(further + 1));
        let softs = self.exhaust(search, raised.collect(), first)?;
        self.waiting.extend(softs);
        Ok(())
    }

    /// Raises the bound by a core, which says that these limits cannot all be kept.
    fn pay(&mut self, search: &mut Search, core: &[Lit], limits: &[Soft], effort: CoreEffort) {
        self.bound += 1;
        search.report_bound(self.cost, self.bound);
        self.tell_core(search, limits, effort);
        if let [lit] = core {
            search.team.harden(!*lit);
        } else {
            self.cores.push(PaidCore {
                number: self.paid,
                violations: core.iter().map(|&lit| !lit).collect(),
            });
        }
        self.paid += 1;
    }

    /// Learns the cores of the same agents at higher levels, where there are
    /// any; by how many levels. Tried only for agents that have been a core
    /// before, and twice as far each time that it succeeds.
    fn exhaust_core(&mut self, search: &mut Search, softs: &[Soft]) -> Result<u32, Stop> {
        let agents: Option<Vec<AgentId>> = softs.iter().map(Soft::agent).collect();
        let Some(mut agents) = agents.filter(|agents| agents.len() <= STRETCHED) else {
            return Ok(0);
        };
        sort(&mut agents);
        let seen = self.seen.entry(agents).or_insert(0);
        *seen += 1;
        let (mut step, mut learnt) = (*seen - 1, 0);
        while step > 0 {
            let mut levels = Vec::new();
            for level in learnt + 1..=learnt + step {
                let mut core = Vec::new();
                for soft in softs {
                    core.extend(self.literal(search, soft.raised(level))?);
                }
                if core.len() < softs.len() {
                    return Ok(learnt); // a level at its cap cannot be violated
                }
                levels.push(core);
            }
            let highest = levels.last().map_or(&[][..], Vec::as_slice);
            let before = search.allowed.budget.conflicts();
            if search.team.refute(highest)?.is_none() {
                return Ok(learnt);
            }
            let mut effort = CoreEffort {
                stated: softs.len(),
                literals: softs.len(),
                conflicts: search.allowed.budget.conflicts() - before,
            };
            // Lower levels exclude each other all the more.
            for (level, core) in (learnt + 1..).zip(&levels) {
                let limits: Vec<Soft> = softs.iter().map(|soft| soft.raised(level)).collect();
                self.pay(search, core, &limits, effort);
                effort.conflicts = 0;
            }
            learnt += step;
            step *= 2;
        }
        Ok(learnt)
    }

    /// Begins a new round: all that cores set free is bounded again.
    fn begin_phase(&mut self, search: &mut Search) -> Result<(), Stop> {
        for soft in std::mem::take(&mut self.waiting) {
            self.assume(search, soft)?;
        }
        let cores = std::mem::take(&mut self.cores);
        if !cores.is_empty() {
            search.tell_round(self.cost);
        }
        for core in cores {
            let total = self.total(search, &core);
            self.assume(search, total)?;
        }
        Ok(())
    }

    /// The bound is met: every plan that meets it keeps all assumptions, so
    /// they become clauses, and every other plan is of no interest any more.
    fn harden(&mut self, search: &mut Search) {
        if self.known {
            return; // the limit of the search says it all
        }
        search.keep_minima(self.cost);
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
                    caps[agent] = search.problem.time_of(agent, most);
                }
            }
            for (agent, cap) in caps.into_iter().enumerate() {
                search.lower_cap(agent, cap);
            }
        }
    }
}
