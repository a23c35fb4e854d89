//! At most one, while the set grows.

use super::{as_bits, can, solver};
use crate::{encode::at_most_one::AtMostOne, sat::Clauses};

#[test]
fn exactly_the_assignments_with_at_most_one_hold() {
    let mut sat = solver();
    let mut one = AtMostOne::default();
    let mut set = Vec::new();
    // Three groups are closed on the way.
    for _ in 0..13 {
        let lit = sat.fresh();
        one.add(lit, &mut sat);
        set.push(lit);
        for bits in 0..1_u32 << set.len() {
            let holds = can(&mut sat, &as_bits(&set, bits));
            assert_eq!(holds, bits.count_ones() <= 1, "{bits:b} of {}", set.len());
        }
    }
}

#[test]
fn a_large_set_excludes_all_pairs_and_nothing_else() {
    let mut sat = solver();
    let mut one = AtMostOne::default();
    let set = super::fresh(&mut sat, 60);
    for &lit in &set {
        one.add(lit, &mut sat);
    }
    for (i, &lit) in set.iter().enumerate() {
        let mut alone: Vec<_> = set.iter().map(|&other| !other).collect();
        alone[i] = lit;
        assert!(can(&mut sat, &alone), "{i} alone");
        for (j, &other) in set[..i].iter().enumerate() {
            assert!(!can(&mut sat, &[lit, other]), "{i} and {j}");
        }
    }
}
