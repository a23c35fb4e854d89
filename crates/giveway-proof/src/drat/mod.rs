//! A checker for proofs in the format DRAT.
//!
//! It reads a formula and a proof as text, and knows nothing of what they are
//! about or who wrote them. A step adds a clause or deletes one. An added clause
//! must follow by unit propagation (RUP), or be a resolution asymmetric
//! tautology on its first literal (RAT). The formula is unsatisfiable once unit
//! propagation alone finds a conflict. See Wetzler, Heule and Hunt, "DRAT-trim:
//! Efficient Checking and Trimming Using Expressive Clausal Proofs" (2014).
//!
//! As that checker does, this one keeps what was derived from a clause that is
//! deleted later: solvers delete clauses that have become units.

mod database;
mod read;

use std::fmt;

use database::Database;
use read::{Step, formula_clauses, proof_steps};

/// So many steps are checked between two questions whether to go on.
const STEPS: usize = 64;

/// A proof that was accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Proved {
    /// How many steps of it were needed: those after them were not read.
    pub steps: usize,
}

/// Why a proof was not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// The formula is not written as DIMACS has it.
    Formula {
        /// The line, from 1.
        line: usize,
    },
    /// A line of the proof is not a step.
    Unreadable {
        /// The line, from 1.
        line: usize,
    },
    /// A clause does not follow.
    DoesNotFollow {
        /// The line, from 1.
        line: usize,
    },
    /// The proof ends without a contradiction.
    Unfinished,
    /// The check was stopped: nothing is known.
    Stopped,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Formula { line } => write!(f, "line {line} of the formula cannot be read"),
            Self::Unreadable { line } => write!(f, "line {line} of the proof is not a step"),
            Self::DoesNotFollow { line } => {
                write!(f, "the clause of line {line} of the proof does not follow")
            }
            Self::Unfinished => f.write_str("the proof ends without a contradiction"),
            Self::Stopped => f.write_str("the check was stopped"),
        }
    }
}

/// Checks that a proof shows a formula to be unsatisfiable.
///
/// # Errors
/// Where it does not, with the line of the first fault, or where `go_on` says no.
///
/// ```
/// use giveway_proof::drat::{Refused, check};
/// let formula = "p cnf 2 4\n1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n";
/// assert!(check(formula, "2 0\n0\n", &|| true).is_ok());
/// let weaker = "p cnf 2 3\n1 2 0\n-1 2 0\n1 -2 0\n";
/// let refused = check(weaker, "2 0\n0\n", &|| true);
/// assert_eq!(refused, Err(Refused::DoesNotFollow { line: 2 }));
/// ```
pub fn check(formula: &str, proof: &str, go_on: &dyn Fn() -> bool) -> Result<Proved, Refused> {
    let (variables, clauses) = formula_clauses(formula)?;
    let mut database = Database::new(variables);
    for clause in clauses {
        if database.add(&clause?) {
            return Ok(Proved { steps: 0 });
        }
    }
    if database.settle() {
        return Ok(Proved { steps: 0 });
    }
    for (index, step) in proof_steps(proof, variables).enumerate() {
        let line = index + 1;
        if index % STEPS == 0 && !go_on() {
            return Err(Refused::Stopped);
        }
        match step.map_err(|()| Refused::Unreadable { line })? {
            Step::Delete(clause) => database.delete(&clause),
            Step::Add(clause) => {
                if !database.follows(&clause) {
                    return Err(Refused::DoesNotFollow { line });
                }
                if database.add(&clause) || database.settle() {
                    return Ok(Proved { steps: line });
                }
            }
        }
    }
    Err(Refused::Unfinished)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(formula: &str, proof: &str) -> Result<usize, Refused> {
        check(formula, proof, &|| true).map(|proved| proved.steps)
    }

    /// Two pigeons in one hole, and a third variable to play with.
    const PIGEONS: &str = "p cnf 3 3\n1 0\n2 0\n-1 -2 0\n";
    /// Every clause of two variables.
    const ALL: &str = "p cnf 3 4\n1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n";

    #[test]
    fn what_propagation_refutes_needs_no_proof() {
        assert_eq!(checked(PIGEONS, ""), Ok(0));
        assert_eq!(checked("p cnf 1 1\n0\n", ""), Ok(0));
    }

    #[test]
    fn a_proof_must_reach_a_contradiction() {
        assert_eq!(checked(ALL, ""), Err(Refused::Unfinished));
        assert_eq!(checked(ALL, "1 2 3 0\n"), Err(Refused::Unfinished));
        assert_eq!(checked(ALL, "1 0\n"), Ok(1));
    }

    #[test]
    fn the_empty_clause_does_not_follow_by_itself() {
        assert_eq!(checked(ALL, "0\n"), Err(Refused::DoesNotFollow { line: 1 }));
    }

    #[test]
    fn deleted_clauses_are_gone() {
        let proof = "d 2 1 0\nd 1 -2 0\n1 0\n";
        assert_eq!(checked(ALL, proof), Err(Refused::DoesNotFollow { line: 3 }));
        // Deleting what is not there, or something longer, changes nothing.
        assert_eq!(checked(ALL, "d 1 3 0\nd 1 2 3 0\n1 0\n"), Ok(3));
    }

    #[test]
    fn of_two_copies_one_is_deleted() {
        let formula = "p cnf 2 5\n1 2 0\n1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n";
        assert_eq!(checked(formula, "d 1 2 0\n1 0\n"), Ok(2));
        let twice = "d 1 2 0\nd 2 1 0\nd -1 2 0\n2 0\n";
        assert_eq!(
            checked(formula, twice),
            Err(Refused::DoesNotFollow { line: 4 })
        );
    }

    #[test]
    fn a_deleted_unit_stays_derived() {
        // 3 is known from the first clause; solvers delete it then.
        let formula = "p cnf 3 5\n3 0\n-3 1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n";
        assert_eq!(checked(formula, "d 3 0\n1 0\n"), Ok(2));
    }

    #[test]
    fn a_definition_is_a_rat_clause() {
        // 3 is new: it may be defined as "1 or 2", which does not follow.
        let formula = "p cnf 3 2\n1 2 0\n-1 -2 0\n";
        for proof in ["3 -1 0\n", "3 -1 0\n3 -2 0\n-3 1 2 0\n"] {
            assert_eq!(checked(formula, proof), Err(Refused::Unfinished), "{proof}");
        }
        // The pivot is the first literal: -1 occurs positively in a clause.
        assert_eq!(
            checked(formula, "-1 3 0\n"),
            Err(Refused::DoesNotFollow { line: 1 })
        );
        // Once 3 is known, not-3 is no definition.
        assert_eq!(
            checked("p cnf 3 2\n3 0\n1 2 0\n", "-3 1 0\n"),
            Err(Refused::DoesNotFollow { line: 1 })
        );
    }

    #[test]
    fn what_is_no_proof_or_formula_is_refused_by_its_line() {
        for proof in [
            "1",
            "1 0",
            "x 0\n",
            "1  0\n",
            "1 0 2 0\n",
            "4 0\n",
            "d\n",
            "\n",
            "1 0\r\n",
        ] {
            assert_eq!(
                checked(ALL, proof),
                Err(Refused::Unreadable { line: 1 }),
                "{proof:?}"
            );
        }
        for (formula, line) in [
            ("", 1),
            ("p cnf 1\n", 1),
            ("p cnf 1 1\n2 0\n", 2),
            ("p cnf 1 1\n1\n", 2),
            ("p cnf 1 2\n1 0\n", 3),
            ("p cnf 1 1\n1 0\n1 0\n", 3),
            ("p cnf 99999999999 0\n", 1),
        ] {
            assert_eq!(
                checked(formula, ""),
                Err(Refused::Formula { line }),
                "{formula:?}"
            );
        }
    }

    #[test]
    fn it_stops_when_told_to() {
        assert_eq!(check(ALL, "1 0\n", &|| false), Err(Refused::Stopped));
    }
}
