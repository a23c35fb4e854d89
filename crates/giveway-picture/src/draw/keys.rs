//! What changes over time, as few keys: only where a straight line bends.

/// A key: when, in any unit, and the values then.
pub(super) type Key<const N: usize> = (f64, [f64; N]);

/// Less than this is not seen, in units.
const NOTHING: f64 = 0.01;

/// The keys of values that change evenly between them, without those that lie on the
/// line between others.
pub(super) fn bends<const N: usize>(keys: &[Key<N>]) -> Vec<Key<N>> {
    let mut kept: Vec<Key<N>> = Vec::new();
    for (index, key) in keys.iter().enumerate() {
        let is_needed = match (kept.last(), keys.get(index + 1)) {
            (Some(before), Some(after)) => !is_between(before, key, after),
            _ => true,
        };
        if is_needed {
            kept.push(*key);
        }
    }
    kept
}

fn is_between<const N: usize>(before: &Key<N>, key: &Key<N>, after: &Key<N>) -> bool {
    let span = after.0 - before.0;
    if span <= 0.0 {
        return false;
    }
    let share = (key.0 - before.0) / span;
    (0..N).all(|part| {
        let line = before.1[part] + (after.1[part] - before.1[part]) * share;
        (line - key.1[part]).abs() < NOTHING
    })
}

/// The values that stay until the next one, without those that change nothing.
pub(super) fn changes<T: PartialEq>(values: impl IntoIterator<Item = (f64, T)>) -> Vec<(f64, T)> {
    let mut kept: Vec<(f64, T)> = Vec::new();
    for value in values {
        if kept.last().is_none_or(|last| last.1 != value.1) {
            kept.push(value);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_way_has_two_keys() {
        let keys: Vec<Key<1>> = (0..9).map(|n| (f64::from(n), [f64::from(n)])).collect();
        assert_eq!(bends(&keys), [(0.0, [0.0]), (8.0, [8.0])]);
    }

    #[test]
    fn a_turn_and_a_wait_are_kept() {
        let keys = [
            (0.0, [0.0, 0.0]),
            (1.0, [100.0, 0.0]),
            (2.0, [100.0, 0.0]),
            (3.0, [100.0, 0.0]),
            (4.0, [100.0, 100.0]),
        ];
        let times: Vec<f64> = bends(&keys).iter().map(|key| key.0).collect();
        assert_eq!(times, [0.0, 1.0, 3.0, 4.0]);
    }

    #[test]
    fn what_slowly_turns_away_from_a_line_is_kept() {
        // Each key is near the line of its neighbours, all of them are a bow.
        let bow = |n: i32| (f64::from(n), [f64::from(n * n) * 0.008]);
        let keys: Vec<Key<1>> = (0..100).map(bow).collect();
        let kept = bends(&keys);
        for (time, [value]) in &keys {
            let after = kept.iter().position(|key| key.0 >= *time).unwrap();
            let (a, b) = (kept[after.saturating_sub(1)], kept[after]);
            let share = if b.0 > a.0 {
                (time - a.0) / (b.0 - a.0)
            } else {
                0.0
            };
            let line = a.1[0] + (b.1[0] - a.1[0]) * share;
            assert!((line - value).abs() < 1.0, "{time}: {line} {value}");
        }
    }

    #[test]
    fn what_stays_is_told_once() {
        let told = changes([(0.0, false), (1.0, false), (2.0, true), (3.0, true)]);
        assert_eq!(told, [(0.0, false), (2.0, true)]);
    }
}
