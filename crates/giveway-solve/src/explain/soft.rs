//! A plan that breaks as few rules of one class as can be, all others kept.
//!
//! Every agent is inside the solver; what may be broken has a literal each. At
//! one deadline after the other the number of broken rules is lowered until it
//! cannot be lower; then the deadline, then the sum of costs, and of what is
//! left the earliest breaches, so that the same question has one answer.

mod lower;
mod order;

use std::rc::Rc;

use giveway_model::{Instance, Plan, check::Rule};

use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    local::apart,
    problem::Problem,
    sat::{Lit, Outcome},
    search::{Horizon, Team},
    walk::{Walk, arrival, to_plan},
};

/// A plan that breaks rules of one class only.
pub(crate) struct RelaxedPlan {
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
) -> Option<RelaxedPlan> {
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
) -> Option<RelaxedPlan> {
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
    /// The best plan so far.
    best: Option<(Lowered, Vec<Walk>)>,
}

/// The counts that are lowered, one after the other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Lowered {
    /// How many rules are broken.
    count: usize,
    makespan: u32,
    sum: u32,
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

    fn run(mut self) -> Option<RelaxedPlan> {
        let first = self.problem.optima.iter().copied().max().unwrap_or(0);
        if first > self.horizon {
            return None;
        }
        let fewest = self.lower_all(first).is_ok();
        let (Lowered { count, .. }, walks) = self.best.as_ref()?;
        Some(RelaxedPlan {
            plan: self.plan(walks),
            count: *count,
            fewest,
        })
    }

    fn plan(&self, walks: &[Walk]) -> Plan {
        let agents = self.instance.agents().iter();
        let names: Vec<String> = agents.map(|a| a.name.clone()).collect();
        to_plan(self.problem, &names, walks)
    }

    /// Solves; keeps a model that is better, and tells what it has of what is lowered.
    fn model(&mut self, assumptions: &[Lit]) -> Result<Option<Lowered>, Stop> {
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
        let arrivals = walks.iter().map(|walk| arrival(walk));
        let found = Lowered {
            count: violations.len(),
            makespan: arrivals.clone().max().unwrap_or(0),
            sum: arrivals.sum(),
        };
        if self.best.as_ref().is_none_or(|(best, _)| found < *best) {
            self.best = Some((found, walks));
        }
        Ok(Some(found))
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
            && violations.len() <= best.0.count
        {
            best.1 = walks;
        }
    }
}
