//! varisat behind the interface of this folder.

use std::rc::Rc;

use varisat::{ExtendFormula, ProofFormat, Solver, config::SolverConfigUpdate};

use super::{Lit, backend::Backend, placeholders::Freed, proof_listener::ProofListener};
use crate::budget::{Budget, Stop};

/// Conflicts between restarts, times the Luby sequence: shorter than varisat's
/// own 128, which suits formulas whose conflicts lie close together.
const RESTART_INTERVAL: u64 = 30;

/// varisat, whose proof is read as it goes.
pub(super) struct Varisat<'h> {
    solver: Solver<'h>,
    budget: Rc<Budget<'h>>,
    buffer: Vec<varisat::Lit>,
}

impl<'h> Backend<'h> for Varisat<'h> {
    fn new(budget: Rc<Budget<'h>>, freed: Freed) -> Self {
        let mut solver = Solver::new();
        // Restarts are cheap beside the many short calls that a search makes.
        let mut config = SolverConfigUpdate::new();
        config.luby_restart_interval_scale = Some(RESTART_INTERVAL);
        let accepted = solver.config(&config);
        debug_assert!(accepted.is_ok(), "the interval is within its range");
        let listener = ProofListener::new(Rc::clone(&budget), freed);
        solver.write_proof(listener, ProofFormat::Varisat);
        Self {
            solver,
            budget,
            buffer: Vec::new(),
        }
    }

    fn add_clause(&mut self, lits: &[Lit]) {
        self.buffer.clear();
        self.buffer.extend(lits.iter().map(|&l| outward(l)));
        self.solver.add_clause(&self.buffer);
    }

    fn solve(&mut self, assumptions: &[Lit]) -> Result<Option<Vec<Lit>>, Stop> {
        self.buffer.clear();
        self.buffer.extend(assumptions.iter().map(|&l| outward(l)));
        self.solver.assume(&self.buffer);
        match self.solver.solve() {
            Ok(true) => Ok(None),
            Ok(false) => {
                let core = self.solver.failed_core().unwrap_or(&[]);
                Ok(Some(core.iter().map(|&l| inward(l)).collect()))
            }
            Err(_) => Err(self.budget.check().err().unwrap_or(Stop::Cancelled)),
        }
    }

    fn model(&self) -> impl Iterator<Item = Lit> {
        let model = self.solver.model().unwrap_or_default();
        model.into_iter().map(inward)
    }
}

fn outward(lit: Lit) -> varisat::Lit {
    varisat::Lit::from_index(lit.variable() as usize, lit.is_positive())
}

fn inward(lit: varisat::Lit) -> Lit {
    Lit::new(lit.index() as u32, lit.is_positive())
}
