//! For how long an agent could stand still, nobody else doing anything else.
//!
//! No search: the plan is changed and judged. A charge at the very time may be at the
//! beginning or at the end of standing still, whichever lasts.

use giveway_model::{Instance, Objective, Plan, check::check};

use super::Hold;
use crate::budget::{Budget, Stop};

/// The plan in which agents are held up.
pub(super) struct Holding<'a> {
    pub(super) instance: &'a Instance,
    pub(super) objective: &'a Objective,
    pub(super) plan: &'a Plan,
}

impl Holding<'_> {
    /// The holds of one agent, at each time before its arrival.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn of(&self, name: &str, budget: &Budget) -> Result<Vec<Hold>, Stop> {
        let path = self.plan.path(name);
        let Some(&first) = self.objective.costs().first() else {
            return Ok(Vec::new());
        };
        let most = check(self.instance, self.plan)
            .costs
            .map(|costs| costs.get(first));
        let others = self.instance.agents().iter().filter(|it| it.name != name);
        let at_rest = others.map(|it| self.plan.path(&it.name).len()).max();
        let at_rest = at_rest.unwrap_or(0) as u32;
        let mut holds = Vec::new();
        for time in 0..path.len().saturating_sub(1) {
            if path.get(time) == Some(&None) {
                holds.push(Hold::InTransit);
                continue;
            }
            let mut steps = 0;
            loop {
                budget.check()?;
                let mut stands = self.standing(name, time, steps + 1).into_iter();
                let passes = |plan: Plan| {
                    let report = check(self.instance, &plan);
                    let cost = report.costs.map(|costs| costs.get(first));
                    report.violations.is_empty() && cost.is_some() && cost <= most
                };
                if !stands.any(passes) {
                    holds.push(Hold::Steps(steps));
                    break;
                }
                steps += 1;
                // Everybody else is at rest by then, and so one step more changes
                // nothing but the battery.
                if time as u32 + steps > at_rest && self.is_unlimited(name) {
                    holds.push(Hold::Unlimited);
                    break;
                }
            }
        }
        Ok(holds)
    }

    fn is_unlimited(&self, name: &str) -> bool {
        let mut agents = self.instance.agents().iter();
        agents.any(|it| it.name == name && it.battery.is_none())
    }

    /// The plan with an agent standing still from a time on; twice where it charges
    /// at that time.
    fn standing(&self, name: &str, time: usize, steps: u32) -> Vec<Plan> {
        let mut plan = self.plan.clone();
        if let Some(path) = plan.paths.get_mut(name) {
            let here = path.get(time).copied().flatten();
            path.splice(time..time, (0..steps).map(|_| here));
        }
        let now = time as u32;
        let charges = self.plan.charges(name).to_vec();
        let moved = |from: u32| {
            let each = charges.iter();
            each.map(|&at| if at >= from { at + steps } else { at })
                .collect::<Vec<u32>>()
        };
        if charges.is_empty() {
            return vec![plan];
        }
        let mut plans = Vec::new();
        let mut froms = vec![now + 1];
        if charges.contains(&now) {
            froms.push(now);
        }
        for from in froms {
            let mut plan = plan.clone();
            plan.charges.insert(name.to_owned(), moved(from));
            plans.push(plan);
        }
        plans
    }
}
