//! Facts in groups, the deciding one first: each opens into its facts.

use giveway_model::{Cost, tr};
use giveway_solve::explain::{Core, FactGroup, FactGroupKind, Helps};

use crate::{Asking, Lit};

/// A group of facts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroupRow {
    /// Its place among the groups, by which it lights up.
    pub index: usize,
    /// Its number on the map, from 1.
    pub number: usize,
    /// What it is about.
    pub title: String,
    /// Whether it is needed, or would help.
    pub mark: GroupMark,
    /// What a plan would cost without its best fact, in words.
    pub price: Option<String>,
    /// Whether it is lit up, and open.
    pub is_open: bool,
    /// Its facts, by their places among the facts of its set.
    pub facts: Vec<usize>,
}

/// What is known of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupMark {
    /// Leaving one of its facts out alone would help.
    Helps,
    /// It is needed among the others.
    Needed,
    /// It may not be needed.
    Open,
}

/// The groups of a set.
pub(super) fn groups(asking: &Asking, core: &Core) -> Vec<GroupRow> {
    let lit = match asking.lit {
        Some(Lit::Group(index)) => Some(index),
        Some(Lit::Witness(_) | Lit::Fact(_) | Lit::Robot(_) | Lit::Cell(_)) | None => None,
    };
    // The deciding one is open until another is.
    let open = lit.or_else(|| asking.lit.is_none().then_some(0));
    let groups = core.groups.iter().enumerate();
    groups
        .map(|(index, group)| GroupRow {
            index,
            number: index + 1,
            title: group.text.clone(),
            mark: mark(group),
            price: price(asking, group),
            is_open: open == Some(index) && !asking.folds_groups,
            facts: group.facts.iter().map(|&fact| fact as usize).collect(),
        })
        .collect()
}

/// Whether the numbers on the map are those of the groups.
pub(crate) fn numbers_groups(asking: &Asking) -> bool {
    let core = asking.told.as_deref().and_then(|told| told.core.as_ref());
    core.is_some_and(|core| !core.groups.is_empty())
}

pub(crate) fn mark(group: &FactGroup) -> GroupMark {
    match group.helps {
        Helps::Yes => GroupMark::Helps,
        Helps::No | Helps::Unknown if group.needed => GroupMark::Needed,
        Helps::No | Helps::Unknown => GroupMark::Open,
    }
}

/// What is left without the best fact of a group, beside the plan that is asked about: the first
/// cost that differs.
fn price(asking: &Asking, group: &FactGroup) -> Option<String> {
    let price = group.price.as_ref()?;
    let before = asking.about.solved.costs?;
    let costs = asking.objective().costs().iter().copied();
    let delta = |cost: Cost| i64::from(price.costs.get(cost)) - i64::from(before.get(cost));
    let delta = costs.map(delta).find(|&delta| delta != 0).unwrap_or(0);
    let is_of_one = match group.kind {
        FactGroupKind::Agent | FactGroupKind::Rule => true,
        FactGroupKind::Agents
        | FactGroupKind::Collisions
        | FactGroupKind::Aisle
        | FactGroupKind::Shelf
        | FactGroupKind::Shelves
        | FactGroupKind::Rules => false,
    };
    Some(match (delta, is_of_one) {
        (0, true) => tr!("without it the same cost").to_owned(),
        (0, false) => tr!("without one of these the same cost").to_owned(),
        (n, true) if n > 0 => tr!("without it still {n} more", n),
        (n, false) if n > 0 => tr!("without one of these still {n} more", n),
        (n, true) => tr!("without it {n} less", n = n.unsigned_abs()),
        (n, false) => tr!("without one of these {n} less", n = n.unsigned_abs()),
    })
}
