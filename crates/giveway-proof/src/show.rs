//! From what a solver answered to what shows it: proofs and searches.

use giveway_model::{Cost, Instance, check};

use crate::bundle::manifest::NO_PLAN;
use crate::bundle::{Entry, Method, Missing};
use crate::exhaust::{Exhausted, least};
use crate::lemma::{Effort, Pool};
use crate::plain::{Cnf, NoFormula};
use crate::search::counts;
use crate::solved::claims;
use crate::{Budget, Claim, Outcome, Solved, plain, prove};

/// The bytes of the proof of a formula of all agents that is tried before lemmas.
const SMALL_PROOF: usize = 12 << 20;
/// The clauses of a formula of all agents beyond which further lemmas are tried first.
const LARGE_FORMULA: usize = 2_000_000;
/// From so many agents at a bottleneck on, a proof by clauses takes too long to try it first.
const MANY_AT_GATE: usize = 7;

/// Shows everything that the solver claims, and hands on the proofs that it
/// takes. What cannot be shown within the budget is said not to be.
pub(crate) fn show(solved: &Solved<'_>, budget: &Budget<'_>, keep: &mut Keep<'_>) -> Vec<Entry> {
    let mut showing = Showing {
        solved,
        budget,
        keep,
        pool: Pool::default(),
        claims: Vec::new(),
    };
    for (cost, claim) in claims(solved) {
        showing.certify(cost, claim);
    }
    showing.claims
}

/// Keeps a proof with its formula by the name of its files; with the instance of the formula, which names
/// its variables.
pub(crate) type Keep<'a> = dyn FnMut(&str, &Instance, &Cnf, Vec<u8>) + 'a;

struct Showing<'a> {
    solved: &'a Solved<'a>,
    budget: &'a Budget<'a>,
    keep: &'a mut Keep<'a>,
    pool: Pool,
    claims: Vec<Entry>,
}

impl Showing<'_> {
    /// A proof where the claim has a horizon. Where it has none: a search for
    /// all of it, where the solver claimed all of it, and a proof up to some
    /// makespan.
    fn certify(&mut self, cost: Option<Cost>, claim: Claim) {
        let name = cost.map_or(NO_PLAN, Cost::name);
        (self.budget.tell)(&claim);
        if counts(self.solved.instance, &claim, MANY_AT_GATE, self.budget) == Some(true) {
            let method = Method::Counting;
            self.claims.push(Entry::Search { claim, method });
            return;
        }
        let mut is_too_long = false;
        if let Some(cost) = cost
            && self.may_have_lemmas(&claim)
        {
            match self.by_lemmas_or_less(cost, &claim) {
                Ok(entry) => {
                    self.claims.push(entry);
                    return;
                }
                Err(why) => is_too_long = why == Missing::ProofTooLarge,
            }
        }
        if let Some(far) = claim.horizon(self.solved.instance) {
            let asked = self.solved.within.filter(|&last| last < far);
            // The makespan that the person set is mostly no part of such a claim:
            // only where a later plan would break it.
            let proof = if is_too_long {
                Err(Missing::ProofTooLarge)
            } else {
                self.proof(name, &claim, self.budget)
            };
            match (proof, asked) {
                (Err(Missing::Contradicted), Some(_)) if !self.solved.complete => {
                    let claim = claim.within(asked);
                    let entry = self.proof(name, &claim, self.budget);
                    let entry = entry.unwrap_or_else(|why| Entry::None { claim, why });
                    self.claims.push(entry);
                }
                (Ok(entry), _) => self.claims.push(entry),
                (Err(why), _) => {
                    let entry = self.search(&claim).unwrap_or(Entry::None { claim, why });
                    self.claims.push(entry);
                }
            }
            return;
        }
        let mut missing = None;
        if self.solved.complete {
            match self.search(&claim) {
                Some(entry) => self.claims.push(entry),
                None => missing = Some(claim.clone()),
            }
        }
        let horizon = self.solved.within.or_else(|| self.default_horizon());
        if let Some(last) = horizon {
            let claim = claim.within(Some(last));
            match self.proof(name, &claim, self.budget) {
                Ok(entry) => self.claims.push(entry),
                Err(why) => self.claims.push(Entry::None { claim, why }),
            }
        }
        if let Some(claim) = missing {
            let why = Missing::SearchTooLarge;
            self.claims.push(Entry::None { claim, why });
        }
    }

    /// What shows a claim, by what takes least: a small formula of all agents, each agent alone, the lemmas that
    /// the search suggests, a larger formula, further lemmas. What is shown so is the same whatever the budget,
    /// where that is enough. Or why the larger formula has no proof.
    fn by_lemmas_or_less(&mut self, cost: Cost, claim: &Claim) -> Result<Entry, Missing> {
        let whole = self.budget;
        let at_most = |clauses: usize, proof_bytes: usize| Budget {
            clauses: whole.clauses.min(clauses),
            proof_bytes: whole.proof_bytes.min(proof_bytes),
            ..*whole
        };
        let small = at_most(whole.small_formula, SMALL_PROOF);
        let large = at_most(LARGE_FORMULA, whole.proof_bytes);
        let shown = self.proof(cost.name(), claim, &small).ok();
        let shown = shown.or_else(|| self.alone(claim));
        let shown = shown.or_else(|| self.lemmas(cost, claim, Effort::Suggested));
        if let Some(entry) = shown {
            return Ok(entry);
        }
        self.proof(cost.name(), claim, &large)
            .or_else(|why| self.lemmas(cost, claim, Effort::Further).ok_or(why))
    }

    /// Whether a claim is about plans of any kind and of any makespan, about costs that are added up, and
    /// the search has hinted at lemmas.
    fn may_have_lemmas(&self, claim: &Claim) -> bool {
        let is_counted = claim.most.keys().all(|&cost| cost != Cost::Penalty);
        let is_about_all = claim.condition.is_none() && claim.within.is_none();
        is_about_all && is_counted && !self.solved.hints.is_empty()
    }

    /// The search of each agent alone, where that shows a claim.
    fn alone(&self, claim: &Claim) -> Option<Entry> {
        let method = Method::Alone;
        let shows = method.shows(self.solved.instance, claim, self.budget) == Some(true);
        shows.then(|| Entry::Search {
            claim: claim.clone(),
            method,
        })
    }

    /// Lemmas that show a claim.
    fn lemmas(&mut self, cost: Cost, claim: &Claim, effort: Effort) -> Option<Entry> {
        let Solved {
            instance, hints, ..
        } = *self.solved;
        let of = (instance, claim, cost);
        let hints = (hints, effort);
        let shown = self.pool.show(of, hints, self.budget, self.keep)?;
        let (variables, clauses) = (shown.formula.variables(), shown.formula.clauses());
        (self.keep)(cost.name(), instance, &shown.formula, shown.proof);
        Some(Entry::Lemmas {
            claim: claim.clone(),
            name: cost.name().to_owned(),
            variables,
            clauses,
            least: shown.least,
            lemmas: shown.lemmas,
        })
    }

    /// A proof, or why there is none.
    fn proof(&mut self, name: &str, claim: &Claim, budget: &Budget<'_>) -> Result<Entry, Missing> {
        let instance = self.solved.instance;
        let formula = match plain::formula(instance, claim, budget) {
            Ok(formula) => formula,
            Err(NoFormula::TooLarge) => return Err(Missing::FormulaTooLarge),
            Err(NoFormula::NoHorizon) => return Err(Missing::NoHorizon),
            Err(NoFormula::NoAgent) => return Err(Missing::NoAgent),
        };
        match prove(&formula, budget) {
            Outcome::Proof(proof) => {
                (self.keep)(name, instance, &formula, proof);
                Ok(Entry::Proof {
                    claim: claim.clone(),
                    name: name.to_owned(),
                    variables: formula.variables(),
                    clauses: formula.clauses(),
                })
            }
            Outcome::Satisfiable => Err(Missing::Contradicted),
            Outcome::Stopped => Err(Missing::ProofTooLarge),
        }
    }

    /// A search that shows the claim, where there is a small one.
    fn search(&self, claim: &Claim) -> Option<Entry> {
        let instance = self.solved.instance;
        Method::try_in_turn(instance)
            .find(|method| method.shows(instance, claim, self.budget) == Some(true))
            .map(|method| Entry::Search {
                claim: claim.clone(),
                method,
            })
    }

    /// The makespan up to which claims are made by default: the largest optimum
    /// of an agent alone + 4 (width + height) + 10, and the last time that a rule of the
    /// scene's own names.
    fn default_horizon(&self) -> Option<u32> {
        let instance = self.solved.instance;
        let mut longest = 0;
        for agent in 0..instance.agents().len() {
            match least(instance, agent, Cost::Makespan, self.budget) {
                Exhausted::Plan(n) => longest = longest.max(n),
                // One that never arrives makes no other horizon necessary.
                Exhausted::NoPlan => {}
                Exhausted::Stopped => return None,
            }
        }
        let grid = instance.grid();
        let named = instance.constraints_in_force();
        let named = named.map(|rule| rule.constraint.last_time()).max();
        let default = longest
            .saturating_add(4 * (grid.width() + grid.height()) + 10)
            .saturating_add(named.unwrap_or(0));
        // The plan at hand is never beyond it.
        let plan = self
            .solved
            .plan
            .and_then(|plan| check::costs(instance, plan));
        Some(default.max(plan.map_or(0, |costs| costs.makespan)))
    }
}
