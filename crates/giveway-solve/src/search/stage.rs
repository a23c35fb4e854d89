//! What the stages of a lexicographic search share.
//!
//! A stage minimises one cost of the objective around one [`Team`]. When it is
//! done, what it proved is made to hold for good, and the next stage goes on in
//! the same formula: a lexicographic optimum is an optimum of the last cost
//! among the optima of all before it.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, sorting};

use super::{
    deadlines::{Deadlines, Keeping},
    horizon::Horizon,
    incumbent::Incumbent,
    lexicographic::Bounded,
    team::Team,
};
use crate::{
    budget::{Budget, Stop},
    encode::{collisions::AgentId, limit::SumLimit},
    local::Lns,
    problem::Problem,
    progress::Progress,
    sat::Lit,
    single::TaskConstraint,
    walk::Walk,
};

/// Clauses that the SAT solver derives before the best plan is improved for the
/// first time: what is proved sooner needs no better plan.
const FIRST_POLISH: u64 = 1000;
/// Neighbourhoods tried each time.
const POLISH_ROUNDS: usize = 30;

/// How a stage ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// The least value of its cost.
    Least(u32),
    /// No plan keeps within the horizon and the limits.
    None,
}

/// A lexicographic search under way.
pub(crate) struct Search<'p, 'h, 'b> {
    pub(crate) problem: &'p Problem,
    pub(crate) budget: Rc<Budget<'h>>,
    pub(crate) team: Team<'p, 'h>,
    pub(crate) incumbent: &'p mut Incumbent<'b>,
    /// The latest arrivals that are still of interest.
    pub(super) deadlines: Deadlines,
    limits: BTreeMap<Cost, SumLimit>,
    /// The costs whose optimum holds for good.
    done: BTreeMap<Cost, u32>,
    lns: Lns,
    /// Whether cores are made smaller.
    pub(super) minimises: bool,
    /// Derived clauses from which on the best plan is to be improved again.
    polish_at: u64,
    /// Counts of which agents that enter have their own minima.
    at_minima: Vec<Cost>,
    /// The costs done or under way: outside agents are at their own minima.
    begun: Vec<Cost>,
}

impl<'p, 'h, 'b> Search<'p, 'h, 'b> {
    pub(crate) fn new(
        problem: &'p Problem,
        walks: Vec<Walk>,
        bounded: &Bounded,
        keeping: Keeping,
        incumbent: &'p mut Incumbent<'b>,
        budget: Rc<Budget<'h>>,
    ) -> Self {
        let makespan = bounded.limits.get(&Cost::Makespan).copied();
        Self {
            problem,
            team: Team::new(problem, walks, Rc::clone(&budget)),
            budget,
            incumbent,
            deadlines: Deadlines::new(problem, bounded.horizon, makespan, keeping),
            limits: BTreeMap::new(),
            done: BTreeMap::new(),
            at_minima: Vec::new(),
            begun: Vec::new(),
            lns: Lns::new(),
            minimises: false,
            polish_at: FIRST_POLISH,
        }
    }

    /// Improves the best plan, now and then: as the proof gets longer by a
    /// part of it, so that both get their share of the time.
    pub(crate) fn polish(&mut self, cost: Cost, bound: u32) -> Result<(), Stop> {
        let derived = self.budget.derived();
        if derived < self.polish_at {
            return Ok(());
        }
        let Some(walks) = self.incumbent.walks() else {
            return Ok(());
        };
        let improved = self.improve(walks.to_vec());
        // Where nothing is gained, or little is left to gain, less often.
        let best = self.incumbent.costs().map_or(0, |costs| costs.get(cost));
        let wide = best > bound + bound / 20;
        let pause = match (improved?, wide) {
            (_, true) => derived / 16,
            (true, false) => derived / 4,
            (false, false) => derived,
        };
        self.polish_at = derived + pause;
        Ok(())
    }

    /// Improves a plan for some time, and keeps it if it is the best; whether
    /// it became better.
    pub(crate) fn improve(&mut self, mut walks: Vec<Walk>) -> Result<bool, Stop> {
        let latest = self.deadlines.last_cap();
        let objective = self.incumbent.objective().clone();
        let improved = self.lns.improve(
            self.problem,
            &mut walks,
            latest,
            &objective,
            POLISH_ROUNDS,
            &self.budget,
        );
        self.incumbent.offer(self.problem, &walks);
        improved
    }

    /// The latest arrival of an agent that is still of interest.
    pub(crate) fn cap(&self, agent: AgentId) -> u32 {
        self.deadlines.cap(agent)
    }

    /// The latest arrival of any agent.
    pub(crate) const fn latest(&self) -> u32 {
        self.deadlines.latest()
    }

    /// Allows no plan in which an agent arrives later.
    pub(crate) fn lower_cap(&mut self, agent: AgentId, cap: u32) {
        if self.deadlines.lower(agent, cap) {
            self.harden_cap(agent);
        }
    }

    /// Makes the cap a clause, once the MDD reaches it.
    fn harden_cap(&mut self, agent: AgentId) {
        if self.team.is_inside(agent)
            && let Some(cap) = self.deadlines.harden(agent, self.team.deadline(agent))
            && let Some(by) = self.team.by(agent, cap)
        {
            self.team.harden(by);
        }
    }

    /// Lets an inside agent arrive up to a time, or up to its cap.
    pub(crate) fn grow(&mut self, agent: AgentId, deadline: u32) -> Result<(), Stop> {
        self.team.grow(agent, deadline.min(self.cap(agent)))?;
        self.harden_cap(agent);
        Ok(())
    }

    /// Doubles the delay that an agent may have, up to a latest arrival; false
    /// where it may arrive so late already.
    pub(crate) fn grow_further(&mut self, agent: AgentId, latest: u32) -> Result<bool, Stop> {
        let covered = self.team.deadline(agent);
        let optimum = self.problem.optima[agent];
        let Some(next) = self.deadlines.next(agent, covered, optimum, latest) else {
            return Ok(false);
        };
        self.grow(agent, next)?;
        Ok(true)
    }

    /// Takes an agent inside, with all that holds for good.
    pub(crate) fn enter(&mut self, agent: AgentId) -> Result<(), Stop> {
        if self.team.is_inside(agent) {
            return Ok(());
        }
        self.team.enter(agent)?;
        self.harden_cap(agent);
        if let Some(TaskConstraint::AtMost { cost, most }) = self.problem.tasks[agent].demand {
            // No agent is asked for less than it could have alone.
            if let Some(more) = self.team.more_than(agent, cost, most)? {
                self.team.harden(!more);
            }
        }
        let costs: Vec<Cost> = self.limits.keys().copied().collect();
        for cost in costs {
            let digits = self.digits(agent, cost)?;
            if let Some(limit) = self.limits.get_mut(&cost) {
                limit.add(&digits, self.team.clauses());
            }
        }
        for cost in self.at_minima.clone() {
            let least = self.team.least(agent, cost)?;
            if let Some(more) = self.team.more_than(agent, cost, least)? {
                self.team.harden(!more);
            }
        }
        Ok(())
    }

    /// Takes those inside whom a question asks for what only the SAT solver can
    /// keep.
    pub(crate) fn enter_insiders(&mut self) -> Result<(), Stop> {
        for agent in self.problem.insiders() {
            self.enter(agent)?;
        }
        Ok(())
    }

    /// Reads the model and plans the outside agents around it; the agents that
    /// had to enter, none where the walks are a plan.
    pub(crate) fn settle(&mut self) -> Result<Vec<AgentId>, Stop> {
        self.team.read();
        let mut entering = self.team.collide()?;
        for &cost in &self.begun.clone() {
            for agent in self.above_minimum(cost)? {
                if !entering.contains(&agent) {
                    entering.push(agent);
                }
            }
        }
        for &agent in &entering {
            self.enter(agent)?;
        }
        if entering.is_empty() {
            let walks = self.team.walks.clone();
            self.incumbent.offer(self.problem, &walks);
        }
        Ok(entering)
    }

    /// Outside agents whose walks cost more than their own minimum.
    pub(crate) fn above_minimum(&mut self, cost: Cost) -> Result<Vec<AgentId>, Stop> {
        let mut above = Vec::new();
        if !matches!(cost, Cost::Charges | Cost::Moves | Cost::Waits) {
            return Ok(above);
        }
        for agent in 0..self.problem.agents() {
            if !self.team.is_inside(agent) {
                let least = self.team.least(agent, cost)?;
                let walk = std::slice::from_ref(&self.team.walks[agent]);
                if crate::walk::costs_of(self.problem, agent, &walk[0]).get(cost) > least {
                    above.push(agent);
                }
            }
        }
        Ok(above)
    }

    /// The sum of what each agent alone needs at the least.
    pub(crate) fn sum_of_minima(&mut self, cost: Cost) -> Result<u32, Stop> {
        let mut sum = 0;
        for agent in 0..self.problem.agents() {
            sum += match cost {
                Cost::Makespan => 0,
                Cost::SumOfCosts => self.problem.least_cost(agent),
                _ => self.team.least(agent, cost)?,
            };
        }
        Ok(sum)
    }

    /// Allows no plan whose sum of a cost is above `most`; false where the sum
    /// of the agents' own minima is above it already.
    pub(crate) fn limit(&mut self, cost: Cost, most: u32) -> Result<bool, Stop> {
        let least = self.sum_of_minima(cost)?;
        let Some(spare) = most.checked_sub(least) else {
            return Ok(false);
        };
        self.limits.insert(cost, SumLimit::new(spare as usize));
        if cost == Cost::SumOfCosts {
            for agent in 0..self.problem.agents() {
                let most = self.problem.least_cost(agent).saturating_add(spare);
                self.lower_cap(agent, self.problem.time_of(agent, most));
            }
        } else {
            self.begun.push(cost);
        }
        Ok(true)
    }

    /// What an agent costs beyond its minimum, in unary, as far as the limit
    /// needs it.
    fn digits(&mut self, agent: AgentId, cost: Cost) -> Result<Vec<Lit>, Stop> {
        let most = self.limits.get(&cost).map_or(0, SumLimit::most) as u32;
        let mut digits = Vec::new();
        for more in 0..=most {
            let digit = match cost {
                Cost::Makespan => None,
                Cost::SumOfCosts => {
                    let cost = self.problem.least_cost(agent) + more;
                    let time = self.problem.time_of(agent, cost);
                    self.team.by(agent, time).map(|by| !by)
                }
                _ => {
                    let least = self.team.least(agent, cost)?;
                    self.team.more_than(agent, cost, least + more)?
                }
            };
            digits.extend(digit);
        }
        Ok(digits)
    }

    /// Marks a cost as under way.
    pub(crate) fn begin(&mut self, cost: Cost) {
        if !self.begun.contains(&cost) {
            self.begun.push(cost);
        }
    }

    /// The same search after its first stage, the makespan, with an empty
    /// formula: the later stages need much smaller MDDs than the proof of
    /// the makespan did.
    pub(crate) fn afresh(self, makespan: u32, walks: Vec<Walk>) -> Self {
        let bounded = Bounded {
            horizon: Horizon::at(makespan),
            limits: sorting::map([(Cost::Makespan, makespan)]),
        };
        let mut fresh = Self::new(
            self.problem,
            walks,
            &bounded,
            Keeping::Hard,
            self.incumbent,
            self.budget,
        );
        fresh.minimises = self.minimises;
        fresh.lns = self.lns;
        fresh.finish(Cost::Makespan, makespan);
        fresh.begin(Cost::Makespan);
        fresh
    }

    /// Marks the optimum of a cost as holding for good.
    pub(crate) fn finish(&mut self, cost: Cost, least: u32) {
        self.done.insert(cost, least);
    }

    /// In every plan with the optimum of a count, proved by cores, the agents
    /// that no core named are at their own minima: so are those that enter
    /// later. (An optimum that is known in another way says nothing of them.)
    pub(crate) fn keep_minima(&mut self, cost: Cost) {
        if cost != Cost::SumOfCosts {
            self.at_minima.push(cost);
        }
    }

    /// Whether the best plan has this value of a cost, and the optimum of each
    /// cost before it.
    pub(crate) fn incumbent_meets(&self, cost: Cost, value: u32) -> bool {
        self.incumbent.costs().is_some_and(|costs| {
            costs.get(cost) == value && self.done.iter().all(|(&c, &least)| costs.get(c) == least)
        })
    }

    /// The best plan's value of a cost, if it has the optimum of each cost
    /// before it.
    pub(crate) fn best(&self, cost: Cost) -> Option<u32> {
        let best = self.incumbent.costs()?.get(cost);
        self.incumbent_meets(cost, best).then_some(best)
    }

    /// Tells the host a proved bound.
    pub(crate) fn report_bound(&self, cost: Cost, at_least: u32) {
        self.budget.report(&Progress::Bound { cost, at_least });
    }
}
