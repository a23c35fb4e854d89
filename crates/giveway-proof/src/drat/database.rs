//! Clauses, what is derived from them, and unit propagation with two watched
//! literals a clause.

use std::collections::BTreeMap;

use super::read::Lit;

/// A literal as an index: twice the variable from 0, and one more where negated.
type Code = usize;

fn code(lit: Lit) -> Code {
    2 * (lit.unsigned_abs() as usize - 1) + usize::from(lit < 0)
}

/// A clause: where its literals lie.
struct Span {
    begin: usize,
    end: usize,
    deleted: bool,
}

/// The clauses at hand, and the literals that are known to hold.
pub(super) struct Database {
    literals: Vec<Code>,
    clauses: Vec<Span>,
    /// For each literal, the clauses to look at once it is false.
    watchers: Vec<Vec<usize>>,
    /// For each literal, whether it holds.
    holds: Vec<bool>,
    /// The literals that hold, in the order in which they were found.
    trail: Vec<Code>,
    /// How many of them have been propagated.
    propagated: usize,
    /// Clauses by a number made from their literals, to find them again.
    by_content: BTreeMap<u64, Vec<usize>>,
}

impl Database {
    pub(super) fn new(variables: usize) -> Self {
        Self {
            literals: Vec::new(),
            clauses: Vec::new(),
            watchers: vec![Vec::new(); 2 * variables],
            holds: vec![false; 2 * variables],
            trail: Vec::new(),
            propagated: 0,
            by_content: BTreeMap::new(),
        }
    }

    /// Adds a clause; says whether it contradicts what is known.
    ///
    /// Units stay true for ever, so a clause that they satisfy need not be watched.
    pub(super) fn add(&mut self, clause: &[Lit]) -> bool {
        let clause = sorted(clause);
        let key = key(&clause);
        // Literals that are not false come first, to be watched.
        let (mut clause, mut shut): (Vec<Code>, Vec<Code>) =
            clause.into_iter().partition(|&lit| !self.is_false(lit));
        let open = clause.len();
        clause.append(&mut shut);
        let id = self.clauses.len();
        if open >= 2 {
            self.watchers[clause[0]].push(id);
            self.watchers[clause[1]].push(id);
        }
        let begin = self.literals.len();
        self.literals.extend(&clause);
        self.clauses.push(Span {
            begin,
            end: self.literals.len(),
            deleted: false,
        });
        self.by_content.entry(key).or_default().push(id);
        if open == 1 && !self.holds[clause[0]] {
            self.assign(clause[0]);
        }
        open == 0
    }

    /// Deletes a clause, one of its copies; nothing where there is none. What
    /// was derived from it is kept.
    pub(super) fn delete(&mut self, clause: &[Lit]) {
        let clause = sorted(clause);
        let (literals, clauses) = (&self.literals, &mut self.clauses);
        let Some(ids) = self.by_content.get_mut(&key(&clause)) else {
            return;
        };
        let same = |id: &usize| {
            let mut content = literals[clauses[*id].begin..clauses[*id].end].to_vec();
            content.sort_unstable();
            content == clause
        };
        if let Some(place) = ids.iter().position(same) {
            clauses[ids.swap_remove(place)].deleted = true;
        }
    }

    /// Propagates what is known; says whether there is a contradiction.
    pub(super) fn settle(&mut self) -> bool {
        self.propagate()
    }

    /// Whether a clause may be added: by unit propagation, else as a resolution
    /// asymmetric tautology on its first literal.
    pub(super) fn follows(&mut self, clause: &[Lit]) -> bool {
        let known = self.trail.len();
        let codes: Vec<Code> = clause.iter().map(|&lit| code(lit)).collect();
        let follows = self.refutes(&codes) || self.is_rat(&codes, known);
        self.retract(known);
        follows
    }

    /// With the clause already assumed to be false: whether every resolvent on
    /// its first literal follows.
    fn is_rat(&mut self, clause: &[Code], known: usize) -> bool {
        let Some(&pivot) = clause.first() else {
            return false;
        };
        let negated = pivot ^ 1;
        // A known literal is a clause of its own, whose resolvent is the rest.
        if self.trail[..known].contains(&negated) {
            return false;
        }
        let assumed = self.trail.len();
        for id in 0..self.clauses.len() {
            let Span {
                begin,
                end,
                deleted,
            } = self.clauses[id];
            if deleted || !self.literals[begin..end].contains(&negated) {
                continue;
            }
            let others = self.literals[begin..end].iter().copied();
            let others: Vec<Code> = others.filter(|&lit| lit != negated).collect();
            let refuted = self.refutes(&others);
            self.retract(assumed);
            if !refuted {
                return false;
            }
        }
        true
    }

    /// Assumes that all of these literals are false; says whether propagation
    /// then finds a contradiction. What was assumed is left on the trail.
    fn refutes(&mut self, clause: &[Code]) -> bool {
        for &lit in clause {
            if self.holds[lit] {
                return true;
            }
            if !self.is_false(lit) {
                self.assign(lit ^ 1);
            }
        }
        self.propagate()
    }

    fn is_false(&self, lit: Code) -> bool {
        self.holds[lit ^ 1]
    }

    fn assign(&mut self, lit: Code) {
        self.holds[lit] = true;
        self.trail.push(lit);
    }

    /// Forgets all that was assigned after the first `kept` literals.
    fn retract(&mut self, kept: usize) {
        for lit in self.trail.drain(kept..) {
            self.holds[lit] = false;
        }
        self.propagated = kept;
    }

    /// Unit propagation; says whether some clause is false.
    fn propagate(&mut self) -> bool {
        while let Some(&lit) = self.trail.get(self.propagated) {
            self.propagated += 1;
            if self.visit_watchers(lit ^ 1) {
                return true;
            }
        }
        false
    }

    /// Looks at the clauses that watch a literal that has become false.
    fn visit_watchers(&mut self, false_lit: Code) -> bool {
        let mut watchers = std::mem::take(&mut self.watchers[false_lit]);
        let mut conflict = false;
        let mut kept = 0;
        for place in 0..watchers.len() {
            let id = watchers[place];
            if !conflict {
                match self.look_at(id, false_lit) {
                    Look::Moved => continue,
                    Look::Keep => {}
                    Look::Unit(lit) => self.assign(lit),
                    Look::Conflict => conflict = true,
                }
            }
            watchers[kept] = id;
            kept += 1;
        }
        watchers.truncate(kept);
        self.watchers[false_lit] = watchers;
        conflict
    }

    fn look_at(&mut self, id: usize, false_lit: Code) -> Look {
        let span = &self.clauses[id];
        if span.deleted {
            return Look::Moved;
        }
        let clause = &mut self.literals[span.begin..span.end];
        if clause[0] == false_lit {
            clause.swap(0, 1);
        }
        let other = clause[0];
        if self.holds[other] {
            return Look::Keep;
        }
        for place in 2..clause.len() {
            let lit = clause[place];
            if !self.holds[lit ^ 1] {
                clause.swap(1, place);
                self.watchers[lit].push(id);
                return Look::Moved;
            }
        }
        if self.holds[other ^ 1] {
            Look::Conflict
        } else {
            Look::Unit(other)
        }
    }
}

/// The state of a clause one of whose watched literals is false.
enum Look {
    /// It is watched elsewhere now, or deleted.
    Moved,
    /// It is satisfied.
    Keep,
    /// Only this literal is left.
    Unit(Code),
    /// None is.
    Conflict,
}

/// The literals without repeats, in a fixed order.
fn sorted(clause: &[Lit]) -> Vec<Code> {
    let mut codes: Vec<Code> = clause.iter().map(|&lit| code(lit)).collect();
    codes.sort_unstable();
    codes.dedup();
    codes
}

/// A number by which a clause is found again; others may have it, too.
fn key(sorted: &[Code]) -> u64 {
    sorted.iter().fold(0xcbf2_9ce4_8422_2325, |key, &lit| {
        (key ^ lit as u64).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
