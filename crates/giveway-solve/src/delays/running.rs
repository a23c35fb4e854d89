//! The plan of a ledger, or what is left of it after changes of the world.

use std::rc::Rc;

use giveway_model::{
    Cost, Costs, Instance, Plan,
    check::{self, Violation, check},
    snapshot::Snapshot,
};

use super::DelayCause;
use crate::{
    budget::Budget,
    explain::ask::{names, walks},
    problem::Problem,
    walk::{Walk, costs_of},
};

/// A plan that the judge passed, and the instance that it is one of: after changes both are the
/// rest from the last change on, in times from 0.
pub(super) struct RunningPlan<'a> {
    pub(super) instance: &'a Instance,
    pub(super) plan: &'a Plan,
    /// The plan at the last change, where there was one.
    pub(super) snapshot: Option<&'a Snapshot<'a>>,
}

impl RunningPlan<'_> {
    /// The time of the last change, in steps of the whole plan.
    pub(super) fn since(&self) -> u32 {
        self.snapshot.map_or(0, |snapshot| snapshot.at)
    }

    /// The rules that a plan of the instance breaks, in times of the whole plan.
    pub(super) fn check(&self, plan: &Plan) -> Vec<Violation> {
        match self.snapshot {
            None => check(self.instance, plan).violations,
            Some(snapshot) => snapshot.check(plan).violations,
        }
    }

    /// The costs of the whole plan, where those of its rest are these.
    pub(super) fn whole_costs(&self, costs: Costs) -> Costs {
        match self.snapshot {
            None => costs,
            Some(snapshot) => snapshot.whole_costs(costs, self.plan),
        }
    }

    /// The costs of the plan itself.
    pub(super) fn costs(&self) -> Option<Costs> {
        check::costs(self.instance, self.plan)
    }

    pub(super) fn names(&self) -> Vec<String> {
        names(self.instance)
    }

    pub(super) fn walks(&self, problem: &Problem) -> Option<Vec<Walk>> {
        walks(self.instance, problem, self.plan)
    }

    /// The arrival of an agent in the whole plan, where its part of the sum of costs of the rest
    /// is this.
    pub(super) fn arrival(&self, agent: &str, cost: u32) -> u32 {
        let rested = self.instance.start_state(agent).rested;
        self.since().saturating_add(cost).saturating_sub(rested)
    }

    /// The cause that a violation names beside an agent: other agents, or a rule.
    pub(super) fn causes(&self, agent: usize, violation: &Violation) -> Vec<(usize, DelayCause)> {
        if let Some(broken) = &violation.broken {
            let cause = DelayCause::Rule {
                index: broken.index,
                kind: broken.kind.clone(),
                name: broken.name.clone(),
                text: self.rule(broken.index as usize),
            };
            // Behind all agents.
            let place = self.instance.agents().len() + broken.index as usize;
            return vec![(place, cause)];
        }
        let agents = self.instance.agents().iter().enumerate();
        let others = agents.filter(|(i, it)| *i != agent && violation.agents.contains(&it.name));
        let cause = |name: &String| DelayCause::Agent {
            agent: name.clone(),
        };
        others.map(|(i, it)| (i, cause(&it.name))).collect()
    }

    /// A rule by its name or its sentence; rules have their numbers in the whole plan.
    fn rule(&self, index: usize) -> String {
        let rule = match self.snapshot {
            None => self.instance.constraints().get(index),
            Some(snapshot) => {
                let timed = snapshot.history.constraints().get(index);
                timed.map(|timed| &timed.constraint)
            }
        };
        rule.map_or_else(String::new, giveway_model::Constraint::called)
    }
}

/// The part of the sum of costs that a walk of an agent has.
pub(super) fn cost(problem: &Problem, agent: usize, walk: &Walk) -> u32 {
    costs_of(problem, agent, walk).get(Cost::SumOfCosts)
}

/// The budget of one part, of all that is left.
pub(super) fn part<'h>(budget: &Rc<Budget<'h>>) -> Rc<Budget<'h>> {
    Rc::new(budget.part(crate::Limits::default()))
}
