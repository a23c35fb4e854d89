//! The rows of the ledger: each agent's delay, split by whom it lets pass.

use std::collections::BTreeMap;

use giveway_model::{Plan, check::Violation, sorting::sort_by};

use super::{
    AgentDelay, CauseTotal, DelayCause, Fraction, Share,
    calmed::calmed,
    heat::lost,
    running::{RunningPlan, cost},
};
use crate::{
    budget::{Budget, Stop},
    explain::lone_walk::{lone_walk, replaced},
    problem::Problem,
    walk::{Walk, arrival, to_plan},
};

/// A cause with its place in the order: agents as in the scene, then rules.
type Causes = BTreeMap<usize, DelayCause>;

/// The rows in the order of the agents, and the calm plan where there is another one than the
/// plan itself.
pub(super) struct Ledger {
    pub(super) rows: Vec<AgentDelay>,
    pub(super) totals: Vec<CauseTotal>,
    pub(super) calm: Option<Plan>,
}

/// The ledger of a plan.
///
/// # Errors
/// When the budget is spent, or the search contradicts the judge.
pub(super) fn ledger(
    running: &RunningPlan,
    problem: &Problem,
    walks: &[Walk],
    budget: &Budget,
) -> Result<Ledger, Stop> {
    let calm = calmed(running, problem, walks);
    let (plan, calm_walks) = match &calm {
        Some((plan, walks)) => (plan, walks.as_slice()),
        None => (running.plan, walks),
    };
    let mut split = Split {
        running,
        problem,
        names: running.names(),
        plan,
        walks: calm_walks.to_vec(),
        totals: BTreeMap::new(),
    };
    let mut rows = Vec::new();
    for (agent, walk) in walks.iter().enumerate() {
        rows.push(split.row(agent, walk, budget)?);
    }
    Ok(Ledger {
        rows,
        totals: ordered(split.totals),
        calm: calm.map(|(plan, _)| plan),
    })
}

/// The delays as they are split, agent by agent.
struct Split<'a> {
    running: &'a RunningPlan<'a>,
    problem: &'a Problem,
    names: Vec<String>,
    /// The calm plan.
    plan: &'a Plan,
    /// Its walks.
    walks: Vec<Walk>,
    /// What each cause costs all agents so far; `None` where the fraction has too large numbers.
    totals: BTreeMap<usize, (DelayCause, Option<Fraction>)>,
}

impl Split<'_> {
    fn row(&mut self, agent: usize, walk: &Walk, budget: &Budget) -> Result<AgentDelay, Stop> {
        let (running, problem) = (self.running, self.problem);
        // Its own walk is one of those alone.
        let lone = lone_walk(problem, &self.walks, (agent, arrival(walk)), budget)?;
        let lone = lone.ok_or(Stop::Contradiction)?;
        let costs = (cost(problem, agent, walk), cost(problem, agent, &lone));
        let delay = costs.0.checked_sub(costs.1).ok_or(Stop::Contradiction)?;
        let name = self.names[agent].clone();
        let because = if delay == 0 {
            Vec::new()
        } else {
            let causes = self.causes(agent, &lone);
            self.share(causes, delay)
        };
        Ok(AgentDelay {
            arrival: running.arrival(&name, costs.0),
            alone: running.arrival(&name, costs.1),
            delay,
            because,
            lost: lost(running, problem, (agent, walk), delay, budget)?,
            agent: name,
        })
    }

    /// The agents and rules that a way alone would offend: up to its end, or after it where
    /// there is nothing else.
    fn causes(&mut self, agent: usize, lone: &Walk) -> Causes {
        let end = self.running.since().saturating_add(arrival(lone));
        let own = std::mem::replace(&mut self.walks[agent], lone.clone());
        let other = to_plan(self.problem, &self.names, &self.walks);
        self.walks[agent] = own;
        let other = replaced(self.plan, &self.names[agent], &other);
        let violations = self.running.check(&other);
        let named = |violations: &mut dyn Iterator<Item = &Violation>| -> Causes {
            let causes = violations.flat_map(|violation| self.running.causes(agent, violation));
            causes.collect()
        };
        let causes = named(&mut violations.iter().filter(|it| it.time <= end));
        if causes.is_empty() {
            named(&mut violations.iter())
        } else {
            causes
        }
    }

    /// The even parts of a delay.
    fn share(&mut self, causes: Causes, delay: u32) -> Vec<Share> {
        let mut causes: Vec<(usize, DelayCause)> = causes.into_iter().collect();
        if causes.is_empty() {
            causes.push((usize::MAX, DelayCause::Nobody));
        }
        let steps = Fraction::of(delay, causes.len() as u32);
        for (place, cause) in &causes {
            let nothing = || (cause.clone(), Some(Fraction::whole(0)));
            let (_, total) = self.totals.entry(*place).or_insert_with(nothing);
            *total = total.and_then(|total| total.plus(steps));
        }
        let shares = causes.into_iter();
        shares.map(|(_, cause)| Share { cause, steps }).collect()
    }
}

/// Who costs most first; what has no number comes last.
fn ordered(totals: BTreeMap<usize, (DelayCause, Option<Fraction>)>) -> Vec<CauseTotal> {
    let totals = totals.into_values();
    let mut totals: Vec<CauseTotal> = totals
        .map(|(cause, steps)| CauseTotal { cause, steps })
        .collect();
    sort_by(&mut totals, |a, b| b.steps.cmp(&a.steps));
    totals
}
