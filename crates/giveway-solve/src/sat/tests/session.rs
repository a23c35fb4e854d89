//! Incremental sessions: written down, made by chance, and played.

use std::fmt;
use std::rc::Rc;

use fastrand::Rng;

use super::{Care, places, second::satisfiable};
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
    /// Freed places that placeholders took.
    pub(super) taken: u32,
    /// Freed places that variables of the formula took.
    pub(super) chosen: u32,
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
    pub(super) fn play(&self, care: Care) -> Result<Ends, String> {
        let budget = Rc::new(Budget::new(&SilentHost, Limits::default()));
        let mut sat = Sat::with_care(budget, care);
        let mut made: Vec<Lit> = Vec::new();
        let mut clauses: Vec<&[i32]> = Vec::new();
        let mut ends = Ends::default();
        let mut told = None;
        for step in &self.0 {
            let (Step::Add(numbers) | Step::Ask(numbers)) = step;
            let highest = numbers.iter().map(|n| n.unsigned_abs()).max().unwrap_or(0);
            while made.len() < highest as usize {
                made.push(sat.fresh());
            }
            let to_lit = |number: i32| to_lit(&made, number);
            let lits: Vec<Lit> = numbers.iter().copied().map(to_lit).collect();
            // A formula without a model takes no clauses any more.
            if told.is_none() && !satisfiable(clauses.iter().copied()) {
                told = Some(sat.places().len());
            }
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
                        let core = if care.verify {
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
                            core.iter().map(|&l| [to_number(&made, l)]).collect();
                        let all = clauses.iter().copied();
                        if satisfiable(all.chain(core.iter().map(<[i32; 1]>::as_slice))) {
                            return Err(format!("under {assumed:?} a core too small, {core:?}"));
                        }
                    }
                },
            }
        }
        let mut places = sat.places();
        places.truncate(told.unwrap_or(places.len()));
        (ends.taken, ends.chosen) = places::taken_again(&places, &made);
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

/// The literal of a number, by the variables that were made, in order.
fn to_lit(made: &[Lit], number: i32) -> Lit {
    let variable = made[number.unsigned_abs() as usize - 1];
    if number > 0 { variable } else { !variable }
}

fn to_number(made: &[Lit], lit: Lit) -> i32 {
    let place = made.iter().position(|v| v.variable() == lit.variable());
    let number = i32::try_from(place.unwrap() + 1).unwrap();
    if lit.is_positive() { number } else { -number }
}
