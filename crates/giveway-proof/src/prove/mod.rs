//! Proofs of formulas: the only place here that knows a SAT solver.
//!
//! varisat writes DRAT as long as nothing is assumed and no clause is added
//! after the first call; a plain formula needs neither.

pub(crate) mod guess;

use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

use varisat::{ExtendFormula as _, Lit, ProofFormat, Solver};

use crate::{Budget, plain::Cnf};

/// The result for a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It is unsatisfiable: the proof, in the text form of DRAT.
    Proof(Vec<u8>),
    /// It is satisfiable: there is no proof.
    Satisfiable,
    /// The budget ran out first.
    Stopped,
}

/// Proves that a formula is unsatisfiable. The same formula gives the same
/// proof, unless the budget ends the work.
pub fn prove(formula: &Cnf, budget: &Budget<'_>) -> Outcome {
    let proof = Rc::new(RefCell::new(Vec::new()));
    let mut solver = Solver::new();
    solver.write_proof(
        Sink {
            proof: Rc::clone(&proof),
            budget: *budget,
        },
        ProofFormat::Drat,
    );
    for clause in formula.iter() {
        let clause: Vec<Lit> = clause
            .iter()
            .map(|&lit| Lit::from_dimacs(lit as isize))
            .collect();
        solver.add_clause(&clause);
    }
    let result = solver.solve();
    drop(solver);
    match result {
        Ok(true) => Outcome::Satisfiable,
        Ok(false) => Outcome::Proof(proof.take()),
        Err(_) => Outcome::Stopped,
    }
}

/// Where the proof goes. It fails when the budget is spent, which is the only
/// way to interrupt the solver.
struct Sink<'a> {
    proof: Rc<RefCell<Vec<u8>>>,
    budget: Budget<'a>,
}

impl Write for Sink<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut proof = self.proof.borrow_mut();
        if proof.len() + bytes.len() > self.budget.proof_bytes || !(self.budget.go_on)() {
            return Err(io::Error::other("the budget is spent"));
        }
        proof.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
