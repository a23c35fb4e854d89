//! Encodings against arithmetic: every assignment of the inputs is tried.

mod at_most_one;
mod battery;
mod count;
mod limit;
mod totalizer;

use std::rc::Rc;

use crate::{
    Limits, SilentHost,
    budget::Budget,
    sat::{Clauses, Lit, Outcome, Sat},
};

/// A solver without limits.
fn solver() -> Sat<'static> {
    Sat::new(Rc::new(Budget::new(&SilentHost, Limits::default())))
}

/// Whether the clauses so far can hold together with some literals.
fn can(sat: &mut Sat, assumed: &[Lit]) -> bool {
    matches!(sat.solve(assumed).unwrap(), Outcome::Sat)
}

/// Some new variables.
fn fresh(sat: &mut Sat, number: usize) -> Vec<Lit> {
    (0..number).map(|_| sat.fresh()).collect()
}

/// The literal as it is, or negated.
fn literal(lit: Lit, holds: bool) -> Lit {
    if holds { lit } else { !lit }
}

/// The literals as the bits of a number say, the first by the lowest.
fn as_bits(lits: &[Lit], bits: u32) -> Vec<Lit> {
    let lits = lits.iter().enumerate();
    lits.map(|(i, &lit)| literal(lit, bits >> i & 1 == 1))
        .collect()
}

/// The digits of a unary number: the first `value` of them hold.
fn as_unary(digits: &[Lit], value: usize) -> Vec<Lit> {
    let digits = digits.iter().enumerate();
    digits.map(|(i, &lit)| literal(lit, i < value)).collect()
}

/// All lists with an entry from 0 to each of the maxima.
fn each_list(maxima: &[usize]) -> Vec<Vec<usize>> {
    let mut lists = vec![Vec::new()];
    for &most in maxima {
        let longer =
            |list: Vec<usize>| (0..=most).map(move |last| [list.as_slice(), &[last]].concat());
        lists = lists.into_iter().flat_map(longer).collect();
    }
    lists
}

#[test]
fn lists_are_all() {
    let lists = each_list(&[1, 2]);
    let expect = [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2]];
    assert_eq!(lists, expect.map(Vec::from));
    assert_eq!(each_list(&[]), [Vec::<usize>::new()]);
}
