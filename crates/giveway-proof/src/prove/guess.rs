//! What a SAT solver says where nobody relies on it: which lemmas are worth a proof.

use std::io::{self, Write};

use varisat::{ExtendFormula as _, Lit as VarisatLit, ProofFormat, Solver};

use crate::Budget;
use crate::plain::{Cnf, Lit};

/// How often a core is made smaller.
const TRIMS: usize = 6;

/// The result of a call.
pub(crate) enum Guess {
    /// What holds in a model, in the order of the variables.
    Model(Vec<Lit>),
    /// Assumptions that exclude each other.
    Core(Vec<Lit>),
}

/// A formula that is solved under assumptions again and again.
pub(crate) struct Guesser<'a> {
    solver: Solver<'a>,
}

impl<'a> Guesser<'a> {
    pub(crate) fn new(formula: &Cnf, budget: &Budget<'a>) -> Self {
        let mut solver = Solver::new();
        // It is written only so that it can be stopped.
        let watched = Watched {
            budget: *budget,
            left: budget.proof_bytes,
        };
        solver.write_proof(watched, ProofFormat::Varisat);
        for clause in formula.iter() {
            solver.add_clause(&inward(clause));
        }
        Self { solver }
    }

    /// Solves under assumptions; `None` where the budget ran out.
    pub(crate) fn guess(&mut self, assumptions: &[Lit]) -> Option<Guess> {
        let mut assumed = inward(assumptions);
        let mut core: Option<Vec<VarisatLit>> = None;
        // Each call under a core alone may make it smaller.
        for _ in 0..TRIMS {
            self.solver.assume(&assumed);
            if self.solver.solve().ok()? {
                break;
            }
            let smaller = self.solver.failed_core()?.to_vec();
            let is_same = smaller.len() == assumed.len();
            assumed = smaller.iter().rev().copied().collect();
            core = Some(smaller);
            if is_same {
                break;
            }
        }
        Some(match core {
            Some(core) => Guess::Core(outward(&core)),
            None => Guess::Model(outward(&self.solver.model()?)),
        })
    }

    /// Whether assumptions exclude each other; `None` where the budget ran out.
    pub(crate) fn excludes(&mut self, assumptions: &[Lit]) -> Option<bool> {
        self.solver.assume(&inward(assumptions));
        Some(!self.solver.solve().ok()?)
    }
}

fn inward(lits: &[Lit]) -> Vec<VarisatLit> {
    let lits = lits.iter();
    lits.map(|&lit| VarisatLit::from_dimacs(lit as isize))
        .collect()
}

fn outward(lits: &[VarisatLit]) -> Vec<Lit> {
    let lits = lits.iter();
    // They came from literals of this size.
    lits.map(|lit| Lit::try_from(lit.to_dimacs()).unwrap_or_default())
        .collect()
}

/// A proof that nobody keeps, but whose length is the work that was done.
struct Watched<'a> {
    budget: Budget<'a>,
    /// The bytes that may still be written.
    left: usize,
}

impl Write for Watched<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let left = self.left.checked_sub(bytes.len());
        match left.filter(|_| (self.budget.go_on)()) {
            Some(left) => {
                self.left = left;
                Ok(bytes.len())
            }
            None => Err(io::Error::other("the budget is spent")),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
