//! Limits on how many of some literals hold: the totalizer (Bailleux and
//! Boufkhad 2003).

use giveway_model::Cost;

use super::{Cnf, Lit, Name};

/// At most `most` of all literals hold.
///
/// With `sorted`, of each group the first ones hold, however many: no clauses
/// are needed to count within it. Ends early, with too few clauses, where there
/// are more than `limit`: the caller looks.
pub(super) fn at_most(
    cnf: &mut Cnf,
    cost: Cost,
    groups: &[Vec<Lit>],
    sorted: bool,
    most: usize,
    limit: usize,
) {
    let mut counts: Vec<Vec<Lit>> = if sorted {
        groups.to_vec()
    } else {
        groups.iter().flatten().map(|&lit| vec![lit]).collect()
    };
    while counts.len() > 1 {
        let mut merged = Vec::new();
        for pair in counts.chunks(2) {
            if cnf.clauses() > limit {
                return;
            }
            merged.push(match pair {
                [a, b] => merge(cnf, cost, a, b, most + 1),
                rest => rest.concat(),
            });
        }
        counts = merged;
    }
    if let Some(&too_much) = counts.first().and_then(|count| count.get(most)) {
        cnf.clause([-too_much]);
    }
}

/// The sum of two counts, as far as it matters: the i-th literal (from 1) holds
/// where at least i do. A count may say more than is so, never less.
fn merge(cnf: &mut Cnf, cost: Cost, a: &[Lit], b: &[Lit], most: usize) -> Vec<Lit> {
    let size = (a.len() + b.len()).min(most);
    let sum: Vec<Lit> = (1..=size)
        .map(|n| cnf.variable(Name::AtLeast(cost, n as u32)))
        .collect();
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            let Some(&enough) = (i + j).checked_sub(1).and_then(|n| sum.get(n)) else {
                continue;
            };
            let given = i.checked_sub(1).map(|i| a[i]);
            let given = given.into_iter().chain(j.checked_sub(1).map(|j| b[j]));
            let given: Vec<Lit> = given.collect();
            cnf.implies(&given, [enough]);
        }
    }
    sum
}
