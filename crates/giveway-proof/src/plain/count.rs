//! Limits on how many of some literals hold: the totalizer (Bailleux and
//! Boufkhad 2003); and on what they weigh together: the generalized totalizer (Joshi,
//! Martins and Manquinho 2015).

use std::collections::BTreeMap;

use giveway_model::sorting;

use super::{Cnf, Lit, Name, NoFormula};

/// Names the variable that at least so many hold, or weigh so much.
pub(super) type Counts<'a> = &'a dyn Fn(u32) -> Name;

/// At most `most` of all literals hold.
///
/// With `sorted`, of each group the first ones hold, however many: no clauses
/// are needed to count within it. Ends early, with too few clauses, where there
/// are more than `limit`: the caller looks.
pub(super) fn at_most(
    cnf: &mut Cnf,
    name: Counts<'_>,
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
                [a, b] => merge(cnf, name, a, b, most + 1),
                rest => rest.concat(),
            });
        }
        counts = merged;
    }
    if let Some(&too_much) = counts.first().and_then(|count| count.get(most)) {
        cnf.clause([-too_much]);
    }
}

/// A literal that holds only where at least so many of all literals do, of each group the first ones; it
/// may not hold where they do. There are so many at least.
pub(super) fn at_least(
    cnf: &mut Cnf,
    name: Counts<'_>,
    groups: &[Vec<Lit>],
    least: usize,
    limit: usize,
) -> Lit {
    let mut counts = groups.to_vec();
    while counts.len() > 1 {
        let mut merged = Vec::new();
        for pair in counts.chunks(2) {
            merged.push(match pair {
                [a, b] if cnf.clauses() <= limit => split(cnf, name, a, b, least),
                rest => rest.concat(),
            });
        }
        counts = merged;
    }
    let enough = least
        .checked_sub(1)
        .and_then(|i| counts.first()?.get(i).copied());
    // So many there are not.
    enough.unwrap_or_else(|| {
        let never = cnf.variable(Name::Never);
        cnf.clause([-never]);
        never
    })
}

/// The sum of two counts the other way round: the i-th literal holds only where at least i do. A count may
/// say less than is so, never more.
fn split(cnf: &mut Cnf, name: Counts<'_>, a: &[Lit], b: &[Lit], most: usize) -> Vec<Lit> {
    let size = (a.len() + b.len()).min(most);
    let sum: Vec<Lit> = (1..=size).map(|n| cnf.variable(name(n as u32))).collect();
    for (n, &enough) in sum.iter().enumerate() {
        // More than n: more than i here, or more than n - i there.
        for i in 0..=n.min(a.len()) {
            if let Some(j) = n.checked_sub(i)
                && j <= b.len()
            {
                cnf.clause(
                    [Some(-enough), a.get(i).copied(), b.get(j).copied()]
                        .into_iter()
                        .flatten(),
                );
            }
        }
    }
    for pair in sum.windows(2) {
        cnf.implies(&[pair[1]], [pair[0]]);
    }
    sum
}

/// The sum of two counts, as far as it matters: the i-th literal (from 1) holds
/// where at least i do. A count may say more than is so, never less.
fn merge(cnf: &mut Cnf, name: Counts<'_>, a: &[Lit], b: &[Lit], most: usize) -> Vec<Lit> {
    let size = (a.len() + b.len()).min(most);
    let sum: Vec<Lit> = (1..=size).map(|n| cnf.variable(name(n as u32))).collect();
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

/// Literals by what they weigh: where some of what is weighed holds, the literal of its
/// whole weight does, and none of a higher weight has to.
pub(super) type Weights = BTreeMap<u32, Lit>;

/// What holds of all groups weighs at most `most`.
///
/// # Errors
/// Where there would be more clauses than `limit`: different weights have many sums.
pub(super) fn weigh_at_most(
    cnf: &mut Cnf,
    name: Counts<'_>,
    groups: &[Weights],
    most: u32,
    limit: usize,
) -> Result<(), NoFormula> {
    // More than the largest number nothing weighs.
    let Some(too_much) = most.checked_add(1) else {
        return Ok(());
    };
    let mut sums: Vec<Weights> = Vec::new();
    for group in groups {
        let mut sum = Weights::new();
        for (&weight, &lit) in group {
            sum.entry(weight.min(too_much)).or_insert(lit);
        }
        sums.push(sum);
    }
    while sums.len() > 1 {
        let mut added = Vec::new();
        for pair in sums.chunks(2) {
            let more = pair.iter().map(|sum| sum.len().saturating_add(1));
            let more = more.fold(1, usize::saturating_mul);
            if cnf.clauses().saturating_add(more) > limit {
                return Err(NoFormula::TooLarge);
            }
            added.push(match pair {
                [a, b] => add(cnf, name, a, b, too_much),
                rest => rest.first().cloned().unwrap_or_default(),
            });
        }
        sums = added;
    }
    if let Some(&lit) = sums.first().and_then(|sum| sum.get(&too_much)) {
        cnf.clause([-lit]);
    }
    Ok(())
}

/// The sum of two weights; all that is too much is one.
fn add(cnf: &mut Cnf, name: Counts<'_>, a: &Weights, b: &Weights, too_much: u32) -> Weights {
    let with_nothing = |weights: &Weights| -> Vec<(u32, Option<Lit>)> {
        let each = weights.iter().map(|(&weight, &lit)| (weight, Some(lit)));
        [(0, None)].into_iter().chain(each).collect()
    };
    let (a, b) = (with_nothing(a), with_nothing(b));
    let total = |i: u32, j: u32| i.saturating_add(j).min(too_much);
    let totals = a
        .iter()
        .flat_map(|&(i, _)| b.iter().map(move |&(j, _)| total(i, j)));
    let totals = sorting::set(totals.filter(|&total| total > 0));
    let sum: Weights = sorting::map(
        totals
            .into_iter()
            .map(|total| (total, cnf.variable(name(total)))),
    );
    for &(i, given) in &a {
        for &(j, other) in &b {
            if let Some(&enough) = sum.get(&total(i, j)) {
                let given: Vec<Lit> = given.into_iter().chain(other).collect();
                cnf.implies(&given, [enough]);
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use giveway_model::Cost;

    use super::*;

    /// Whether just these of some weighed literals may hold.
    fn allows(weights: &[u32], chosen: u32, most: u32) -> bool {
        let mut cnf = Cnf::default();
        let lits: Vec<Lit> = weights.iter().map(|_| cnf.variable(Name::Group)).collect();
        let groups: Vec<Weights> = weights
            .iter()
            .zip(&lits)
            .map(|(&w, &lit)| Weights::from([(w, lit)]))
            .collect();
        let name = |n| Name::AtLeast(Cost::Penalty, n);
        weigh_at_most(&mut cnf, &name, &groups, most, usize::MAX).unwrap();
        for (i, lit) in lits.iter().enumerate() {
            cnf.clause([if chosen >> i & 1 == 1 { *lit } else { -lit }]);
        }
        // The chosen literals decide all others by propagation, or contradict.
        let mut held: BTreeSet<Lit> = BTreeSet::new();
        loop {
            let before = held.len();
            for clause in cnf.iter() {
                let mut open = clause.iter().filter(|&&lit| !held.contains(&-lit));
                match (open.next(), open.next()) {
                    (None, _) => return false,
                    (Some(&lit), None) => drop(held.insert(lit)),
                    (Some(_), Some(_)) => {}
                }
            }
            if held.len() == before {
                return true;
            }
        }
    }

    #[test]
    fn what_weighs_too_much_is_excluded_and_nothing_else() {
        for weights in [
            vec![],
            vec![3],
            vec![2, 3, 3],
            vec![1, 5, 2, 7, 4],
            vec![1_000_000, 1, 2],
        ] {
            for chosen in 0..1 << weights.len() {
                let held = weights
                    .iter()
                    .enumerate()
                    .filter(|(i, _)| chosen >> i & 1 == 1);
                let weight: u32 = held.map(|(_, weight)| weight).sum();
                for most in [0, 1, 2, 4, 6, 9, 18, 1_000_001, u32::MAX] {
                    assert_eq!(
                        allows(&weights, chosen, most),
                        weight <= most,
                        "{weights:?} {chosen:b} {most}"
                    );
                }
            }
        }
    }

    #[test]
    fn weights_of_too_many_sums_are_refused_at_once() {
        let mut cnf = Cnf::default();
        let groups: Vec<Weights> = (0..40)
            .map(|n| {
                Weights::from([(
                    1 + (n * n * n * 7919) % 1_000_003,
                    cnf.variable(Name::Group),
                )])
            })
            .collect();
        let name = |n| Name::AtLeast(Cost::Penalty, n);
        let refused = weigh_at_most(&mut cnf, &name, &groups, 10_000_000, 100_000);
        assert_eq!(refused, Err(NoFormula::TooLarge));
        assert!(cnf.clauses() <= 100_000);
    }
}
