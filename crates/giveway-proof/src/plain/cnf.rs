//! A formula in conjunctive normal form, with a name for each variable.

use std::fmt::Write as _;

use giveway_model::Instance;

use super::names::{self, Name};

/// A literal as DIMACS writes it: a variable from 1, negative where negated.
pub type Lit = i32;

/// Up to so many literals, every two of them exclude each other by a clause.
const FEW: usize = 5;

/// A formula in conjunctive normal form.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cnf {
    names: Vec<Name>,
    /// The literals of all clauses, a 0 behind each clause.
    literals: Vec<Lit>,
    clauses: usize,
    /// A literal of each clause that is written now, if there is one.
    guard: Option<Lit>,
}

impl Cnf {
    /// How many variables it has.
    pub fn variables(&self) -> usize {
        self.names.len()
    }

    /// How many clauses it has.
    pub fn clauses(&self) -> usize {
        self.clauses
    }

    /// The clauses in their order.
    pub fn iter(&self) -> impl Iterator<Item = &[Lit]> {
        // Each clause ends in its 0, and so does the last.
        let mut clauses = self.literals.split(|&lit| lit == 0);
        clauses.next_back();
        clauses
    }

    /// The formula in the format of DIMACS.
    pub fn text(&self) -> String {
        let mut text = format!("p cnf {} {}\n", self.variables(), self.clauses);
        for clause in self.iter() {
            for lit in clause {
                let _ = write!(text, "{lit} ");
            }
            text.push_str("0\n");
        }
        text
    }

    /// The names of the variables, from variable 1 on.
    pub fn names(&self) -> &[Name] {
        &self.names
    }

    /// The names of the variables, a line each.
    pub fn names_text(&self, instance: &Instance) -> String {
        names::text(&self.names, instance)
    }

    /// Writes clauses that hold only where a literal does.
    pub(super) fn given(&mut self, literal: Lit, write: impl FnOnce(&mut Self)) {
        self.guard = Some(-literal);
        write(self);
        self.guard = None;
    }

    /// A new variable.
    pub(super) fn variable(&mut self, name: Name) -> Lit {
        self.names.push(name);
        // Far fewer than fit: formulas have a limit of clauses.
        Lit::try_from(self.names.len()).unwrap_or(Lit::MAX)
    }

    /// A clause: at least one of the literals holds.
    ///
    /// One without literals, a rule that cannot be kept, becomes a variable
    /// that is both true and false: no formula consists of an empty clause.
    pub fn clause(&mut self, literals: impl IntoIterator<Item = Lit>) {
        let begin = self.literals.len();
        self.literals.extend(literals);
        self.literals.extend(self.guard);
        let clause = self.literals.get_mut(begin..).unwrap_or_default();
        clause.sort_unstable_by_key(|lit| (lit.unsigned_abs(), *lit < 0));
        let always = clause.windows(2).any(|pair| pair[0] == -pair[1]);
        if always {
            self.literals.truncate(begin);
            return;
        }
        if clause.is_empty() {
            let never = self.variable(Name::Never);
            self.clause([never]);
            self.clause([-never]);
            return;
        }
        self.literals.push(0);
        self.clauses += 1;
    }

    /// If all of `given` hold, then at least one of `then`.
    pub(super) fn implies(&mut self, given: &[Lit], then: impl IntoIterator<Item = Lit>) {
        let given: Vec<Lit> = given.iter().map(|lit| -lit).collect();
        self.clause(given.into_iter().chain(then));
    }

    /// At most one of the literals holds: few exclude each other directly, more
    /// are put into a square, of which at most one row and one column is used.
    pub(super) fn at_most_one(&mut self, literals: &[Lit]) {
        if literals.len() <= FEW {
            for (i, a) in literals.iter().enumerate() {
                for b in literals.iter().skip(i + 1) {
                    self.clause([-a, -b]);
                }
            }
            return;
        }
        let side = literals.len().isqrt() + 1;
        let rows: Vec<Lit> = (0..literals.len().div_ceil(side))
            .map(|_| self.variable(Name::Group))
            .collect();
        let columns: Vec<Lit> = (0..side).map(|_| self.variable(Name::Group)).collect();
        for (chunk, &row) in literals.chunks(side).zip(&rows) {
            for (&lit, &column) in chunk.iter().zip(&columns) {
                self.implies(&[lit], [row]);
                self.implies(&[lit], [column]);
            }
        }
        self.at_most_one(&rows);
        self.at_most_one(&columns);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_is_written_as_dimacs_has_it() {
        let mut cnf = Cnf::default();
        let (a, b) = (cnf.variable(Name::Group), cnf.variable(Name::Group));
        cnf.clause([b, -a]);
        cnf.clause([a, -a, b]);
        cnf.clause([]);
        assert_eq!(cnf.text(), "p cnf 3 3\n-1 2 0\n3 0\n-3 0\n");
        assert_eq!(cnf.iter().count(), 3);
        assert_eq!(Cnf::default().iter().count(), 0);
    }

    #[test]
    fn at_most_one_is_exact_for_any_number() {
        for n in 0..=12_usize {
            let mut cnf = Cnf::default();
            let lits: Vec<Lit> = (0..n).map(|_| cnf.variable(Name::Group)).collect();
            cnf.at_most_one(&lits);
            // A chosen literal decides all others by propagation, or contradicts.
            let satisfiable = |chosen: &[Lit]| {
                let mut with = cnf.clone();
                for &lit in chosen {
                    with.clause([lit]);
                }
                crate::drat::check(&with.text(), "", &|| true).is_err()
            };
            for (i, a) in lits.iter().enumerate() {
                assert!(satisfiable(&[*a]), "{n}");
                for b in &lits[..i] {
                    assert!(!satisfiable(&[*a, *b]), "{n}");
                }
            }
        }
    }
}
