//! The number of true literals of a set, in unary.
//!
//! The totalizer of Bailleux and Boufkhad (2003), in one direction: if k inputs
//! are true then so are the first k outputs. All outputs are kept: cutting them
//! short is unsound where a sum is asked beyond the cut.

use crate::{
    budget::Stop,
    sat::{Clauses, Lit},
};

/// Outputs over some inputs: output `k` (from 0) says "more than k are true".
///
/// # Errors
/// When the budget is spent.
pub(crate) fn totalizer(inputs: &[Lit], out: &mut impl Clauses) -> Result<Vec<Lit>, Stop> {
    capped(inputs, usize::MAX, out)
}

/// The same with at most `most` outputs: the last one says "at least that many".
///
/// # Errors
/// When the budget is spent.
pub(crate) fn capped(
    inputs: &[Lit],
    most: usize,
    out: &mut impl Clauses,
) -> Result<Vec<Lit>, Stop> {
    match inputs {
        [] => Ok(Vec::new()),
        [one] => Ok(vec![*one]),
        _ => {
            let (left, right) = inputs.split_at(inputs.len() / 2);
            let left = capped(left, most, out)?;
            let right = capped(right, most, out)?;
            merge(&left, &right, most, out)
        }
    }
}

/// Adds two unary numbers; outputs beyond `most` are left out, which is sound
/// only where the sum is bounded by less than `most` for good.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn merge(
    left: &[Lit],
    right: &[Lit],
    most: usize,
    out: &mut impl Clauses,
) -> Result<Vec<Lit>, Stop> {
    let size = (left.len() + right.len()).min(most);
    let sum: Vec<Lit> = (0..size).map(|_| out.fresh()).collect();
    for i in 0..=left.len() {
        out.check()?;
        for j in 0..=right.len() {
            let Some(&above) = (i + j).checked_sub(1).and_then(|k| sum.get(k)) else {
                continue;
            };
            let mut clause = Vec::with_capacity(3);
            clause.extend(i.checked_sub(1).map(|i| !left[i]));
            clause.extend(j.checked_sub(1).map(|j| !right[j]));
            clause.push(above);
            out.clause(&clause);
        }
    }
    // Unary numbers have no holes.
    for pair in sum.windows(2) {
        out.clause(&[!pair[1], pair[0]]);
    }
    Ok(sum)
}
