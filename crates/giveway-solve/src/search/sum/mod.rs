//! The least sum of a cost over all agents, by unsatisfiable cores.
//!
//! By core-guided search ([`oll`](super::oll)): what is assumed of each agent is that it
//! has the least cost that it could have, and the deadlines of MDDs are guarded by that;
//! so only agents that a core names ever get larger MDDs.
//!
//! A core that comes again with the next levels of the same agents is *stretched*: two
//! agents that meet in a corridor are a core for as many levels as the corridor is long,
//! and all of these are learnt at once. A small core is *exhausted*
//! ([`core_exhaustion`]): its agents are looked at by themselves until they hold
//! together. What the best plan so far excludes is made clauses ([`hardening`]); better
//! plans come out of models ([`upper_bound`]).

mod core_exhaustion;
mod hardening;
mod last_phase;
mod lineage;
mod soft;
mod upper_bound;

use std::collections::BTreeMap;

use giveway_model::Cost;

use super::{
    bound::Bound,
    for_ever::LeastForEver,
    growing::{CoreEffort, Growing, Until},
    oll::Oll,
    stage::{End, Search},
};
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    sat::{Core, Lit},
};
use lineage::Lineage;
use soft::{AtMost, Soft};

/// The state of one core-guided stage.
pub(super) struct SumStage<'b> {
    cost: Cost,
    /// What each level of a soft costs: penalties are multiples of it.
    unit: u32,
    bound: &'b mut Bound,
    known: bool,
    /// No further cost is minimised: nothing is of interest but a better plan.
    last: bool,
    /// No agent has a battery. Where one has, calls that end with a model take
    /// so long that smaller cores cost more than they save, as measured.
    light: bool,
    oll: Oll<AtMost>,
    /// How often some agents have been a core.
    seen: BTreeMap<Vec<AgentId>, u32>,
    /// The best plan's cost and the bound of when levels were last excluded.
    hardened: Option<(u32, u32)>,
    /// The earlier cores that each core builds on.
    lineage: Lineage,
}

impl<'b> SumStage<'b> {
    /// Minimises the sum of the bound's cost. Where its optimum is `known`, and a limit
    /// of the search, a plan is all that is looked for. Where the cost is the
    /// `last` one, the search is of no use afterwards.
    ///
    /// # Errors
    /// When the budget is spent. `bound` holds what was proved up to then.
    pub(super) fn run(
        search: &mut Search,
        bound: &'b mut Bound,
        known: Option<LeastForEver>,
        last: bool,
    ) -> Result<End, Stop> {
        if let Some(known) = known {
            bound.take_known(known);
        }
        let cost = bound.cost();
        let round_core = search.budget.thresholds().round_core;
        let mut stage = Self {
            cost,
            unit: match cost {
                Cost::Penalty => search.problem.penalty_unit(),
                _ => 1,
            },
            bound,
            known: known.is_some(),
            last,
            light: search.problem.tasks.iter().all(|t| t.reserve.is_none()),
            oll: Oll::new(),
            seen: BTreeMap::new(),
            hardened: None,
            lineage: Lineage::default(),
        };
        search.report_bound(*stage.bound);
        search.claim.begin(cost, stage.light);
        search.tell_phase(cost)?;
        let above = search.above_minimum(cost)?;
        for &agent in &above {
            search.enter(agent)?;
        }
        search.tell_entered(&above, &BTreeMap::new());
        for agent in search.team.insiders() {
            stage.adopt(search, agent)?;
        }
        loop {
            if let Some(optimum) = stage.bound.met(search) {
                if stage.bound.is_counted() {
                    // The formula does not know why, so it is told.
                    if !last {
                        search.limit_from_now(optimum)?;
                    }
                    return Ok(End::Least(optimum));
                }
                stage.begin_phase(search)?;
                stage.harden(search);
                return Ok(End::Least(optimum));
            }
            stage.harden_by_gap(search);
            if let Some(end) = stage.close(search)? {
                return Ok(end);
            }
            // The deadlines of a sum of costs guard the MDDs themselves.
            let until = match cost {
                Cost::SumOfCosts => Until::Guarded,
                _ => Until::EVER,
            };
            // Without batteries what many agents share is settled before what only one
            // of them does: measured, that gives smaller cores and fewer conflicts.
            let assumptions = stage.oll.assumptions(stage.light);
            match search.solve_growing(assumptions, until)? {
                Growing::Model if stage.oll.is_waiting() => {
                    stage.improve_upper_bound(search)?;
                    stage.begin_phase(search)?;
                }
                Growing::Model => {
                    let entered = search.settle()?;
                    if entered.is_empty() && stage.bound.met(search).is_none() {
                        return Err(Stop::Contradiction);
                    }
                    for agent in entered {
                        stage.adopt(search, agent)?;
                    }
                }
                Growing::Grown(literals) => {
                    search.polish(cost, stage.bound.at_least())?;
                    if literals > round_core {
                        stage.begin_phase(search)?;
                    }
                }
                Growing::Core(core) => {
                    let effort = core.effort();
                    let core = core.lits();
                    if core.is_empty() {
                        let Some(best) = stage.excluded() else {
                            return Ok(End::None);
                        };
                        search.tell_closed(cost, (stage.bound.at_least(), best), effort);
                        stage.bound.raise_to(best, core);
                        return stage.met(search);
                    }
                    stage.add_core(search, core, effort)?;
                    search.polish(cost, stage.bound.at_least())?;
                    if core.len() > round_core {
                        stage.begin_phase(search)?;
                    }
                }
            }
        }
    }

    /// The end of a stage whose bound the best plan meets.
    fn met(&self, search: &Search) -> Result<End, Stop> {
        let optimum = self.bound.met(search);
        optimum.map(End::Least).ok_or(Stop::Contradiction)
    }

    /// The best plan's cost, where plans that are not better are excluded.
    fn excluded(&self) -> Option<u32> {
        self.hardened.filter(|_| self.last).map(|(best, _)| best)
    }

    /// Assumes that an agent inside has the least cost it can have alone.
    fn adopt(&mut self, search: &mut Search, agent: AgentId) -> Result<(), Stop> {
        if self.known {
            return Ok(());
        }
        let least = search.team.least(agent, self.cost)?;
        let cost = self.cost;
        let most = least;
        self.oll.assume(
            search,
            Soft::Level(AtMost {
                agent,
                cost,
                most,
                unit: self.unit,
            }),
        )
    }

    /// Takes a core in: raises the bound.
    fn add_core(
        &mut self,
        search: &mut Search,
        core: &Core,
        effort: CoreEffort,
    ) -> Result<(), Stop> {
        if self.known {
            return Err(Stop::Contradiction);
        }
        let softs = self.oll.take(core);
        let first = self.oll.uncounted.len();
        self.raise_lower_bound(search, (core, core), &softs, effort);
        let further = self.stretch(search, &softs)?;
        let raised = softs.iter().filter_map(|soft| soft.raised(further + 1));
        let softs = self.exhaust_core(search, raised.collect(), first)?;
        self.oll.waiting.extend(softs);
        Ok(())
    }

    /// Raises the bound by a core, which says that these limits cannot all be kept: it
    /// was refuted, or another that it follows from.
    fn raise_lower_bound(
        &mut self,
        search: &mut Search,
        (core, shown): (&[Lit], &Core),
        limits: &[Soft],
        effort: CoreEffort,
    ) {
        self.bound.raise_by(self.unit, shown);
        search.report_bound(*self.bound);
        self.tell_core(search, limits, effort);
        let violations = core.iter().map(|&lit| !lit).collect();
        self.oll.record_core(search, violations);
    }

    /// Begins a new round: all that cores set free is bounded again.
    fn begin_phase(&mut self, search: &mut Search) -> Result<(), Stop> {
        if self.oll.begin_round(search)? {
            search.tell_round(self.cost);
        }
        Ok(())
    }

    /// The bound is met: every plan that meets it keeps all assumptions, so
    /// they become clauses, and every other plan is of no interest any more.
    fn harden(&mut self, search: &mut Search) {
        if self.known {
            return; // the limit of the search says it all
        }
        search.claim.keep_inside(self.cost);
        if self.cost != Cost::SumOfCosts {
            self.oll.harden(search);
            return;
        }
        let mut caps = search.problem.optima.clone();
        for agent in search.team.insiders() {
            caps[agent] = search.cap(agent);
        }
        for (&lit, &soft) in &self.oll.assumed {
            match soft {
                Soft::Level(AtMost { agent, most, .. }) => {
                    caps[agent] = search.problem.time_of(agent, most);
                }
                Soft::Total { .. } => search.team.harden(lit),
            }
        }
        for (agent, cap) in caps.into_iter().enumerate() {
            search.lower_cap(agent, cap);
        }
    }
}

/// The agent whose cost a soft bounds, if it is one alone.
fn agent_of(soft: &Soft) -> Option<AgentId> {
    soft.level().map(|level| level.agent)
}
