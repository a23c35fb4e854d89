//! The search for a plan that is as asked for, of variants of one instance: for
//! any such plan, or for one that costs no more than the plan asked about.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Condition, Cost, Costs, Plan, check::costs};
use giveway_planners::first::plan_in_order;

use super::{
    ask::{Ask, Found, Start, any, at_most, best, best_from, names, violations, walks},
    budgets::{brief_search, further_search, long_search, one_search},
    fitting::FittingQuestion,
    group::{Variant, fit},
    group_mus::{Inquiry, Tried},
    repairs::{EditedPlan, Solver},
    unsolvable::tried,
};
use crate::{
    budget::Budget,
    impose::{bearer, limit_costs},
    lns::{Effort, Lns},
    problem::Problem,
    search::Proved,
    walk::to_plan,
};

/// States that are looked at to improve a known plan, about.
const NEARBY_STATES: u64 = 10_000;
/// The same for what is likely to help.
const HELPFUL_STATES: u64 = 100_000;
/// Agents that are planned one after the other before any formula is made.
const MOST_IN_ORDER: usize = 8;

/// A search for plans that meet the contrast of a question.
pub(crate) struct ContrastSearch<'a, 'h> {
    pub(crate) case: &'a FittingQuestion<'a>,
    /// The most that it may cost, in the order of the objective.
    pub(crate) most: Option<Vec<u32>>,
    /// A plan that is as asked for but costs more: plans near to it are looked
    /// at before anything else.
    pub(crate) near: Option<&'a Plan>,
    /// The horizon of the instance as it is.
    pub(crate) horizon: u32,
    pub(crate) budget: Rc<Budget<'h>>,
}

impl ContrastSearch<'_, '_> {
    /// The alternatives of the contrast, one of which must hold: those about agents that are still there.
    fn conditions<'c>(&'c self, variant: &'c Variant) -> impl Iterator<Item = &'c Condition> {
        let conditions = self.case.conditions();
        conditions.filter(|condition| bearer(condition, &variant.instance).is_ok())
    }

    fn with<T>(
        &self,
        variant: &Variant,
        condition: &Condition,
        part: &Rc<Budget>,
        run: impl Fn(&Ask, &Rc<Budget>) -> T,
    ) -> T {
        let ask = Ask {
            instance: &variant.instance,
            relaxed: &variant.relaxed,
            conditions: std::slice::from_ref(condition),
            objective: self.case.objective(),
            caps: &BTreeMap::new(),
            within: variant.within,
            at_least_within: self.horizon,
        };
        let result = run(&ask, part);
        self.budget.absorb(part);
        result
    }

    fn find(&self, variant: &Variant, condition: &Condition, part: &Rc<Budget>) -> Found {
        match &self.most {
            Some(most) => self.with(variant, condition, part, |ask, budget| {
                at_most(ask, most.clone(), budget)
            }),
            None => self.with(variant, condition, part, any),
        }
    }

    /// Looks for a plan, under each condition with the budget that `part` makes.
    fn look<'b>(&self, variant: &Variant, part: impl Fn() -> Rc<Budget<'b>>) -> Tried {
        let mut reach: Option<Proved> = None;
        let mut agents: Vec<String> = Vec::new();
        let mut unknown = false;
        if let Some(plan) = self
            .near
            .and_then(|near| self.nearby(near, variant, NEARBY_STATES))
        {
            return Tried::Plan(plan);
        }
        let mut in_order = self
            .conditions(variant)
            .filter(|_| self.is_part_of_floor(variant));
        if let Some(plan) = in_order.find_map(|condition| self.in_order(variant, condition)) {
            return Tried::Plan(plan);
        }
        drop(in_order);
        for condition in self.conditions(variant) {
            match tried(self.find(variant, condition, &part())) {
                Tried::Plan(plan) => return Tried::Plan(plan),
                Tried::Unknown => unknown = true,
                Tried::None { reach: own, clash } => {
                    reach = Some(reach.map_or(own, |reach| reach.and(own)));
                    agents.extend(clash);
                }
            }
        }
        match reach {
            Some(reach) if !unknown => Tried::None {
                reach,
                clash: agents,
            },
            _ => Tried::Unknown,
        }
    }

    /// A plan near to a known one, improved by what was left out.
    fn nearby(&self, plan: &Plan, variant: &Variant, states: u64) -> Option<Plan> {
        let mut conditions = self.conditions(variant);
        conditions.find_map(|condition| self.improved(plan, variant, (condition, states)))
    }

    fn improved(
        &self,
        plan: &Plan,
        variant: &Variant,
        (condition, states): (&Condition, u64),
    ) -> Option<Plan> {
        let near = fit(plan, &variant.instance);
        let instance = &variant.instance;
        let relaxed = variant.relaxed.clone();
        let budget = &self.budget;
        let problem = Problem::relaxed(instance, relaxed, Some(condition), budget).ok()?;
        let mut walks = walks(instance, &problem, &near)?;
        let latest = variant.within.unwrap_or(self.horizon);
        let objective = self.case.objective();
        let improved = Lns::default().improve(
            &problem,
            &mut walks,
            Effort {
                states,
                horizon: latest,
                enough: 0,
            },
            objective,
            budget,
        );
        improved.ok()?;
        let plan = to_plan(&problem, &names(instance), &walks);
        self.accepts(variant, &plan).then_some(plan)
    }

    /// Whether a variant has few of the agents of a large floor.
    fn is_part_of_floor(&self, variant: &Variant) -> bool {
        let all = self.case.instance.agents().len();
        let is_large = all > self.budget.thresholds().few_agents;
        is_large && variant.instance.agents().len() <= MOST_IN_ORDER
    }

    /// A plan in which agents are planned one after the other: of few agents it is there sooner
    /// than a model of their formula.
    fn in_order(&self, variant: &Variant, condition: &Condition) -> Option<Plan> {
        let instance = &variant.instance;
        let (relaxed, budget) = (variant.relaxed.clone(), &self.budget);
        let problem = Problem::relaxed(instance, relaxed, Some(condition), budget).ok()?;
        let mut limits = BTreeMap::new();
        limit_costs(condition, &mut limits).ok()?;
        let first = self.case.objective().costs().first().copied();
        if let Some((cost, most)) = first.zip(self.most.as_ref().and_then(|most| most.first())) {
            limits.entry(cost).or_insert(*most);
        }
        let latest = variant.within.unwrap_or(self.horizon);
        let limit = limits.get(&Cost::Makespan).copied();
        let latest = latest.min(limit.unwrap_or(u32::MAX));
        if problem.optima.iter().any(|&optimum| optimum > latest) {
            return None;
        }
        let order = (0..problem.agents()).collect();
        let walks = plan_in_order(&problem, order, latest, &**budget).ok()??;
        let plan = to_plan(&problem, &names(instance), &walks);
        self.accepts(variant, &plan).then_some(plan)
    }

    /// The best plan of all alternatives of the contrast, by a search for the best of one.
    fn best_by(
        &self,
        variant: &Variant,
        search: impl Fn(&Ask, &Rc<Budget>) -> Found,
    ) -> Option<EditedPlan> {
        let objective = self.case.objective();
        let mut proved = true;
        let plans = self.conditions(variant).filter_map(|condition| {
            let found = self.with(variant, condition, &one_search(&self.budget), &search);
            proved &= found.reach.is_some();
            found.plan.zip(found.costs)
        });
        let cheapest = plans.min_by_key(|(_, costs)| costs.vector(objective));
        let (plan, costs) = cheapest?;
        Some(EditedPlan {
            plan,
            costs,
            proved,
        })
    }

    fn is_cheap(&self, costs: &Costs) -> bool {
        let vector = costs.vector(self.case.objective());
        self.most.as_ref().is_none_or(|most| vector <= *most)
    }
}

impl Inquiry for ContrastSearch<'_, '_> {
    fn search(&mut self, variant: &Variant) -> Tried {
        self.look(variant, || one_search(&self.budget))
    }

    fn search_briefly(&mut self, variant: &Variant) -> Tried {
        self.look(variant, || brief_search(&self.budget))
    }

    fn search_again(&mut self, variant: &Variant) -> Tried {
        self.look(variant, || further_search(&self.budget))
    }

    fn search_longer(&mut self, variant: &Variant) -> Tried {
        self.look(variant, || long_search(&self.budget))
    }

    fn accepts(&self, variant: &Variant, plan: &Plan) -> bool {
        let instance = &variant.instance;
        let Some(costs) = costs(instance, plan) else {
            return false;
        };
        let mut conditions = self.conditions(variant);
        variant.within.is_none_or(|within| costs.makespan <= within)
            && self.is_cheap(&costs)
            && violations(instance, &variant.relaxed, plan).is_empty()
            && conditions.any(|condition| condition.holds(instance, plan) == Some(true))
    }

    fn is_over(&self) -> bool {
        self.budget.check().is_err()
    }
}

impl Solver for ContrastSearch<'_, '_> {
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan> {
        let found = self.best_by(variant, best)?;
        self.is_cheap(&found.costs).then_some(found)
    }

    fn cheapest(&mut self, variant: &Variant) -> Option<EditedPlan> {
        let near = self.near.map(|plan| fit(plan, &variant.instance));
        self.best_by(variant, |ask, budget| {
            let start = Start {
                plan: near.as_ref(),
                earlier: None,
            };
            best_from(ask, start, budget)
        })
    }

    fn near_to(&mut self, plan: &Plan, variant: &Variant) -> Option<Plan> {
        self.nearby(plan, variant, HELPFUL_STATES)
    }
}
