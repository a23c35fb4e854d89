//! A SAT solver, incremental, metered, and with cores that are true.

use std::rc::Rc;

use super::backend::Backend;
use super::placeholders::{Freed, Placeholders};
#[cfg(test)]
use super::tests::either::Either as Engine;
#[cfg(not(test))]
use super::varisat::Varisat as Engine;
use super::{Clauses, Core, Lit};
use crate::budget::MemoryUse;
use crate::budget::{Budget, Stop};

/// Bytes that varisat takes for a clause beside its literals, and for a
/// variable; measured with a margin.
const CLAUSE_BYTES: usize = 48;
const LITERAL_BYTES: usize = 8;
const VARIABLE_BYTES: usize = 96;

/// Calls that a core may take to be verified and made smaller, and how many of
/// them a core may take that stays large: it mostly remains so.
const MOST_TRIMS: usize = 40;
const TRIMS_OF_LARGE: usize = 6;
/// The literals of a large core.
const LARGE_CORE: usize = 12;

/// The end of a call.
#[derive(Debug)]
pub(crate) enum Outcome {
    /// There is a model; [`Sat::is_true`] reads it.
    Sat,
    /// These assumptions cannot hold together. They were verified: a call with
    /// just them was unsatisfiable.
    Unsat(Core),
}

/// An incremental solver.
///
/// Legal order: variables and clauses may be added at any time; a model may be
/// read from a call that ended with [`Outcome::Sat`] until the next call. After
/// a call ended with [`Stop`] no further call succeeds.
pub(crate) struct Sat<'h> {
    solver: Engine<'h>,
    budget: Rc<Budget<'h>>,
    variables: u32,
    placeholders: Placeholders,
    held: MemoryUse,
    model: Vec<bool>,
    verify: bool,
    /// Literals of the last core that are known to be needed in it.
    pub(super) needed: Vec<Lit>,
    /// The literals of the last core as varisat stated it.
    stated: usize,
}

impl<'h> Sat<'h> {
    pub(crate) fn new(budget: Rc<Budget<'h>>) -> Self {
        let freed = Freed::default();
        let solver = Engine::new(Rc::clone(&budget), freed.clone());
        Self {
            solver,
            budget,
            variables: 0,
            placeholders: Placeholders::new(freed),
            held: MemoryUse::default(),
            model: Vec::new(),
            verify: true,
            needed: Vec::new(),
            stated: 0,
        }
    }

    /// A solver that hands varisat's cores on as they are, or lets varisat choose the
    /// places of variables.
    #[cfg(test)]
    pub(super) fn with_care(budget: Rc<Budget<'h>>, care: super::tests::Care) -> Self {
        let mut sat = Self::new(budget);
        sat.verify = care.verify;
        sat.placeholders.in_use = care.placeholders;
        sat
    }

    /// Solves under assumptions.
    ///
    /// # Errors
    /// When the budget is spent; the solver is lost then.
    pub(crate) fn solve(&mut self, assumptions: &[Lit]) -> Result<Outcome, Stop> {
        if let Some(core) = self.refute(assumptions)? {
            return Ok(Outcome::Unsat(core));
        }
        self.read_model();
        Ok(Outcome::Sat)
    }

    /// Solves under assumptions, for the core alone: `None` where there is a
    /// model, which is not read, as that takes long in a large formula.
    ///
    /// # Errors
    /// When the budget is spent; the solver is lost then.
    pub(crate) fn refute(&mut self, assumptions: &[Lit]) -> Result<Option<Core>, Stop> {
        let Some(mut core) = self.call(assumptions)? else {
            return Ok(None);
        };
        self.needed.clear();
        self.stated = core.len();
        if !self.verify {
            return Ok(Some(Core::proved(core)));
        }
        self.trim(assumptions, &mut core).map(Some)
    }

    /// Verifies a core, and makes it smaller on the way.
    ///
    /// varisat's core can be too small (its conflict analysis may leave marks
    /// behind), though its verdicts are right. So a core counts only once a
    /// call under just that core was unsatisfiable. Such calls are cheap, and
    /// each tells more: assumptions are made one after the other, so the last
    /// one of the core is needed with those before it. Put first from then on,
    /// it leaves the place of the last one to another, until all are needed.
    fn trim(&mut self, assumptions: &[Lit], core: &mut Vec<Lit>) -> Result<Core, Stop> {
        let mut proved = assumptions.to_vec();
        let mut needed: Vec<Lit> = Vec::new();
        for trim in 0..MOST_TRIMS {
            if trim >= TRIMS_OF_LARGE && proved.len() > LARGE_CORE {
                break;
            }
            if core.len() == proved.len() && core.iter().all(|lit| needed.contains(lit)) {
                break;
            }
            needed.retain(|lit| core.contains(lit));
            let mut order = needed.clone();
            order.extend(core.iter().rev().filter(|lit| !needed.contains(lit)));
            let Some(smaller) = self.call(&order)? else {
                break; // the core was wrong: only what was proved before counts
            };
            *core = smaller;
            let last = order.iter().rev().find(|lit| core.contains(lit)).copied();
            proved = order;
            match last {
                Some(last) if !needed.contains(&last) => needed.insert(0, last),
                _ if core.len() == proved.len() => break,
                _ => {}
            }
        }
        self.needed = needed;
        Ok(Core::proved(proved))
    }

    /// The literals of the last core as varisat stated it, before it was verified and
    /// made smaller.
    pub(crate) const fn stated(&self) -> usize {
        self.stated
    }

    /// The clauses derived in the whole request so far.
    pub(super) fn derived(&self) -> u64 {
        self.budget.derived()
    }

    /// See [`Thresholds::small_core`](crate::Thresholds::small_core).
    pub(super) fn small_core(&self) -> usize {
        self.budget.thresholds().small_core
    }

    /// One call: `None` for a model, else the core as varisat states it.
    pub(super) fn call(&mut self, assumptions: &[Lit]) -> Result<Option<Vec<Lit>>, Stop> {
        self.budget.check()?;
        self.budget.count_call(self.variables);
        self.take_freed();
        self.solver.solve(assumptions)
    }

    /// Whether a literal holds in the last model.
    pub(crate) fn is_true(&self, lit: Lit) -> bool {
        let value = self.model.get(lit.variable() as usize).copied();
        value.unwrap_or(false) == lit.is_positive()
    }

    fn read_model(&mut self) {
        self.model.clear();
        self.model.resize(self.variables as usize, false);
        for lit in self.solver.model() {
            if let Some(value) = self.model.get_mut(lit.variable() as usize) {
                *value = lit.is_positive();
            }
        }
    }

    /// See [`Placeholders::told`].
    #[cfg(test)]
    pub(super) fn places(&self) -> Vec<super::placeholders::Told> {
        self.placeholders.told()
    }

    /// Before variables are named: see [`Placeholders`].
    fn take_freed(&mut self) {
        while let Some(clause) = self.placeholders.next(&mut self.variables) {
            self.hold(VARIABLE_BYTES);
            self.solver.add_clause(&clause);
        }
    }

    fn hold(&mut self, bytes: usize) {
        self.budget.hold_more(&mut self.held, bytes);
    }
}

impl Clauses for Sat<'_> {
    fn fresh(&mut self) -> Lit {
        let lit = Lit::positive(self.variables);
        self.variables += 1;
        self.budget.count_variable();
        self.hold(VARIABLE_BYTES);
        lit
    }

    fn clause(&mut self, lits: &[Lit]) {
        self.budget.count_clause();
        self.hold(CLAUSE_BYTES + LITERAL_BYTES * lits.len());
        self.take_freed();
        self.solver.add_clause(lits);
    }

    fn check(&self) -> Result<(), Stop> {
        self.budget.check()
    }
}
