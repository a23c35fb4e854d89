//! Sums in unary.

use std::rc::Rc;

use super::{as_bits, as_unary, can, fresh, solver};
use crate::{
    Limits, SilentHost,
    budget::{Budget, Stop},
    encode::totalizer::{merge, totalizer},
    sat::Sat,
};

#[test]
fn outputs_count_the_inputs() {
    for size in 0..=8 {
        let mut sat = solver();
        let inputs = fresh(&mut sat, size);
        let outputs = totalizer(&inputs, &mut sat).unwrap();
        assert_eq!(outputs.len(), size);
        for bits in 0..1 << size {
            let given = as_bits(&inputs, bits);
            let count = bits.count_ones() as usize;
            for (k, &more) in outputs.iter().enumerate() {
                let at_most = can(&mut sat, &[given.as_slice(), &[!more]].concat());
                assert_eq!(at_most, count <= k, "{bits:b} of {size}, at most {k}");
            }
            let exact = [given, as_unary(&outputs, count)].concat();
            assert!(can(&mut sat, &exact), "{bits:b} of {size}");
        }
    }
}

#[test]
fn an_output_bounds_the_inputs_that_are_not_given() {
    let mut sat = solver();
    let inputs = fresh(&mut sat, 7);
    let outputs = totalizer(&inputs, &mut sat).unwrap();
    for (k, &more) in outputs.iter().enumerate() {
        for given in 0..=inputs.len() {
            let assumed = [&inputs[..given], &[!more]].concat();
            assert_eq!(can(&mut sat, &assumed), given <= k);
        }
    }
}

#[test]
fn outputs_have_no_holes() {
    let mut sat = solver();
    let inputs = fresh(&mut sat, 6);
    let outputs = totalizer(&inputs, &mut sat).unwrap();
    for (k, &more) in outputs.iter().enumerate() {
        for &fewer in &outputs[..k] {
            assert!(!can(&mut sat, &[more, !fewer]), "more than {k}");
        }
    }
}

/// Merges two numbers, and tries every pair of values below the cut.
fn check_merge(left: usize, right: usize, most: usize) {
    let mut sat = solver();
    let [a, b] = [left, right].map(|size| fresh(&mut sat, size));
    let sum = merge(&a, &b, most, &mut sat).unwrap();
    assert_eq!(sum.len(), (left + right).min(most));
    for i in 0..=left {
        for j in 0..=right {
            let given = [as_unary(&a, i), as_unary(&b, j)].concat();
            for (k, &more) in sum.iter().enumerate() {
                let at_most = can(&mut sat, &[given.as_slice(), &[!more]].concat());
                let what = format!("{i} of {left} + {j} of {right} at most {k}, cut at {most}");
                assert_eq!(at_most, i + j <= k, "{what}");
            }
            let exact = [given, as_unary(&sum, i + j)].concat();
            assert!(can(&mut sat, &exact), "{i} + {j}, cut at {most}");
        }
    }
}

#[test]
fn merging_adds() {
    for left in 0..=4 {
        for right in 0..=4 {
            check_merge(left, right, usize::MAX);
        }
    }
}

#[test]
fn a_cut_leaves_the_lower_outputs_right() {
    for most in 0..=7 {
        for (left, right) in [(0, 3), (3, 0), (1, 1), (2, 4), (4, 2), (3, 3)] {
            check_merge(left, right, most);
        }
    }
}

#[test]
fn a_large_sum_is_given_up_with_the_budget() {
    let budget = Budget::new(&SilentHost, Limits::default()).with_clauses(10_000);
    let budget = Rc::new(budget);
    let mut sat = Sat::new(Rc::clone(&budget));
    let [a, b] = [5_000, 5_000].map(|size| fresh(&mut sat, size));
    assert_eq!(merge(&a, &b, usize::MAX, &mut sat), Err(Stop::Conflicts));
    assert!(budget.given() < 20_000, "{}", budget.given());
}
