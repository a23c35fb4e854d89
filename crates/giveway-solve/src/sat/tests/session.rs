//! Incremental sessions: written down, made by chance, and played.

use std::fmt;
use std::rc::Rc;

use fastrand::Rng;

use super::second::satisfiable;
use crate::{
    Limits, SilentHost,
    budget::Budget,
    sat::{Clauses, Lit, Outcome, Sat},
};

/// One thing that happens in a session; literals are numbers from 1, negative
/// for a negated variable.
#[derive(Clone)]
pub(super) enum Step {
    Add(Vec<i32>),
    Ask(Vec<i32>),
}

/// What happens to one solver, in order.
#[derive(Clone)]
pub(super) struct Session(pub(super) Vec<Step>);

/// How the calls of a session ended.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ends {
    pub(super) sat: u32,
    pub(super) unsat: u32,
    /// Unsatisfiable with fewer than all assumptions.
    pub(super) smaller: u32,
    /// Cores made smaller still by leaving assumptions out.
    pub(super) minimised: u32,
}

impl Session {
    /// Reads lines such as `add 1 -2` and `ask -1 2`.
    pub(super) fn read(text: &str) -> Self {
        let steps = text.lines().map(|line| {
            let mut words = line.split_whitespace();
            let verb = words.next().unwrap();
            let lits = words.map(|word| word.parse().unwrap()).collect();
            match verb {
                "add" => Step::Add(lits),
                "ask" => Step::Ask(lits),
                _ => panic!("\"{line}\" begins with neither add nor ask"),
            }
        });
        Self(steps.collect())
    }

    /// A session made by chance.
    ///
    /// varisat gives the number of a variable that is fixed at level 0 to one
    /// that comes later, so marks left behind do harm when variables are fixed,
    /// assumed although they are, and followed by new ones. Hence the many unit
    /// clauses, and variables that come in little by little.
    pub(super) fn random(seed: u64) -> Self {
        let mut rng = Rng::with_seed(seed);
        let mut steps = Vec::new();
        let mut variables = rng.i32(2..=6);
        if rng.u8(..8) == 0 {
            // So many that there are conflicts, and clauses learnt from them.
            variables = rng.i32(20..=40);
            let mut lit = || rng.i32(1..=variables) * [1, -1][rng.usize(..2)];
            for _ in 0..variables * 7 / 2 {
                steps.push(Step::Add((0..3).map(|_| lit()).collect()));
            }
        }
        for _ in 0..rng.u32(4..=16) {
            variables += rng.i32(0..=3);
            let lit = |rng: &mut Rng| rng.i32(1..=variables) * [1, -1][rng.usize(..2)];
            for _ in 0..rng.i32(0..=variables / 2) {
                let size = [1, 2, 2, 2, 3, 3, 3, 3, 4][rng.usize(..9)];
                steps.push(Step::Add((0..size).map(|_| lit(&mut rng)).collect()));
            }
            let mut assumed: Vec<i32> = (0..rng.u32(0..=6)).map(|_| lit(&mut rng)).collect();
            if !assumed.is_empty() && rng.u8(..4) == 0 {
                assumed.push(assumed[rng.usize(..assumed.len())]);
            }
            steps.push(Step::Ask(assumed));
        }
        Self(steps)
    }

    /// Plays the session, and checks every answer.
    ///
    /// A model must satisfy all clauses and assumptions; a core must be some of
    /// the assumptions, and the second solver must find it unsatisfiable, which
    /// makes the verdict right as well.
    ///
    /// # Errors
    /// The first wrong answer, as a sentence.
    pub(super) fn play(&self, verify: bool) -> Result<Ends, String> {
        let budget = Rc::new(Budget::new(&SilentHost, Limits::default()));
        let mut sat = if verify {
            Sat::new(budget)
        } else {
            Sat::trusting(budget)
        };
        let mut made = 0;
        let mut clauses: Vec<&[i32]> = Vec::new();
        let mut ends = Ends::default();
        for step in &self.0 {
            let (Step::Add(numbers) | Step::Ask(numbers)) = step;
            let highest = numbers.iter().map(|n| n.unsigned_abs()).max().unwrap_or(0);
            while made < highest {
                sat.fresh();
                made += 1;
            }
            let lits: Vec<Lit> = numbers.iter().copied().map(to_lit).collect();
            match step {
                Step::Add(clause) => {
                    sat.clause(&lits);
                    clauses.push(clause);
                }
                Step::Ask(assumed) => match sat.solve(&lits) {
                    Err(stop) => return Err(format!("stopped: {stop:?}")),
                    Ok(Outcome::Sat) => {
                        ends.sat += 1;
                        let holds = |lit: &i32| sat.is_true(to_lit(*lit));
                        if let Some(wrong) = assumed.iter().find(|lit| !holds(lit)) {
                            return Err(format!("a model without the assumption {wrong}"));
                        }
                        if let Some(wrong) = clauses.iter().find(|c| !c.iter().any(holds)) {
                            return Err(format!("a model without the clause {wrong:?}"));
                        }
                    }
                    Ok(Outcome::Unsat(core)) => {
                        ends.unsat += 1;
                        ends.smaller += u32::from(core.len() < assumed.len());
                        let trimmed = core.len();
                        let core = if verify {
                            let core = sat.leave_out(core);
                            core.map_err(|stop| format!("stopped: {stop:?}"))?
                        } else {
                            core
                        };
                        ends.minimised += u32::from(core.len() < trimmed);
                        if let Some(wrong) = core.iter().find(|lit| !lits.contains(lit)) {
                            return Err(format!("a core with {wrong:?}, which is not assumed"));
                        }
                        let core: Vec<[i32; 1]> =
                            core.into_iter().map(|l| [to_number(l)]).collect();
                        let all = clauses.iter().copied();
                        if satisfiable(all.chain(core.iter().map(<[i32; 1]>::as_slice))) {
                            return Err(format!("under {assumed:?} a core too small, {core:?}"));
                        }
                    }
                },
            }
        }
        Ok(ends)
    }
}

impl fmt::Display for Session {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for step in &self.0 {
            let (verb, lits) = match step {
                Step::Add(lits) => ("add", lits),
                Step::Ask(lits) => ("ask", lits),
            };
            f.write_str(verb)?;
            for lit in lits {
                write!(f, " {lit}")?;
            }
            f.write_str("\n")?;
        }
        Ok(())
    }
}

fn to_lit(number: i32) -> Lit {
    Lit::new(number.unsigned_abs() - 1, number > 0)
}

fn to_number(lit: Lit) -> i32 {
    let number = lit.variable().cast_signed() + 1;
    if lit.is_positive() { number } else { -number }
}
