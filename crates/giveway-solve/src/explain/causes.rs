//! Tries the facts of a minimal set in the whole instance: which of them help when they alone are left out,
//! and further sets where none does.
//!
//! A minimal set says nothing of the facts outside of it: an instance can have two
//! walls between a robot and its goal, and each wall alone makes a plan impossible.
//! So each fact of the set is left out of the whole instance, once. Where that never
//! helps, there is another set without one of these facts. It is looked for with as
//! many facts of the sets before it left out as can be.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Costs, Instance, Plan, sorting::sort_by_key};

use super::{
    answer::{FactKind, Helps},
    group::{Group, without},
    group_mus::{CoreFound, Inquiry, Tried, group_mus_avoiding},
    repairs::{EditedPlan, Solver},
};
use crate::search::Proved;

/// Further sets that are looked for.
const MOST_FURTHER: usize = 2;
/// Facts of a large floor that are left out of the whole, each alone.
const MOST_MARKED: usize = 24;
/// Facts whose price is looked for: of those that help, and of the others.
const MOST_PRICED: usize = 6;

/// An instance that has no plan as asked for.
pub(crate) struct Refuted<'a> {
    pub(crate) instance: &'a Instance,
    /// The agents that are never left out.
    pub(crate) asked: &'a [usize],
    /// The horizon, where a person set one.
    pub(crate) deadline: Option<u32>,
    /// How far it is proved that there is no plan.
    pub(crate) reach: Proved,
}

/// Marks the facts of a minimal set that help, and adds further sets where none
/// does. Robots that are left out as a whole do not count: that nearly always
/// helps, and repairs nothing.
pub(crate) fn find_causes(refuted: &Refuted, core: &mut CoreFound, inquiry: &mut dyn Inquiry) {
    let mut trials = Trials {
        refuted,
        known: BTreeMap::new(),
    };
    trials.mark(core, inquiry);
    let mut counted: Vec<Group> = core.groups.clone();
    counted.retain(|group| group.kind() != FactKind::Task);
    if counted.is_empty() {
        counted.clone_from(&core.groups);
    }
    let helps = |group| core.helps.get(group) == Some(&Helps::Yes);
    if core.groups.is_empty() || counted.iter().any(helps) {
        return;
    }
    while core.further.len() < MOST_FURTHER && !inquiry.is_over() {
        let earlier: BTreeSet<Group> = core.sets().flatten().copied().collect();
        let earlier: Vec<Group> = earlier.into_iter().collect();
        let mut next = group_mus_avoiding(refuted, &earlier, inquiry);
        let is_new = |set: &[Group]| set.iter().any(|group| !next.groups.contains(group));
        let shares = |group: &Group| group.kind() != FactKind::Task && earlier.contains(group);
        // The first further set may share facts with earlier ones where no set avoids them; later
        // sets that share facts would only mix those before them.
        let is_mixed = !core.further.is_empty() && next.groups.iter().any(shares);
        if is_mixed || !core.sets().all(is_new) {
            return;
        }
        trials.mark(&mut next, inquiry);
        core.further.push(next);
    }
}

/// Marks facts of a minimal set that help, as many as are worth it on a large floor: those first that a
/// person would change first. Those that are marked already stay.
pub(crate) fn mark_causes(refuted: &Refuted, core: &mut CoreFound, inquiry: &mut dyn Inquiry) {
    for group in unmarked(core) {
        let helps = leave_out(refuted, group, inquiry, false);
        core.helps.insert(group, helps);
    }
}

/// Marks those facts without which a plan near to a known one is as asked for: that is soon looked at.
pub(crate) fn mark_near_causes(
    refuted: &Refuted,
    core: &mut CoreFound,
    plan: &Plan,
    solver: &mut dyn Solver,
) {
    for group in unmarked(core) {
        if solver.is_over() {
            return;
        }
        let variant = without(refuted.instance, &[group].into(), refuted.deadline);
        if solver.near_to(plan, &variant).is_some() {
            core.helps.insert(group, Helps::Yes);
        }
    }
}

fn unmarked(core: &CoreFound) -> Vec<Group> {
    let mut groups = changed_first(core);
    groups.retain(|group| !core.helps.contains_key(group));
    groups.truncate(MOST_MARKED);
    groups
}

/// The facts of a set, those first that a person would change first.
fn changed_first(core: &CoreFound) -> Vec<Group> {
    let mut groups = core.groups.clone();
    sort_by_key(&mut groups, |group| match group {
        Group::Constraint(_) | Group::Deadline | Group::Floor | Group::Breakdown(..) => 0,
        Group::Waypoint(..) => 1,
        Group::Battery(_) => 2,
        Group::Slow => 3,
        Group::Task(_) => 4,
        Group::Stay(_) => 5,
        Group::Obstacle(_) => 6,
        Group::Collision(..) => 7,
    });
    groups
}

/// Finds what the whole instance costs without a fact: of those that help, and where a plan as
/// asked for costs more (`is_costly`), what is left without one of the others. `whole` gives the
/// costs of the whole plan.
pub(crate) fn find_prices(
    refuted: &Refuted,
    core: &mut CoreFound,
    solver: &mut dyn Solver,
    is_costly: bool,
    whole: impl Fn(&EditedPlan) -> Costs,
) {
    let helps = |group: &Group| core.helps.get(group) == Some(&Helps::Yes);
    let (helping, others): (Vec<Group>, Vec<Group>) =
        changed_first(core).into_iter().partition(helps);
    let is_open = |group: &Group| !core.prices.contains_key(group);
    let helping: Vec<Group> = helping.into_iter().filter(is_open).collect();
    let others = others.into_iter().filter(|_| is_costly);
    let helping = helping.into_iter().take(MOST_PRICED);
    for group in helping.chain(others.take(MOST_PRICED)) {
        if solver.is_over() {
            return;
        }
        let left_out = BTreeSet::from([group]);
        let variant = without(refuted.instance, &left_out, refuted.deadline);
        let found = if core.helps.get(&group) == Some(&Helps::Yes) {
            solver.best(&variant)
        } else {
            solver.cheapest(&variant)
        };
        if let Some(found) = found {
            core.prices.insert(group, (whole(&found), found.proved));
        }
    }
}

/// Facts that were left out of the whole instance, each alone.
struct Trials<'a> {
    refuted: &'a Refuted<'a>,
    known: BTreeMap<Group, Helps>,
}

impl Trials<'_> {
    fn mark(&mut self, core: &mut CoreFound, inquiry: &mut dyn Inquiry) {
        for &group in &core.groups {
            let trial = || leave_out(self.refuted, group, inquiry, true);
            let helps = *self.known.entry(group).or_insert_with(trial);
            core.helps.insert(group, helps);
        }
    }
}

/// Whether the whole instance without one fact has a plan; `again` where a search that was cut
/// off is made again with more work.
fn leave_out(refuted: &Refuted, group: Group, inquiry: &mut dyn Inquiry, again: bool) -> Helps {
    if inquiry.is_over() {
        return Helps::Unknown;
    }
    let left_out = BTreeSet::from([group]);
    let variant = without(refuted.instance, &left_out, refuted.deadline);
    let mut tried = inquiry.search(&variant).reaching(&variant, refuted.reach);
    if again && matches!(tried, Tried::Unknown) && !inquiry.is_over() {
        tried = inquiry
            .search_again(&variant)
            .reaching(&variant, refuted.reach);
    }
    match tried {
        Tried::Plan(_) => Helps::Yes,
        Tried::None { .. } => Helps::No,
        Tried::Unknown => Helps::Unknown,
    }
}
