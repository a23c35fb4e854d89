//! A second SAT solver, batsat: built anew for each question, and asked only
//! whether clauses can hold together.

use batsat::{BasicSolver, Lit, SolverInterface, lbool};

/// Whether all clauses can hold, each given by numbers from 1, negative for a
/// negated variable.
pub(super) fn satisfiable<'a>(clauses: impl IntoIterator<Item = &'a [i32]>) -> bool {
    let mut solver = BasicSolver::default();
    for clause in clauses {
        let lits = clause.iter();
        let mut lits: Vec<Lit> = lits
            .map(|&lit| Lit::new(solver.var_of_int(lit.unsigned_abs()), lit > 0))
            .collect();
        solver.add_clause_reuse(&mut lits);
    }
    let answer = solver.solve_limited(&[]);
    assert!(answer == lbool::TRUE || answer == lbool::FALSE);
    answer == lbool::TRUE
}

#[test]
fn it_tells_the_two_apart() {
    assert!(satisfiable([]));
    assert!(satisfiable([&[1, 2][..], &[-1]]));
    assert!(!satisfiable([&[1, 2][..], &[-1], &[-2]]));
    assert!(!satisfiable([&[][..]]));
}
