//! For how long an agent could stand still, nobody else doing anything else.
//!
//! No search: the plan is changed and judged. A charge at the very time may be at the
//! beginning or at the end of standing still, whichever lasts.

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Assumption, Instance, Objective, Plan, check::check};

use super::Hold;
use crate::budget::{Budget, Stop};

/// The plan in which agents are held up.
pub(super) struct Holding<'a> {
    pub(super) instance: &'a Instance,
    pub(super) objective: &'a Objective,
    pub(super) plan: &'a Plan,
}

/// How long rules of the scene matter.
struct Rules {
    /// The last time that one names, or at which an obstacle moves.
    last: u32,
    /// The longest gap.
    gap: u32,
    /// The most wait steps on end that one allows.
    patience: u32,
}

impl Rules {
    fn of(instance: &Instance) -> Self {
        let mut rules = Self {
            last: 0,
            gap: 0,
            patience: 0,
        };
        for rule in instance.constraints_in_force() {
            rules.last = rules.last.max(rule.constraint.last_time());
            match rule.constraint.kind {
                ConstraintKind::Gap { steps } => rules.gap = rules.gap.max(steps),
                ConstraintKind::NoWaiting { most, .. } => {
                    rules.patience = rules.patience.max(most);
                }
                ConstraintKind::Capacity { .. }
                | ConstraintKind::Closed { .. }
                | ConstraintKind::OneWay { .. }
                | ConstraintKind::Apart { .. }
                | ConstraintKind::Sequence { .. }
                | ConstraintKind::Visit { .. }
                | ConstraintKind::Arrive { .. }
                | ConstraintKind::Late { .. }
                | ConstraintKind::Depart { .. }
                | ConstraintKind::Before { .. }
                | ConstraintKind::Turns { .. }
                | ConstraintKind::Avoid { .. } => {}
            }
        }
        for assumption in instance.assumptions() {
            if let Assumption::MovingObstacle { path, .. } = assumption {
                rules.last = rules.last.max(path.len() as u32);
            }
        }
        rules
    }
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
        let Rules {
            last,
            gap,
            patience,
        } = Rules::of(self.instance);
        let alike = at_rest.saturating_add(gap).max(last);
        let all = self.plan.paths.values().map(Vec::len).sum::<usize>() as u64;
        let mut holds = Vec::new();
        for time in 0..path.len().saturating_sub(1) {
            if path.get(time) == Some(&None) {
                holds.push(Hold::InTransit);
                continue;
            }
            let mut steps = 0;
            loop {
                budget.check()?;
                budget.spend(all + u64::from(steps))?;
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
                // Everybody else is at rest by then, and rules ask for nothing more, and so
                // one step more changes nothing but the battery.
                let is_alike = time as u32 + steps > alike && steps > patience;
                if is_alike && self.is_unlimited(name) {
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
