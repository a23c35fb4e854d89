//! Why there is no plan: facts that exclude one, a plan that breaks few rules,
//! and what would help.

mod witness;

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Instance, Objective, Plan};

use super::{
    ask::{Ask, Found, any, best, violations},
    budgets::{brief_search, further_search, long_search, one_search},
    group::Variant,
    group_mus::{CoreFound, Inquiry, Tried, group_mus},
    repairs::{EditedPlan, Solver},
    whole::WholePlan,
};
use crate::budget::Budget;

pub(crate) use witness::{of_class, witness};

/// The search for any plan at all, of variants of one instance.
pub(crate) struct AnyPlan<'a, 'h> {
    pub(crate) objective: &'a Objective,
    /// The horizon of the instance as it is.
    pub(crate) horizon: u32,
    pub(crate) budget: Rc<Budget<'h>>,
    /// The plan of which the instance is the rest.
    pub(crate) whole: WholePlan<'a>,
}

impl AnyPlan<'_, '_> {
    fn with<T>(
        &self,
        variant: &Variant,
        part: &Rc<Budget>,
        run: impl Fn(&Ask, &Rc<Budget>) -> T,
    ) -> T {
        let ask = Ask {
            instance: &variant.instance,
            relaxed: &variant.relaxed,
            conditions: &[],
            objective: self.objective,
            caps: &BTreeMap::new(),
            within: variant.within,
            at_least_within: self.horizon,
        };
        let result = run(&ask, part);
        self.budget.absorb(part);
        result
    }
}

impl Inquiry for AnyPlan<'_, '_> {
    fn search(&mut self, variant: &Variant) -> Tried {
        tried(self.with(variant, &one_search(&self.budget), any))
    }

    fn search_briefly(&mut self, variant: &Variant) -> Tried {
        tried(self.with(variant, &brief_search(&self.budget), any))
    }

    fn search_again(&mut self, variant: &Variant) -> Tried {
        tried(self.with(variant, &further_search(&self.budget), any))
    }

    fn search_longer(&mut self, variant: &Variant) -> Tried {
        tried(self.with(variant, &long_search(&self.budget), any))
    }

    fn accepts(&self, variant: &Variant, plan: &Plan) -> bool {
        let instance = &variant.instance;
        let arrives = |within: u32| {
            let costs = giveway_model::check::costs(instance, plan);
            costs.is_some_and(|costs| costs.makespan <= within)
        };
        violations(instance, &variant.relaxed, plan).is_empty()
            && variant.within.is_none_or(arrives)
    }

    fn is_over(&self) -> bool {
        self.budget.check().is_err()
    }
}

impl Solver for AnyPlan<'_, '_> {
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan> {
        let found = self.with(variant, &one_search(&self.budget), best);
        let (plan, costs) = found.plan.zip(found.costs)?;
        let proved = found.reach.is_some();
        Some(EditedPlan {
            plan,
            costs,
            proved,
        })
    }

    fn cheapest(&mut self, variant: &Variant) -> Option<EditedPlan> {
        self.best(variant)
    }

    // No plan is asked about where there is none.
    fn near_to(&mut self, _: &Plan, _: &Variant) -> Option<Plan> {
        None
    }
}

/// The result of a search for any plan of a variant.
pub(crate) fn tried(found: Found) -> Tried {
    match (found.plan, found.reach) {
        (Some(plan), _) => Tried::Plan(plan),
        (None, Some(reach)) => Tried::None {
            reach,
            clash: found.clash,
        },
        (None, None) => Tried::Unknown,
    }
}

/// Facts that exclude a plan, where `found` says that there is none.
pub(crate) fn core(
    instance: &Instance,
    within: Option<u32>,
    found: &Found,
    any_plan: &mut AnyPlan,
) -> Option<CoreFound> {
    let refuted = tried(found.clone());
    group_mus(instance, &[], within, &BTreeSet::new(), refuted, any_plan)
}
