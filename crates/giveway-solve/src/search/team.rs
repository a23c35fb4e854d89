//! The agents, inside the SAT solver or outside of it.
//!
//! An agent without conflict stays outside: it keeps a fixed walk at its own
//! optimum, planned around the others after each model. Only when that fails
//! does it enter. So the formula speaks of the agents that get in each other's
//! way, and of no others.

mod others;

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::Cost;
use giveway_model::sorting::map;

use super::{
    minima::{LoneBound, Minima},
    tally::CostCounter,
};
use crate::{
    budget::{Budget, Stop},
    encode::{
        agent::{Added, MddEncoding},
        collisions::{AgentId, Collisions, Meeting},
        rules::RuleClauses,
    },
    local::{OtherAgents, Query, Reservations, plan_one},
    problem::Problem,
    sat::{Clauses, Core, Lit, Outcome, Sat},
    terrain::Vertex,
    walk::Walk,
};

/// All agents of a problem around one SAT solver.
pub(crate) struct Team<'p, 'h> {
    pub(crate) problem: &'p Problem,
    pub(crate) budget: Rc<Budget<'h>>,
    sat: Sat<'h>,
    collisions: Collisions,
    rules: RuleClauses,
    inside: Vec<Option<MddEncoding>>,
    /// A walk of every agent: from the last model, or fixed outside.
    pub(crate) walks: Vec<Walk>,
    /// The last time at which an agent may be at a vertex, or a rule begins to hold: agents
    /// whose rests are written on rest up to it.
    reach: u32,
    /// Under `stay`: whose goal a vertex is.
    owners: BTreeMap<Vertex, AgentId>,
    /// Positions of inside agents on goals, by goal.
    on_goals: BTreeMap<Vertex, Vec<(u32, AgentId, Lit)>>,
    /// "Not been there yet", by time, where a question asks who is first.
    not_yet: BTreeMap<(usize, u32), Lit>,
    /// "Never been there", likewise.
    never: BTreeMap<usize, Lit>,
    tallies: BTreeMap<(AgentId, Cost), CostCounter>,
    minima: Minima,
}

impl<'p, 'h> Team<'p, 'h> {
    /// A team with everyone outside, on walks at their own optima.
    pub(crate) fn new(problem: &'p Problem, walks: Vec<Walk>, budget: Rc<Budget<'h>>) -> Self {
        let goals = problem.tasks.iter().enumerate();
        Self {
            problem,
            sat: Sat::new(Rc::clone(&budget)),
            budget,
            collisions: Collisions::new(problem.relaxed.ignored.clone()),
            rules: RuleClauses::default(),
            inside: problem.tasks.iter().map(|_| None).collect(),
            walks,
            reach: problem.between.last_begin(),
            owners: map(goals.filter_map(|(agent, task)| Some((task.goal?, agent)))),
            on_goals: BTreeMap::new(),
            not_yet: BTreeMap::new(),
            never: BTreeMap::new(),
            tallies: BTreeMap::new(),
            minima: Minima::default(),
        }
    }

    /// A team whose agents may collide, and tell when they do.
    pub(crate) fn colliding(
        problem: &'p Problem,
        walks: Vec<Walk>,
        budget: Rc<Budget<'h>>,
    ) -> Self {
        Self {
            collisions: Collisions::soft(),
            // No goal is reserved.
            owners: BTreeMap::new(),
            ..Self::new(problem, walks, budget)
        }
    }

    /// The collisions that may happen in a team whose agents may collide.
    pub(crate) fn meetings(&self) -> impl Iterator<Item = (Meeting, Lit)> + '_ {
        self.collisions.meetings()
    }

    /// The literals "at a vertex at a time" of an inside agent.
    pub(crate) fn positions(
        &self,
        agent: AgentId,
    ) -> impl Iterator<Item = ((u32, Vertex), Lit)> + '_ {
        let code = self.inside[agent].iter();
        code.flat_map(MddEncoding::positions)
    }

    /// Whether a literal holds in the last model.
    pub(crate) fn is_true(&self, lit: Lit) -> bool {
        self.sat.is_true(lit)
    }

    pub(crate) fn is_inside(&self, agent: AgentId) -> bool {
        self.inside[agent].is_some()
    }

    /// The agents inside, in order.
    pub(crate) fn insiders(&self) -> Vec<AgentId> {
        (0..self.inside.len())
            .filter(|&a| self.is_inside(a))
            .collect()
    }

    /// The deadline that the clauses of an agent cover; its optimum outside.
    pub(crate) fn deadline(&self, agent: AgentId) -> u32 {
        let code = self.inside[agent].as_ref();
        let deadline = code.and_then(MddEncoding::deadline);
        deadline.unwrap_or(self.problem.optima[agent])
    }

    /// Takes an agent into the solver, with its plans up to its own optimum.
    pub(crate) fn enter(&mut self, agent: AgentId) -> Result<(), Stop> {
        if self.is_inside(agent) {
            return Ok(());
        }
        let problem = self.problem;
        self.inside[agent] = Some(MddEncoding::new(agent, problem));
        self.grow(agent, problem.optima[agent])?;
        if problem.rests(agent) {
            // An agent at its goal after its deadline blocks the goal for the others.
            let goal = problem.tasks[agent].goal;
            let visits = goal.and_then(|goal| self.on_goals.get(&goal));
            for (time, other, lit) in visits.cloned().unwrap_or_default() {
                if problem.collide(agent, other) {
                    self.keep_away(agent, time, lit);
                }
            }
        }
        Ok(())
    }

    /// Extends the clauses of an inside agent to a later deadline.
    pub(crate) fn grow(&mut self, agent: AgentId, deadline: u32) -> Result<(), Stop> {
        let problem = self.problem;
        let Some(code) = &mut self.inside[agent] else {
            return Ok(());
        };
        let old = code.mdd().size();
        let reach = self.reach;
        let added = code.grow(deadline, reach, problem, &self.budget, &mut self.sat)?;
        self.absorb(agent, &added)?;
        self.precede(agent, old, &added);
        let Some(code) = &self.inside[agent] else {
            return Ok(());
        };
        let task = &problem.tasks[agent];
        for cost in [Cost::Charges, Cost::Moves, Cost::Waits, Cost::Penalty] {
            if let Some(tally) = self.tallies.get_mut(&(agent, cost)) {
                tally.grow(problem, task, code, &added.steps, &mut self.sat);
            }
        }
        Ok(())
    }

    /// Puts an agent that is not inside in everyone's way.
    pub(crate) fn place(&mut self, agent: AgentId, added: &Added) -> Result<(), Stop> {
        self.absorb(agent, added)
    }

    /// The clauses of an inside agent.
    pub(crate) fn code(&self, agent: AgentId) -> Option<&MddEncoding> {
        self.inside[agent].as_ref()
    }

    /// The literal "arrived by" of an inside agent.
    pub(crate) fn by(&mut self, agent: AgentId, time: u32) -> Option<Lit> {
        let code = self.inside[agent].as_mut()?;
        code.by(time, &mut self.sat)
    }

    /// The literal "has more than `most`" charges, moves or waits, of an inside
    /// agent; `None` where that is certain.
    pub(crate) fn more_than(
        &mut self,
        agent: AgentId,
        cost: Cost,
        most: u32,
    ) -> Result<Option<Lit>, Stop> {
        let Some(code) = &self.inside[agent] else {
            return Ok(None);
        };
        if !self.tallies.contains_key(&(agent, cost)) {
            let mut tally = CostCounter::new(self.problem, agent, cost, &self.budget)?;
            let steps = code.taken_steps();
            let task = &self.problem.tasks[agent];
            tally.grow(self.problem, task, code, &steps, &mut self.sat);
            self.tallies.insert((agent, cost), tally);
        }
        let tally = self.tallies.get_mut(&(agent, cost));
        Ok(tally.and_then(|tally| tally.more_than(most, &mut self.sat)))
    }

    /// The least that an agent alone can have of a cost.
    pub(crate) fn least(&mut self, agent: AgentId, cost: Cost) -> Result<u32, Stop> {
        self.minima.of(self.problem, agent, cost, &self.budget)
    }

    /// The same, where it was asked before.
    pub(crate) fn known_least(&self, agent: AgentId, cost: Cost) -> u32 {
        self.minima.known(self.problem, agent, cost).unwrap_or(0)
    }

    /// The bound of a cost from the least that each agent needs alone.
    pub(crate) fn lone_bound(&mut self, cost: Cost) -> Result<LoneBound, Stop> {
        self.minima.bound(self.problem, cost, &self.budget)
    }

    /// Makes a literal hold for good.
    pub(crate) fn harden(&mut self, lit: Lit) {
        self.sat.clause(&[lit]);
    }

    /// The collector of clauses, for encodings over several agents.
    pub(crate) fn clauses(&mut self) -> &mut Sat<'h> {
        &mut self.sat
    }

    /// Solves under assumptions; a model becomes the walks of the inside agents.
    pub(crate) fn solve(&mut self, assumptions: &[Lit]) -> Result<Outcome, Stop> {
        self.budget.report_size();
        self.sat.solve(assumptions)
    }

    /// As [`Team::solve`], for the core alone; `None` where there is a model.
    pub(crate) fn refute(&mut self, assumptions: &[Lit]) -> Result<Option<Core>, Stop> {
        self.budget.report_size();
        self.sat.refute(assumptions)
    }

    /// The literals of the last core before it was verified and made smaller.
    pub(crate) const fn stated(&self) -> usize {
        self.sat.stated()
    }

    /// Makes the core of the last call smaller, where that is cheap.
    pub(crate) fn minimise(&mut self, core: Core) -> Result<Core, Stop> {
        self.sat.minimise(core)
    }

    /// Reads the walks of the inside agents from the last model.
    pub(crate) fn read(&mut self) {
        for (agent, code) in self.inside.iter().enumerate() {
            if let Some(code) = code {
                let task = &self.problem.tasks[agent];
                self.walks[agent] = code.walk(task, |lit| self.sat.is_true(lit));
            }
        }
    }

    /// Plans outside agents around everyone else, and returns those that still
    /// collide, each with whom it meets: they must enter.
    pub(crate) fn collide(&mut self) -> Result<BTreeMap<AgentId, BTreeSet<AgentId>>, Stop> {
        let mut all = Reservations::of(self.problem, &self.walks);
        for agent in 0..self.walks.len() {
            if self.is_inside(agent) || all.met_by(agent, &self.walks[agent]).is_empty() {
                continue;
            }
            all.remove(agent, &self.walks[agent]);
            let query = Query {
                agent,
                latest: self.problem.optima[agent],
                conflict_penalty: Some(1),
                expansion_limit: u32::MAX,
            };
            if let Some((walk, _)) = plan_one(self.problem, &all, query, &self.budget)? {
                self.walks[agent] = walk;
            }
            all.add(agent, &self.walks[agent]);
        }
        let outside = (0..self.walks.len()).filter(|&agent| !self.is_inside(agent));
        let met = outside.map(|agent| (agent, all.met_by(agent, &self.walks[agent])));
        Ok(map(met.filter(|(_, met)| !met.is_empty())))
    }
}
