//! Which rules exclude each other, and the fewest whose switching off leaves a plan.
//!
//! By implicit hitting sets (Moreno-Centeno and Karp, 2013): a set of rules whose switching
//! off leaves a plan meets every set of rules that excludes one. Smallest sets that meet all
//! known ones are tried; one that leaves no plan gives a further set that excludes one.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Instance, sorting::set};

use super::{Price, RulePrice, SwitchOff};
use crate::{
    budget::Budget,
    explain::{
        Core,
        causes::{Refuted, find_causes},
        group::{Group, without},
        group_mus::{Inquiry, Tried, group_mus_of_rules, rules_mus},
        unsolvable::AnyPlan,
        whole::WholePlan,
    },
    hitting::{MOST_SETS, hitting},
    search::Proved,
};

/// Sets of rules that are tried.
const MOST_TRIED: usize = 400;

/// A scene whose rules leave no plan.
pub(super) struct Unsolved<'a> {
    pub(super) instance: &'a Instance,
    /// The horizon, where a person set one.
    pub(super) within: Option<u32>,
    /// How far it is proved that there is none.
    pub(super) reach: Proved,
    /// Agents that cannot all arrive, where some are known.
    pub(super) clash: &'a [String],
}

/// Rules and facts that exclude each other, and the fewest rules whose switching off leaves
/// a plan. The prices of single rules are known.
pub(super) fn conflict(
    unsolved: &Unsolved,
    prices: &[RulePrice],
    budget: &Rc<Budget>,
) -> (Option<Core>, SwitchOff) {
    let instance = unsolved.instance;
    let rules: BTreeSet<usize> = set(prices.iter().map(|price| price.index as usize));
    if rules.is_empty() {
        return (None, SwitchOff::default());
    }
    let refuted = Refuted {
        instance,
        asked: &[],
        deadline: unsolved.within,
        reach: unsolved.reach,
    };
    let mut any_plan = AnyPlan {
        objective: instance.objective(),
        horizon: unsolved.reach.within().unwrap_or(0),
        budget: Rc::new(budget.part(crate::Limits::default())),
        whole: WholePlan::default(),
    };
    let nothing = BTreeSet::new();
    let mut core = group_mus_of_rules(&refuted, &nothing, unsolved.clash, &mut any_plan);
    find_causes(&refuted, &mut core, &mut any_plan);
    let mut search = FewestRules {
        refuted: &refuted,
        any_plan: &mut any_plan,
        rules,
        known: BTreeMap::new(),
    };
    search.know(prices);
    let own = core.groups.iter().filter_map(|group| match group {
        Group::Constraint(rule) => Some(*rule),
        _ => None,
    });
    let switch_off = search.fewest(set(own));
    budget.absorb(&any_plan.budget);
    let found = (!core.groups.is_empty()).then(|| core.core(instance, unsolved.within));
    (found, switch_off)
}

/// The search for the fewest rules.
struct FewestRules<'a, 'b, 'h> {
    refuted: &'a Refuted<'a>,
    any_plan: &'b mut AnyPlan<'a, 'h>,
    /// The rules in force.
    rules: BTreeSet<usize>,
    /// Whether there is a plan without some rules; `None` is not known.
    known: BTreeMap<BTreeSet<usize>, Option<bool>>,
}

impl FewestRules<'_, '_, '_> {
    /// Takes over what the prices of single rules say.
    fn know(&mut self, prices: &[RulePrice]) {
        for price in prices {
            let rule = BTreeSet::from([price.index as usize]);
            match price.price {
                Price::Decides => self.known.insert(rule, Some(true)),
                Price::None => self.known.insert(rule, Some(false)),
                Price::Free | Price::Costs | Price::Unknown => None,
            };
        }
    }

    /// The smallest sets; `core` excludes a plan.
    fn fewest(&mut self, core: BTreeSet<usize>) -> SwitchOff {
        let all = self.rules.clone();
        match self.leaves_a_plan(&all) {
            Some(true) => {}
            known => {
                return SwitchOff {
                    switch_off: Vec::new(),
                    switch_off_settled: known == Some(false),
                };
            }
        }
        let mut cores = vec![core];
        let mut is_settled = true;
        for size in 1..=self.rules.len() {
            let Some((found, all_known)) = self.of_size(size, &mut cores) else {
                return SwitchOff::default();
            };
            is_settled &= all_known;
            if !found.is_empty() {
                let numbers = |set: &BTreeSet<usize>| set.iter().map(|&rule| rule as u32).collect();
                return SwitchOff {
                    switch_off: found.iter().map(numbers).collect(),
                    switch_off_settled: is_settled,
                };
            }
        }
        SwitchOff::default()
    }

    /// The sets of so many rules that leave a plan, and whether that is known of each set
    /// that could. `None` where the budget is spent, or there are too many.
    fn of_size(
        &mut self,
        size: usize,
        cores: &mut Vec<BTreeSet<usize>>,
    ) -> Option<(BTreeSet<BTreeSet<usize>>, bool)> {
        loop {
            let budget = Rc::clone(&self.any_plan.budget);
            let sets = hitting(cores, size, &budget).ok()?;
            if sets.len() > MOST_SETS {
                return None;
            }
            let (mut found, mut all_known) = (BTreeSet::new(), true);
            let mut has_new_core = false;
            for set in sets {
                match self.leaves_a_plan(&set) {
                    Some(true) => {
                        found.insert(set);
                    }
                    Some(false) => {
                        let core = self.core_without(&set)?;
                        has_new_core = true;
                        cores.push(core);
                        break;
                    }
                    None => all_known = false,
                }
            }
            if !has_new_core {
                return Some((found, all_known));
            }
            if self.known.len() > MOST_TRIED {
                return None;
            }
        }
    }

    /// Whether there is a plan without some rules.
    fn leaves_a_plan(&mut self, rules: &BTreeSet<usize>) -> Option<bool> {
        if let Some(&known) = self.known.get(rules) {
            return known;
        }
        let left_out = left_out(rules);
        let variant = without(self.refuted.instance, &left_out, self.refuted.deadline);
        let mut tried = self.any_plan.search(&variant);
        if matches!(tried, Tried::Unknown) {
            tried = self.any_plan.search_longer(&variant);
        }
        let known = match tried.reaching(&variant, self.refuted.reach) {
            Tried::Plan(_) => Some(true),
            Tried::None { .. } => Some(false),
            Tried::Unknown => None,
        };
        self.known.insert(rules.clone(), known);
        known
    }

    /// Rules that exclude a plan without some others; `None` where that is not so for sure.
    fn core_without(&mut self, rules: &BTreeSet<usize>) -> Option<BTreeSet<usize>> {
        let left_out = left_out(rules);
        let core = rules_mus(self.refuted, &left_out, self.any_plan);
        // Without any rule there is a plan.
        (!core.is_empty() && core.is_disjoint(rules)).then_some(core)
    }
}

fn left_out(rules: &BTreeSet<usize>) -> BTreeSet<Group> {
    set(rules.iter().map(|&rule| Group::Constraint(rule)))
}
