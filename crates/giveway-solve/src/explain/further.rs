//! What a minimal set says of the whole scene: which of its facts help when they alone
//! are left out, and which further sets rule a plan out as well.
//!
//! A minimal set is a claim about its facts alone. Leaving one of them out of the whole
//! scene helps only where no other set rules a plan out, so each is tried. Where none
//! helps, sets that share no fact with those before are looked for: disjoint sets, as
//! in the search for hitting sets (Reiter, 1987).

use std::collections::BTreeSet;

use giveway_model::Instance;

use super::{
    answer::FactKind,
    group::{Group, without},
    group_mus::{CoreFound, Inquiry, Tried, group_mus},
};

/// The most further sets.
const MOST_SETS: usize = 3;

/// Tries, for each fact of a set, the whole scene without that fact.
pub(crate) fn mark_helpful(
    instance: &Instance,
    deadline: Option<u32>,
    set: &mut CoreFound,
    inquiry: &mut dyn Inquiry,
) {
    let is_complete = set.reach.is_complete();
    let groups = set.groups.iter();
    let helps = groups.map(|&group| {
        let variant = without(instance, &BTreeSet::from([group]), deadline);
        match inquiry.search(&variant) {
            Tried::Plan(_) => Some(true),
            // A plan may need longer than the horizon of this search.
            Tried::None { reach, .. } if is_complete && !reach.is_complete() => None,
            Tried::None { .. } => Some(false),
            Tried::Unknown => None,
        }
    });
    set.helps = helps.collect();
}

/// Further sets that exclude a plan: of the facts that `first` and the sets before
/// have, each has only tasks of agents whose absence helps. There are none where
/// leaving out a single fact of `first` helps, tasks apart.
pub(crate) fn further_sets(
    instance: &Instance,
    asked: &[usize],
    deadline: Option<u32>,
    first: &CoreFound,
    inquiry: &mut dyn Inquiry,
) -> Vec<CoreFound> {
    let mut further: Vec<CoreFound> = Vec::new();
    let mut left_out = BTreeSet::new();
    if !leave_out(first, &mut left_out) {
        return further;
    }
    while further.len() < MOST_SETS {
        let refuted = inquiry.search(&without(instance, &left_out, deadline));
        let Some(mut set) = group_mus(instance, asked, deadline, &left_out, refuted, inquiry)
        else {
            break;
        };
        mark_helpful(instance, deadline, &mut set, inquiry);
        let is_new = leave_out(&set, &mut left_out);
        further.push(set);
        if !is_new {
            break;
        }
    }
    further
}

/// Leaves out the facts of a set, but for tasks that help. False where there are none,
/// or where another fact helps.
fn leave_out(set: &CoreFound, left_out: &mut BTreeSet<Group>) -> bool {
    let marked = || set.groups.iter().copied().zip(&set.helps);
    let is_task = |group: Group| group.kind() == FactKind::Task;
    if marked().any(|(group, helps)| *helps == Some(true) && !is_task(group)) {
        return false;
    }
    let before = left_out.len();
    left_out.extend(
        marked()
            .filter(|(_, helps)| **helps != Some(true))
            .map(|(group, _)| group),
    );
    left_out.len() > before
}
