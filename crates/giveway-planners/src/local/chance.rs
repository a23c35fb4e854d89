//! Random choices that are the same on every machine.
//!
//! The generator's own choices of a `usize` depend on how wide one is, so that a
//! browser would find other plans than the command.

use fastrand::Rng;

/// A number below `end`, which is not 0.
pub(crate) fn below(rng: &mut Rng, end: usize) -> usize {
    rng.u64(..end as u64) as usize
}

/// Brings a list into a random order.
pub(crate) fn shuffle<T>(rng: &mut Rng, list: &mut [T]) {
    for i in 1..list.len() {
        list.swap(i, below(rng, i + 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_choices_are_those_of_64_bits_everywhere() {
        let mut rng = Rng::with_seed(7);
        let mut list = [0, 1, 2, 3, 4, 5, 6, 7];
        shuffle(&mut rng, &mut list);
        assert_eq!(
            (list, below(&mut rng, 1000)),
            ([5, 6, 4, 0, 3, 2, 7, 1], 92)
        );
    }
}
