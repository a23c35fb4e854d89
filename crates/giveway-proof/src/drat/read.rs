//! Formulas in DIMACS and proofs in DRAT, both as text, a clause a line.

use super::Refused;

/// A literal as DIMACS writes it: a variable from 1, negative where negated.
pub(super) type Lit = i32;

/// More variables than any formula here has.
const MOST_VARIABLES: usize = 1 << 26;

/// A step of a proof.
pub(super) enum Step {
    /// A clause that is said to follow.
    Add(Vec<Lit>),
    /// A clause that is no longer used.
    Delete(Vec<Lit>),
}

/// How many variables a formula has, and its clauses.
pub(super) fn formula_clauses(
    text: &str,
) -> Result<(usize, impl Iterator<Item = Result<Vec<Lit>, Refused>>), Refused> {
    let mut lines = text.split_inclusive('\n');
    let head = lines.next().and_then(|line| line.strip_suffix('\n'));
    let numbers = head.and_then(|head| head.strip_prefix("p cnf "));
    let numbers = numbers.and_then(|numbers| numbers.split_once(' '));
    let size = numbers.and_then(|(variables, clauses)| {
        let variables = variables.parse().ok().filter(|&n| n <= MOST_VARIABLES)?;
        Some((variables, clauses.parse::<usize>().ok()?))
    });
    let (variables, count) = size.ok_or(Refused::Formula { line: 1 })?;
    let mut read = 0;
    let mut ended = false;
    let clauses = std::iter::from_fn(move || {
        if ended {
            return None;
        }
        let fault = Some(Err(Refused::Formula { line: read + 2 }));
        match lines.next() {
            None => {
                ended = true;
                if read == count { None } else { fault }
            }
            Some(line) => {
                read += 1;
                match clause(line, variables) {
                    Some(clause) if read <= count => Some(Ok(clause)),
                    _ => {
                        ended = true;
                        fault
                    }
                }
            }
        }
    });
    Ok((variables, clauses))
}

/// The steps of a proof, a line each.
pub(super) fn proof_steps(
    text: &str,
    variables: usize,
) -> impl Iterator<Item = Result<Step, ()>> + '_ {
    text.split_inclusive('\n').map(move |line| {
        let step = match line.strip_prefix("d ") {
            Some(rest) => clause(rest, variables).map(Step::Delete),
            None => clause(line, variables).map(Step::Add),
        };
        step.ok_or(())
    })
}

/// `1 -2 0` and a line break.
fn clause(line: &str, variables: usize) -> Option<Vec<Lit>> {
    let line = line.strip_suffix('\n')?;
    let mut literals = Vec::new();
    let mut words = line.split(' ');
    for word in words.by_ref() {
        let lit: Lit = word.parse().ok()?;
        if lit == 0 {
            return words.next().is_none().then_some(literals);
        }
        if lit.unsigned_abs() as usize > variables {
            return None;
        }
        literals.push(lit);
    }
    None
}
