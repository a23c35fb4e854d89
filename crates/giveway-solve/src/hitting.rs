//! Smallest sets of things, by their numbers, that meet every core (hitting sets).

use std::collections::BTreeSet;

use crate::budget::{Budget, Stop};

/// Equally small sets that are looked at.
pub(crate) const MOST_SETS: usize = 1000;

/// All sets of so many that meet every core, in order; one too many where
/// there are more than are looked at.
pub(crate) fn hitting(
    cores: &[BTreeSet<usize>],
    size: usize,
    budget: &Budget,
) -> Result<BTreeSet<BTreeSet<usize>>, Stop> {
    let mut found = BTreeSet::new();
    extend(cores, size, &BTreeSet::new(), &mut found, budget)?;
    Ok(found)
}

/// A core that a set does not meet yet needs one of its numbers.
fn extend(
    cores: &[BTreeSet<usize>],
    size: usize,
    set: &BTreeSet<usize>,
    found: &mut BTreeSet<BTreeSet<usize>>,
    budget: &Budget,
) -> Result<(), Stop> {
    budget.tick()?;
    if found.len() > MOST_SETS {
        return Ok(());
    }
    let Some(missed) = cores.iter().find(|core| core.is_disjoint(set)) else {
        // A smaller set would have been found before.
        found.insert(set.clone());
        return Ok(());
    };
    if set.len() < size {
        for &number in missed {
            let mut larger = set.clone();
            larger.insert(number);
            extend(cores, size, &larger, found, budget)?;
        }
    }
    Ok(())
}
