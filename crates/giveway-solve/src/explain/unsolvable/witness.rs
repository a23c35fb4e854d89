//! Plans that break as few rules of one class as can be: what goes wrong where there is no plan.

use std::collections::BTreeSet;

use giveway_model::{
    Instance, Plan,
    check::{Rule, Violation},
    sorting::set,
};

use super::AnyPlan;
use crate::explain::{
    answer::{Class, WitnessEntry},
    budgets::one_search,
    group::{Group, groups, without},
    group_mus::{Inquiry, Tried},
    repairs::{EditedPlan, Solver},
    soft::{self, RelaxedPlan},
    whole::WholePlan,
};

/// Sets of batteries or waypoints that are tried.
const MOST_SETS: usize = 400;

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
