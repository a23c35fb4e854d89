//! Either of two SAT solvers, as a host asks for: varisat, or batsat, which was written
//! apart from it. What a search answers must not depend on it.

use std::rc::Rc;

use batsat::{BasicSolver, SolverInterface, lbool};

use crate::{
    budget::{Budget, Stop},
    sat::{Lit, backend::Backend, placeholders::Freed, varisat::Varisat},
};

#[allow(clippy::large_enum_variant, reason = "there is one of it at a time")]
pub(in crate::sat) enum Either<'h> {
    Varisat(Varisat<'h>),
    Batsat(BasicSolver, Rc<Budget<'h>>),
}

impl<'h> Backend<'h> for Either<'h> {
    fn new(budget: Rc<Budget<'h>>, freed: Freed) -> Self {
        if budget.uses_second_solver() {
            Self::Batsat(BasicSolver::default(), budget)
        } else {
            Self::Varisat(Varisat::new(budget, freed))
        }
    }

    fn add_clause(&mut self, lits: &[Lit]) {
        match self {
            Self::Varisat(varisat) => varisat.add_clause(lits),
            Self::Batsat(batsat, _) => {
                let mut lits = all_outward(batsat, lits);
                batsat.add_clause_reuse(&mut lits);
            }
        }
    }

    fn solve(&mut self, assumptions: &[Lit]) -> Result<Option<Vec<Lit>>, Stop> {
        match self {
            Self::Varisat(varisat) => varisat.solve(assumptions),
            Self::Batsat(batsat, budget) => {
                let assumptions = all_outward(batsat, assumptions);
                let before = batsat.num_conflicts();
                let answer = batsat.solve_limited(&assumptions);
                let conflicts = batsat.num_conflicts() - before;
                budget.count_conflicts(conflicts);
                budget.count_derived(conflicts);
                budget.check()?;
                if answer == lbool::TRUE {
                    return Ok(None);
                }
                let core = batsat.unsat_core().iter();
                Ok(Some(core.map(|&lit| inward(lit)).collect()))
            }
        }
    }

    fn model(&self) -> impl Iterator<Item = Lit> {
        let lits: Vec<Lit> = match self {
            Self::Varisat(varisat) => varisat.model().collect(),
            Self::Batsat(batsat, _) => {
                let values = (0..).zip(batsat.get_model());
                let known = values.filter(|(_, value)| **value != lbool::UNDEF);
                known
                    .map(|(variable, value)| Lit::new(variable, *value == lbool::TRUE))
                    .collect()
            }
        };
        lits.into_iter()
    }
}

fn all_outward(batsat: &mut BasicSolver, lits: &[Lit]) -> Vec<batsat::Lit> {
    let lits = lits.iter().map(|lit| {
        let variable = batsat.var_of_int(lit.variable());
        batsat::Lit::new(variable, lit.is_positive())
    });
    lits.collect()
}

fn inward(lit: batsat::Lit) -> Lit {
    Lit::new(lit.var().idx(), lit.sign())
}
