//! Facts in groups, the deciding one first: each opens into its facts.

pub use giveway_solve::explain::GroupMark;
use giveway_solve::explain::{Core, FactGroup, group_price_clause};

use crate::{Asking, Lit, words};

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
    /// Its facts, by their places among the facts of its set: the first of many.
    pub facts: Vec<usize>,
    /// How many facts it has besides.
    pub more: usize,
}

/// So many facts of a group are listed: the obstacles of an aisle are told by its name, and light
/// up on the map.
const FACTS: usize = 8;

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
            title: words::unnested(&group.text),
            mark: group.mark(),
            price: price(asking, group),
            is_open: open == Some(index) && !asking.folds_groups,
            facts: {
                let listed = group.facts.iter().take(FACTS);
                listed.map(|&fact| fact as usize).collect()
            },
            more: group.facts.len().saturating_sub(FACTS),
        })
        .collect()
}

/// Whether the numbers on the map are those of the groups.
pub(crate) fn numbers_groups(asking: &Asking) -> bool {
    let core = asking.told.as_deref().and_then(|told| told.core.as_ref());
    core.is_some_and(|core| !core.groups.is_empty())
}

/// What is left without the best fact of a group, beside the plan that is asked about.
fn price(asking: &Asking, group: &FactGroup) -> Option<String> {
    group_price_clause(group, &asking.about.solved.costs?, asking.objective())
}
