//! No variable of a formula is put into a place that another one left, where varisat
//! would choose among those that are free.

use std::collections::{BTreeMap, BTreeSet};

use crate::sat::{Lit, placeholders::Told};

/// How many of the freed places were taken again by placeholders, and how many by the
/// variables made for the formula. The proof of a session told each variable with the
/// place that it got, or that it lost its own.
pub(super) fn taken_again(told: &[Told], made: &[Lit]) -> (u32, u32) {
    let mut free = BTreeSet::new();
    let mut place_of = BTreeMap::new();
    let (mut taken, mut chosen) = (0, 0);
    for &(variable, place) in told {
        let Some(place) = place else {
            free.extend(place_of.remove(&variable));
            continue;
        };
        place_of.insert(variable, place);
        if free.remove(&place) {
            let of_formula = made.iter().any(|lit| lit.variable() == variable);
            *if of_formula { &mut chosen } else { &mut taken } += 1;
        }
    }
    (taken, chosen)
}
