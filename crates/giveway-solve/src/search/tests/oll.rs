//! Core-guided minimisation against trying all values.

use std::rc::Rc;

use crate::{
    SilentHost,
    budget::{Budget, Stop},
    sat::{Clauses, Lit, Outcome, Sat},
    search::oll::{Formula, Kept, Level, Oll, Soft},
};

/// The values that a number can have: from 0 on.
const VALUES: usize = 4;

/// A few numbers, and clauses over literals "this number is at most so much".
struct Numbers<'h> {
    sat: Sat<'h>,
    at_most: Vec<Vec<Lit>>,
}

impl<'h> Formula for Numbers<'h> {
    type Out = Sat<'h>;

    fn clauses(&mut self) -> &mut Sat<'h> {
        &mut self.sat
    }
}

/// A number is at most so much.
#[derive(Clone, Copy)]
struct AtMost {
    number: usize,
    most: usize,
}

impl Level for AtMost {
    fn raised(self, by: u32) -> Option<Self> {
        let most = self.most + by as usize;
        Some(Self { most, ..self })
    }
}

impl Kept<Numbers<'_>> for AtMost {
    fn literal(self, numbers: &mut Numbers) -> Result<Option<Lit>, Stop> {
        Ok(numbers.at_most[self.number].get(self.most).copied())
    }
}

/// A random clause: numbers, the most, and whether it is no more than that.
type Clause = Vec<(usize, usize, bool)>;

fn random_clauses(random: &mut fastrand::Rng, numbers: usize) -> Vec<Clause> {
    let literal = |random: &mut fastrand::Rng| {
        let most = random.usize(0..VALUES - 1);
        (random.usize(0..numbers), most, random.f32() < 0.3)
    };
    let count = random.usize(3..14);
    let clause = |random: &mut fastrand::Rng| {
        let length = random.usize(1..4);
        (0..length).map(|_| literal(random)).collect()
    };
    (0..count).map(|_| clause(random)).collect()
}

/// The least sum of the numbers, by trying all values; `None` where there are none.
fn least(clauses: &[Clause], numbers: usize) -> Option<usize> {
    let all = 0..VALUES.pow(numbers as u32);
    let values = all.map(|mut code| {
        let digit = |code: &mut usize| {
            let digit = *code % VALUES;
            *code /= VALUES;
            digit
        };
        (0..numbers).map(|_| digit(&mut code)).collect::<Vec<_>>()
    });
    let holds = |values: &[usize]| {
        let mut each = clauses.iter();
        each.all(|clause| {
            let mut literals = clause.iter();
            literals.any(|&(number, most, positive)| (values[number] <= most) == positive)
        })
    };
    let sums = values
        .filter(|values| holds(values))
        .map(|v| v.iter().sum());
    sums.min()
}

/// The same by cores.
fn least_by_cores(clauses: &[Clause], numbers: usize, totals_first: bool) -> Option<usize> {
    let budget = Rc::new(Budget::new(&SilentHost, crate::Limits::default()));
    let mut sat = Sat::new(budget);
    let number = |sat: &mut Sat| {
        let at_most: Vec<Lit> = (1..VALUES).map(|_| sat.fresh()).collect();
        for pair in at_most.windows(2) {
            sat.clause(&[!pair[0], pair[1]]);
        }
        at_most
    };
    let at_most: Vec<Vec<Lit>> = (0..numbers).map(|_| number(&mut sat)).collect();
    for clause in clauses {
        let literals = clause.iter().map(|&(number, most, positive)| {
            let lit = at_most[number][most];
            if positive { lit } else { !lit }
        });
        sat.clause(&literals.collect::<Vec<_>>());
    }
    let mut formula = Numbers { sat, at_most };
    let mut oll = Oll::new();
    for number in 0..numbers {
        let none = AtMost { number, most: 0 };
        oll.assume(&mut formula, Soft::Level(none)).unwrap();
    }
    let mut cores = 0;
    loop {
        match formula.sat.solve(&oll.assumptions(totals_first)).unwrap() {
            Outcome::Sat if oll.is_waiting() => {
                oll.begin_round(&mut formula).unwrap();
            }
            Outcome::Sat => break,
            Outcome::Unsat(core) if core.is_empty() => return None,
            Outcome::Unsat(core) => {
                oll.add_core(&mut formula, &core).unwrap();
                cores += 1;
            }
        }
    }
    // What is assumed in the end leaves exactly the best values.
    oll.harden(&mut formula);
    assert!(matches!(formula.sat.solve(&[]).unwrap(), Outcome::Sat));
    let is_more = |lit: &&Lit| !formula.sat.is_true(**lit);
    let sum = formula.at_most.iter().flatten().filter(is_more).count();
    assert_eq!(sum, cores, "each core pays for one");
    Some(cores)
}

#[test]
fn as_many_cores_as_the_least_sum() {
    let mut random = fastrand::Rng::with_seed(5);
    let (mut feasible, mut largest) = (0, 0);
    for round in 0..400 {
        let numbers = random.usize(1..6);
        let clauses = random_clauses(&mut random, numbers);
        let expect = least(&clauses, numbers);
        for totals_first in [false, true] {
            let found = least_by_cores(&clauses, numbers, totals_first);
            assert_eq!(found, expect, "round {round}: {clauses:?}");
        }
        feasible += usize::from(expect.is_some());
        largest = largest.max(expect.unwrap_or(0));
    }
    assert!(feasible > 200, "{feasible} can be solved");
    assert!(largest > 5, "the largest sum is {largest}");
}
