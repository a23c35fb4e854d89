//! A person's own plan: what it breaks, or how it compares with the best.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Cost, Costs, Instance, Objective, Plan,
    check::{self, Violation},
};

use super::{
    answer::Excess,
    ask::{Ask, Found, best},
    whole::WholePlan,
};
use crate::{Status, budget::Budget, problem::Relaxed};

/// The findings about a person's own plan.
pub(crate) struct OwnPlanReport {
    pub(crate) violations: Vec<Violation>,
    /// Its costs, where every agent has a path.
    pub(crate) costs: Option<Costs>,
    /// Whether no plan is better; `None` where that is not known, or the plan
    /// is none.
    pub(crate) optimal: Option<bool>,
    /// A better plan and its costs.
    pub(crate) better: Option<(Plan, Costs)>,
    /// The counts that are higher in it than in the better plan, agent by agent.
    pub(crate) excess: Vec<Excess>,
    /// The search for the best plan; `None` where the person's plan breaks a rule.
    pub(crate) found: Option<Found>,
}

impl OwnPlanReport {
    /// The verdict of the judge, without other plans yet.
    pub(crate) const fn new(violations: Vec<Violation>, costs: Option<Costs>) -> Self {
        Self {
            violations,
            costs,
            optimal: None,
            better: None,
            excess: Vec::new(),
            found: None,
        }
    }
}

/// Judges a plan.
pub(crate) fn judge(
    instance: &Instance,
    plan: &Plan,
    objective: &Objective,
    within: Option<u32>,
    whole: WholePlan,
    budget: &Rc<Budget>,
) -> OwnPlanReport {
    let violations = whole.check(instance, plan);
    let mut judged = OwnPlanReport::new(violations, check::costs(instance, plan));
    let Some(costs) = judged.costs.filter(|_| judged.violations.is_empty()) else {
        return judged;
    };
    let found = best(
        &Ask {
            instance,
            relaxed: &Relaxed::default(),
            conditions: &[],
            objective,
            caps: &BTreeMap::new(),
            // A plan that is at hand is never beyond what is looked at.
            within: within.map(|within| within.max(costs.makespan)),
            at_least_within: costs.makespan,
        },
        budget,
    );
    let vector = |costs: &Costs| costs.vector(objective);
    if let (Some(other), Some(least)) = (&found.plan, &found.costs) {
        if vector(least) < vector(&costs) {
            judged.optimal = Some(false);
            judged.excess = excess(instance, plan, other);
            judged.better = Some((other.clone(), *least));
        } else if found.status == Status::Optimal && vector(least) == vector(&costs) {
            judged.optimal = Some(true);
        }
    }
    judged.found = Some(found);
    judged
}

/// The counts that are higher for each agent in one plan than in another.
fn excess(instance: &Instance, plan: &Plan, other: &Plan) -> Vec<Excess> {
    let mut excess = Vec::new();
    for agent in instance.agents() {
        let Some(alone) = instance.alone(&agent.name) else {
            continue;
        };
        let costs = [plan, other].map(|plan| check::costs(&alone, plan));
        let [Some(costs), Some(less)] = costs else {
            continue;
        };
        for cost in [Cost::SumOfCosts, Cost::Charges, Cost::Moves, Cost::Waits] {
            let by = costs.get(cost).saturating_sub(less.get(cost));
            if by > 0 {
                let agent = agent.name.clone();
                excess.push(Excess { agent, cost, by });
            }
        }
    }
    excess
}
