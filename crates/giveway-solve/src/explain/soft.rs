//! A plan that breaks as few rules of one class as can be, all others kept.
//!
//! Every agent is inside the solver; what may be broken has a literal each. At
//! one deadline after the other the number of broken rules is lowered until it
//! cannot be lower; then the deadline, then the sum of costs, and of what is
//! left the earliest breaches, so that the same question has one answer.

use std::rc::Rc;

use giveway_model::{Instance, Plan, check::Rule};

use crate::{
    budget::{Budget, Stop},
    encode::{
        collisions::AgentId,
        totalizer::{capped, totalizer},
    },
    local::apart,
    problem::Problem,
    sat::{Clauses, Lit, Outcome},
    search::{Horizon, Team},
    walk::{Walk, arrival, to_plan},
};
use giveway_model::sorting::sort;

/// The most broken rules that are counted: more explain nothing.
const MOST_BROKEN: usize = 12;

/// A plan that breaks rules of one class only.
pub(crate) struct Broken {
    pub(crate) plan: Plan,
    /// How many rules it breaks.
    pub(crate) count: usize,
    /// Whether no plan breaks fewer.
    pub(crate) fewest: bool,
}

/// A rule that may be broken: time, vertex, agents, and its literal.
type Breach = ((u32, u32, AgentId, AgentId), Lit);

/// The plan with the fewest collisions; `None` where even that does not help
/// or none was found.
pub(crate) fn collisions(
    instance: &Instance,
    within: Option<u32>,
    at_least_within: u32,
    budget: &Rc<Budget>,
) -> Option<Broken> {
    let problem = Problem::new(instance, budget).ok()?;
    let horizon = horizon(instance, &problem, within, at_least_within);
    let walks = apart(&problem, budget).ok()?;
    let team = Team::colliding(&problem, walks, Rc::clone(budget));
    let breaches = |team: &Team, _: &Problem| {
        let meetings = team.meetings();
        let name = |m: crate::encode::collisions::Meeting| (m.time, m.place, m.pair.0, m.pair.1);
        meetings.map(|(m, lit)| (name(m), lit)).collect()
    };
    let rules = [Rule::Vertex, Rule::Swap, Rule::SlowSwap];
    SoftRules::new(&problem, team, &breaches, horizon, instance, &rules).run()
}

/// The plan with the fewest steps in obstacles; `None` as for collisions.
pub(crate) fn obstacles(
    instance: &Instance,
    within: Option<u32>,
    at_least_within: u32,
    budget: &Rc<Budget>,
) -> Option<Broken> {
    let mut open = instance.clone();
    open.remove_obstacles(|_| true);
    let problem = Problem::new(&open, budget).ok()?;
    let horizon = horizon(&open, &problem, within, at_least_within);
    let walks = vec![Walk::new(); problem.agents()];
    let team = Team::new(&problem, walks, Rc::clone(budget));
    let breaches = |team: &Team, problem: &Problem| {
        let mut breaches = Vec::new();
        for agent in 0..problem.agents() {
            let hits = team.positions(agent).filter(|&((_, v), _)| {
                let cell = problem.terrain.cell(v);
                !instance.grid().is_vertex(cell)
            });
            breaches.extend(hits.map(|((time, v), lit)| ((time, v, agent, agent), lit)));
        }
        breaches
    };
    SoftRules::new(
        &problem,
        team,
        &breaches,
        horizon,
        instance,
        &[Rule::Obstacle],
    )
    .run()
}

fn horizon(
    instance: &Instance,
    problem: &Problem,
    within: Option<u32>,
    at_least_within: u32,
) -> u32 {
    Horizon::of(problem, instance.grid(), within, at_least_within).latest()
}

type Breaches<'a> = &'a dyn Fn(&Team, &Problem) -> Vec<Breach>;

struct SoftRules<'a, 'p, 'h> {
    problem: &'p Problem,
    team: Team<'p, 'h>,
    breaches: Breaches<'a>,
    horizon: u32,
    instance: &'a Instance,
    rules: &'a [Rule],
    /// The best so far: its number of breaches, makespan, sum of costs, walks.
    best: Option<(usize, u32, u32, Vec<Walk>)>,
}

impl<'a, 'p, 'h> SoftRules<'a, 'p, 'h> {
    fn new(
        problem: &'p Problem,
        team: Team<'p, 'h>,
        breaches: Breaches<'a>,
        horizon: u32,
        instance: &'a Instance,
        rules: &'a [Rule],
    ) -> Self {
        Self {
            problem,
            team,
            breaches,
            horizon,
            instance,
            rules,
            best: None,
        }
    }

    fn run(mut self) -> Option<Broken> {
        let first = self.problem.optima.iter().copied().max().unwrap_or(0);
        if first > self.horizon {
            return None;
        }
        let fewest = self.lower_all(first).is_ok();
        let (count, .., walks) = self.best.as_ref()?;
        let plan = self.plan(walks);
        Some(Broken {
            plan,
            count: *count,
            fewest,
        })
    }

    fn plan(&self, walks: &[Walk]) -> Plan {
        let agents = self.instance.agents().iter();
        let names: Vec<String> = agents.map(|a| a.name.clone()).collect();
        to_plan(self.problem, &names, walks)
    }

    /// Lowers one thing after the other; an error leaves the best so far.
    fn lower_all(&mut self, first: u32) -> Result<(), Stop> {
        for agent in 0..self.problem.agents() {
            self.team.enter(agent)?;
        }
        // Deadlines with twice the delay each time.
        let (mut before, mut deadline) = (None, first);
        let mut sooner = None;
        loop {
            let found = self.best.as_ref().map(|best| best.0);
            self.lower_count(deadline)?;
            let now = self.best.as_ref().map(|best| best.0);
            if now != found {
                sooner = before;
            }
            if now == Some(1) || deadline == self.horizon {
                break;
            }
            before = Some(deadline);
            let delay = (deadline - first).max(1);
            deadline = (deadline + delay).min(self.horizon);
        }
        let Some((count, latest, ..)) = self.best else {
            return Ok(());
        };
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, count + 1, self.team.clauses());
        let mut fixed: Vec<Lit> = counted.get(count).map(|&more| !more).into_iter().collect();
        self.lower_deadline(sooner.map_or(first, |d| d + 1), latest, &fixed)?;
        let Some((_, latest, ..)) = self.best else {
            return Ok(());
        };
        fixed.extend(self.deadlines(latest));
        self.lower_sum(latest, &mut fixed)?;
        self.order_breaches(breaches, fixed)
    }

    /// All agents arrive by a time.
    fn deadlines(&mut self, time: u32) -> Vec<Lit> {
        let agents = 0..self.problem.agents();
        let by = |agent| self.team.by(agent, time);
        agents.filter_map(by).collect()
    }

    /// The fewest breaches at a deadline.
    fn lower_count(&mut self, deadline: u32) -> Result<(), Stop> {
        for agent in 0..self.problem.agents() {
            self.team.grow(agent, deadline)?;
        }
        let most = self.best.as_ref().map_or(MOST_BROKEN, |best| best.0 - 1);
        let breaches = (self.breaches)(&self.team, self.problem);
        let lits: Vec<Lit> = breaches.iter().map(|&(_, lit)| lit).collect();
        let counted = capped(&lits, most + 1, self.team.clauses());
        let by = self.deadlines(deadline);
        let mut most = Some(most);
        while let Some(k) = most.filter(|&k| k > 0) {
            let mut assumptions = by.clone();
            assumptions.extend(counted.get(k).map(|&more| !more));
            let Some(found) = self.model(&assumptions)? else {
                break;
            };
            most = found.checked_sub(1);
        }
        Ok(())
    }

    /// Solves; keeps a model that is better, and tells its number of breaches.
    fn model(&mut self, assumptions: &[Lit]) -> Result<Option<usize>, Stop> {
        if let Outcome::Unsat(_) = self.team.solve(assumptions)? {
            return Ok(None);
        }
        self.team.read();
        let walks = self.team.walks.clone();
        let plan = self.plan(&walks);
        let violations = giveway_model::check::check(self.instance, &plan).violations;
        if violations.iter().any(|v| !self.rules.contains(&v.rule)) {
            return Err(Stop::Contradiction);
        }
        let count = violations.len();
        let arrivals = walks.iter().map(|walk| arrival(walk));
        let (makespan, sum) = (arrivals.clone().max().unwrap_or(0), arrivals.sum());
        let better = self
            .best
            .as_ref()
            .is_none_or(|&(c, m, s, _)| (count, makespan, sum) < (c, m, s));
        if better {
            self.best = Some((count, makespan, sum, walks));
        }
        Ok(Some(count))
    }

    /// The earliest deadline for the fewest breaches.
    fn lower_deadline(&mut self, from: u32, latest: u32, fixed: &[Lit]) -> Result<(), Stop> {
        for deadline in from..latest {
            let mut assumptions = self.deadlines(deadline);
            assumptions.extend(fixed);
            if self.model(&assumptions)?.is_some() {
                return Ok(());
            }
        }
        Ok(())
    }

    /// The least sum of costs with the fewest breaches by a deadline.
    fn lower_sum(&mut self, latest: u32, fixed: &mut Vec<Lit>) -> Result<(), Stop> {
        let mut delays = Vec::new();
        for agent in 0..self.problem.agents() {
            for time in self.problem.optima[agent]..latest {
                delays.extend(self.team.by(agent, time).map(|by| !by));
            }
        }
        let least: u32 = self.problem.optima.iter().sum();
        let outputs = totalizer(&delays, self.team.clauses());
        loop {
            let Some(&(_, _, sum, _)) = self.best.as_ref() else {
                return Ok(());
            };
            let delay = (sum - least) as usize;
            let fewer = delay.checked_sub(1).and_then(|d| outputs.get(d));
            let mut assumptions = fixed.clone();
            assumptions.extend(fewer.map(|&more| !more));
            if fewer.is_none() || self.model(&assumptions)?.is_none() {
                fixed.extend(outputs.get(delay).map(|&more| !more));
                return Ok(());
            }
        }
    }

    /// Of all that is equally good, that with the earliest breaches.
    fn order_breaches(
        &mut self,
        mut breaches: Vec<Breach>,
        mut fixed: Vec<Lit>,
    ) -> Result<(), Stop> {
        sort(&mut breaches);
        let Some(count) = self.best.as_ref().map(|best| best.0) else {
            return Ok(());
        };
        if matches!(self.team.solve(&fixed)?, Outcome::Unsat(_)) {
            return Err(Stop::Contradiction);
        }
        let mut from = 0;
        for _ in 0..count {
            let holds = |team: &Team, from: usize| {
                let mut rest = breaches.iter().enumerate().skip(from);
                rest.find(|(_, (_, lit))| team.is_true(*lit))
                    .map(|(i, _)| i)
            };
            let Some(mut first) = holds(&self.team, from) else {
                break;
            };
            self.keep_model();
            while first > from {
                let sooner = self.team.clauses().fresh();
                let mut clause = vec![!sooner];
                clause.extend(breaches[from..first].iter().map(|&(_, lit)| lit));
                self.team.clauses().clause(&clause);
                let mut assumptions = fixed.clone();
                assumptions.push(sooner);
                if matches!(self.team.solve(&assumptions)?, Outcome::Unsat(_)) {
                    break;
                }
                let Some(found) = holds(&self.team, from) else {
                    break;
                };
                first = found;
                self.keep_model();
            }
            fixed.push(breaches[first].1);
            from = first + 1;
            if matches!(self.team.solve(&fixed)?, Outcome::Unsat(_)) {
                return Err(Stop::Contradiction);
            }
        }
        self.keep_model();
        Ok(())
    }

    /// Takes over the last model, which is as good as the best.
    fn keep_model(&mut self) {
        self.team.read();
        let walks = self.team.walks.clone();
        let plan = self.plan(&walks);
        let violations = giveway_model::check::check(self.instance, &plan).violations;
        let judged = violations.iter().all(|v| self.rules.contains(&v.rule));
        if let Some(best) = &mut self.best
            && judged
            && violations.len() <= best.0
        {
            best.3 = walks;
        }
    }
}
