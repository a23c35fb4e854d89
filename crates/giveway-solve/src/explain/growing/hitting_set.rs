//! A smallest hitting set: numbers of which each given set has one.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use giveway_model::sorting::sort_by_key;

/// Partial sets that are looked at for one size.
const MOST_STATES: usize = 100_000;

/// A smallest set of at most so many numbers that has one of each of `sets`; of several, one
/// with numbers that many sets have. `None` where there is none, or it is not found in time.
pub(super) fn hitting_set(sets: &[BTreeSet<usize>], most: usize) -> Option<BTreeSet<usize>> {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for &number in sets.iter().flatten() {
        *counts.entry(number).or_default() += 1;
    }
    let mut smallest_first: Vec<Vec<usize>> = Vec::new();
    for set in sets {
        let mut numbers: Vec<usize> = set.iter().copied().collect();
        sort_by_key(&mut numbers, |number| Reverse(counts.get(number).copied()));
        smallest_first.push(numbers);
    }
    sort_by_key(&mut smallest_first, Vec::len);
    for size in 0..=most {
        let mut search = Search {
            sets: &smallest_first,
            chosen: BTreeSet::new(),
            left: MOST_STATES,
        };
        if search.complete(size) {
            return Some(search.chosen);
        }
        if search.left == 0 {
            return None;
        }
    }
    None
}

struct Search<'a> {
    sets: &'a [Vec<usize>],
    chosen: BTreeSet<usize>,
    left: usize,
}

impl Search<'_> {
    /// Whether so many more numbers hit all sets; they are among the chosen ones then.
    fn complete(&mut self, more: usize) -> bool {
        let mut sets = self.sets.iter();
        let is_missed = |set: &&Vec<usize>| !set.iter().any(|it| self.chosen.contains(it));
        let Some(missed) = sets.find(is_missed) else {
            return true;
        };
        if more == 0 {
            return false;
        }
        for &number in missed {
            if self.left == 0 {
                return false;
            }
            self.left -= 1;
            self.chosen.insert(number);
            if self.complete(more - 1) {
                return true;
            }
            self.chosen.remove(&number);
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every subset by its bits.
    fn by_brute_force(sets: &[BTreeSet<usize>], numbers: usize) -> Option<u32> {
        let hits = |bits: u32| {
            let mut sets = sets.iter();
            sets.all(|set| set.iter().any(|&number| bits & (1 << number) != 0))
        };
        (0..1_u32 << numbers)
            .filter(|&bits| hits(bits))
            .map(u32::count_ones)
            .min()
    }

    #[test]
    fn no_smaller_set_hits_all() {
        let mut rng = fastrand::Rng::with_seed(7);
        for _ in 0..400 {
            let sets: Vec<BTreeSet<usize>> = (0..rng.usize(0..7))
                .map(|_| (0..rng.usize(0..5)).map(|_| rng.usize(0..8)).collect())
                .collect();
            let found = hitting_set(&sets, 8);
            let size = found.as_ref().map(|set| set.len() as u32);
            assert_eq!(size, by_brute_force(&sets, 8), "{sets:?}");
            let found = found.unwrap_or_default();
            let missed = sets.iter().filter(|set| set.is_disjoint(&found)).count();
            assert!(size.is_none() || missed == 0, "{sets:?} {found:?}");
        }
    }
}
