//! Sorting, and sets and maps of many things at once, in little code.
//!
//! The standard library's sort is compiled for each type of entry anew, some six
//! kilobytes each time; so is a map or a set that is collected, which sorts first.
//! In a page that is loaded over a network this is most of what they cost. Here
//! one list of indices is sorted for all types.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// Sorts; equal entries stay in their order.
///
/// ```
/// use giveway_model::sorting::sort;
/// let mut words = ["c", "a", "b"];
/// sort(&mut words);
/// assert_eq!(words, ["a", "b", "c"]);
/// ```
pub fn sort<T: Ord>(entries: &mut [T]) {
    sort_by(entries, T::cmp);
}

/// Sorts by a key; entries with equal keys stay in their order.
pub fn sort_by_key<T, K: Ord>(entries: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(entries, |a, b| key(a).cmp(&key(b)));
}

/// Sorts by a comparison; equal entries stay in their order.
pub fn sort_by<T>(entries: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let mut order = ordered(
        entries.len(),
        &|i, j| match (entries.get(i), entries.get(j)) {
            (Some(a), Some(b)) => compare(a, b),
            _ => Ordering::Equal,
        },
    );
    // The item of a place may have been moved on by an earlier exchange.
    for place in 0..order.len() {
        let mut from = order[place];
        while from < place {
            from = order[from];
        }
        order[place] = from;
        entries.swap(place, from);
    }
}

/// The indices below a number, sorted.
#[inline(never)]
fn ordered(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&i, &j| compare(i, j));
    order
}

/// A set of entries.
pub fn set<T: Ord>(entries: impl IntoIterator<Item = T>) -> BTreeSet<T> {
    let mut set = BTreeSet::new();
    for entry in entries {
        set.insert(entry);
    }
    set
}

/// A map of entries; of equal keys the last one counts.
pub fn map<K: Ord, V>(entries: impl IntoIterator<Item = (K, V)>) -> BTreeMap<K, V> {
    let mut map = BTreeMap::new();
    for (key, value) in entries {
        map.insert(key, value);
    }
    map
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All lists of some length of a few numbers, each with its index.
    fn lists(length: u32) -> impl Iterator<Item = Vec<(u32, u32)>> {
        (0..4_u32.pow(length)).map(move |code| {
            let digit = |i| (code / 4_u32.pow(i)) % 4;
            (0..length).map(|i| (digit(i), i)).collect()
        })
    }

    #[test]
    fn lists_are_sorted_and_equals_stay_in_order() {
        for length in 0..6 {
            for list in lists(length) {
                let mut ours = list.clone();
                sort_by_key(&mut ours, |entry| entry.0);
                let mut theirs = list;
                theirs.sort_by_key(|entry| entry.0);
                assert_eq!(ours, theirs);
            }
        }
    }

    #[test]
    fn entries_that_cannot_be_copied_are_moved() {
        let mut names: Vec<String> = (0..200_u32).map(|i| (i * 77 % 200).to_string()).collect();
        let mut expected = names.clone();
        sort(&mut names);
        expected.sort();
        assert_eq!(names, expected);
    }

    #[test]
    fn sets_and_maps_are_those_that_are_collected() {
        let entries = [(3, 'a'), (1, 'b'), (3, 'c')];
        assert_eq!(map(entries), entries.into_iter().collect());
        assert_eq!(set(entries), entries.into_iter().collect());
    }
}
