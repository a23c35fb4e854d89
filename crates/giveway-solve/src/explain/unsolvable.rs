//! Why there is no plan: facts that exclude one, a plan that breaks few rules,
//! and what would help.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Instance, Objective, Plan,
    check::{Rule, Violation},
};

use super::{
    answer::{Class, WitnessEntry},
    ask::{Ask, Found, any, best, violations},
    group::{Group, Variant, groups, without},
    group_mus::{CoreFound, Inquiry, Tried, group_mus},
    repairs::{EditedPlan, Solver},
    soft::{self, RelaxedPlan},
    whole::WholePlan,
};
use crate::{Limits, budget::Budget};
use giveway_model::sorting::set;

/// Clauses that one of many searches may derive.
const DERIVED_EACH: u64 = 8_000;
/// Clauses that one of many searches may write.
const CLAUSES_EACH: u64 = 500_000;
/// Joint steps that it may look at.
const JOINT_STEPS_EACH: u64 = 150_000;
/// So many times the work of a search, where it is made again.
const AGAIN: u64 = 10;
/// A brief search may derive so small a part of the clauses.
const BRIEFLY: u64 = 5;
/// Sets of batteries or waypoints that are tried.
const MOST_SETS: usize = 400;

/// The budget of one search of many.
pub(crate) fn one_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = CLAUSES_EACH.min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(DERIVED_EACH)
            .with_work(clauses, JOINT_STEPS_EACH),
    )
}

/// The budget of a brief search of many, of which only those are made again that it does not
/// decide.
pub(crate) fn brief_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = CLAUSES_EACH.min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(DERIVED_EACH / BRIEFLY)
            .with_work(clauses, JOINT_STEPS_EACH),
    )
}

/// The budget of a search of many that is made again with more work.
pub(crate) fn further_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = (AGAIN * CLAUSES_EACH).min(budget.clauses_left());
    Rc::new(
        budget
            .part(Limits::default())
            .with_derived(AGAIN * DERIVED_EACH)
            .with_work(clauses, AGAIN * JOINT_STEPS_EACH),
    )
}

/// The budget of a search that may take all that is left.
pub(crate) fn long_search<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    let clauses = budget.clauses_left();
    Rc::new(budget.part(Limits::default()).with_clauses(clauses))
}

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

/// For each class of rules, the plan that breaks the fewest of it and no other.
/// The flag says whether all classes were settled.
pub(crate) fn witness(
    instance: &Instance,
    within: Option<u32>,
    any_plan: &mut AnyPlan,
) -> (Vec<WitnessEntry>, bool) {
    let mut entries = Vec::new();
    let mut settled = true;
    for class in [
        Class::Collision,
        Class::Obstacle,
        Class::Battery,
        Class::Waypoint,
    ] {
        let horizon = any_plan.horizon;
        let part = one_search(&any_plan.budget);
        let broken = match class {
            Class::Collision => soft::collisions(instance, within, horizon, &part),
            Class::Obstacle => soft::obstacles(instance, within, horizon, &part),
            Class::Battery => fewest_left_out(instance, within, any_plan, |group| {
                matches!(group, Group::Battery(_))
            }),
            Class::Waypoint => fewest_left_out(instance, within, any_plan, |group| {
                matches!(group, Group::Waypoint(..))
            }),
        };
        any_plan.budget.absorb(&part);
        settled &= part.check().is_ok();
        if let Some(broken) = broken {
            settled &= broken.fewest;
            let mut found = violations_of(instance, class, &broken.plan, any_plan.whole);
            // The encoding and the judge must count the same.
            if found.len() != broken.count {
                found.clear();
            }
            entries.extend(found.into_iter().map(|violation| WitnessEntry {
                violation,
                class: Some(class),
            }));
        }
    }
    (entries, settled)
}

/// The violations of a plan that breaks rules of one class, batteries once an
/// agent; none where it breaks others, too.
fn violations_of(
    instance: &Instance,
    class: Class,
    plan: &Plan,
    whole: WholePlan,
) -> Vec<Violation> {
    let mut violations = whole.check(instance, plan);
    let of_class = |rule: Rule| match class {
        Class::Collision => matches!(rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap),
        Class::Obstacle => rule == Rule::Obstacle,
        Class::Battery => rule == Rule::Battery,
        Class::Waypoint => rule == Rule::Waypoint,
    };
    if violations.iter().any(|v| !of_class(v.rule)) {
        return Vec::new();
    }
    if class == Class::Battery {
        let mut seen = BTreeSet::new();
        violations.retain(|v| seen.insert(v.agents.clone()));
    }
    violations
}

/// The best plan without some batteries or waypoints, as few as can be.
fn fewest_left_out(
    instance: &Instance,
    within: Option<u32>,
    any_plan: &mut AnyPlan,
    of_class: impl Fn(&Group) -> bool,
) -> Option<RelaxedPlan> {
    let mut class = groups(instance, &[], false);
    class.retain(of_class);
    let all = set(class.iter().copied());
    if all.is_empty()
        || !matches!(
            any_plan.search(&without(instance, &all, within)),
            Tried::Plan(_)
        )
    {
        return None;
    }
    let mut left = MOST_SETS;
    let mut fewest = true;
    for count in 1..=class.len() {
        let mut found: Option<(Vec<u32>, Plan)> = None;
        let mut settled = true;
        for set in subsets(&class, count) {
            if left == 0 {
                return found.map(|(_, plan)| broken(plan, count, false));
            }
            left -= 1;
            let variant = without(instance, &set, within);
            match any_plan.search(&variant) {
                Tried::None { .. } => {}
                Tried::Unknown => settled = false,
                Tried::Plan(_) => {
                    if let Some(EditedPlan {
                        plan,
                        costs,
                        proved,
                    }) = any_plan.best(&variant)
                    {
                        settled &= proved;
                        let key = vec![costs.makespan, costs.sum_of_costs];
                        if found.as_ref().is_none_or(|(best, _)| key < *best) {
                            found = Some((key, plan));
                        }
                    }
                }
            }
        }
        if let Some((_, plan)) = found {
            return Some(broken(plan, count, fewest && settled));
        }
        fewest &= settled;
    }
    None
}

const fn broken(plan: Plan, count: usize, fewest: bool) -> RelaxedPlan {
    RelaxedPlan {
        plan,
        count,
        fewest,
    }
}

/// All subsets of a size, in order.
fn subsets(class: &[Group], count: usize) -> impl Iterator<Item = BTreeSet<Group>> + '_ {
    let mut chosen: Option<Vec<usize>> = Some((0..count).collect());
    std::iter::from_fn(move || {
        let now = chosen.clone()?;
        // The last index that can move on, and those behind it right after it.
        let next = (0..count)
            .rev()
            .find(|&i| now[i] + (count - i) < class.len());
        chosen = next.map(|i| {
            let head = now[..i].iter().copied();
            head.chain(now[i] + 1..now[i] + 1 + count - i).collect()
        });
        Some(set(now.iter().map(|&i| class[i])))
    })
}

/// Takes the classes' plans for what they are: a part of the words.
pub(crate) fn of_class(entries: &[WitnessEntry], class: Class) -> Vec<&Violation> {
    let of = entries.iter().filter(|entry| entry.class == Some(class));
    of.map(|entry| &entry.violation).collect()
}
