//! A growing sum below a limit.

use super::{as_unary, can, each_list, fresh, solver};
use crate::{encode::limit::SumLimit, sat::Lit};

/// Adds numbers of so many digits, one by one; of all values just those hold
/// whose sum is within the limit, after each number.
fn check(sizes: &[usize]) {
    for most in 0..=sizes.iter().sum::<usize>() + 1 {
        let mut sat = solver();
        let mut limit = SumLimit::new(most);
        assert_eq!(limit.most(), most);
        let mut numbers: Vec<Vec<Lit>> = Vec::new();
        for &size in sizes {
            let digits = fresh(&mut sat, size);
            limit.add(&digits, &mut sat).unwrap();
            numbers.push(digits);
            for values in each_list(&sizes[..numbers.len()]) {
                let pairs = numbers.iter().zip(&values);
                let given: Vec<Lit> = pairs.flat_map(|(n, &v)| as_unary(n, v)).collect();
                let within = values.iter().sum::<usize>() <= most;
                assert_eq!(can(&mut sat, &given), within, "{values:?} of {most}");
            }
        }
    }
}

#[test]
fn numbers_of_one_digit() {
    check(&[1, 1, 1, 1, 1, 1]);
}

#[test]
fn numbers_of_several_digits() {
    check(&[2, 3, 1, 2]);
    check(&[4, 4]);
}

#[test]
fn numbers_without_digits_add_nothing() {
    check(&[0, 2, 0, 1]);
}
