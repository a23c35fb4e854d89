//! From what a solver answered to what shows it: proofs and searches.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, Objective, Plan, check};

use crate::bundle::manifest::NO_PLAN;
use crate::bundle::{Entry, Method, Missing};
use crate::exhaust::{Exhausted, least};
use crate::lemma::{Effort, Pool};
use crate::plain::{Cnf, NoFormula};
use crate::search::counts;
use crate::{Budget, Claim, Hint, Outcome, plain, prove};

/// The bytes of the proof of a formula of all agents that is tried before lemmas.
const SMALL_PROOF: usize = 12 << 20;
/// From so many agents at a bottleneck on, a proof by clauses takes too long to try it first.
const MANY_AT_GATE: usize = 7;

/// The answer of a solver.
#[derive(Clone, Debug)]
pub struct Solved<'a> {
    /// The instance, with the objective by which plans were compared.
    pub instance: &'a Instance,
    /// The scope of all of its claims: for the answer to a question the contrasting plans
    /// ([`Claim::contrast`]), else all plans.
    pub about: Claim,
    /// The lower bounds that it proved, each given those of the costs before.
    pub bounds: &'a BTreeMap<Cost, u32>,
    /// Whether it proved that there is no plan.
    pub impossible: bool,
    /// Whether its claims hold for every horizon.
    pub complete: bool,
    /// Where they do not: the makespan up to which they hold, if it is known.
    pub within: Option<u32>,
    /// Its plan.
    pub plan: Option<&'a Plan>,
    /// The cores by which it raised its bounds, as guesses for [lemmas](crate::Lemma).
    pub hints: &'a [Hint],
}

/// The objective of an instance, with the penalty where rules of the scene's own make one.
pub(crate) fn objective(instance: &Instance) -> Objective {
    instance.in_force(instance.objective().clone())
}

/// The claims to certify, each with the cost that it bounds; none where there is no plan.
fn claims(solved: &Solved<'_>) -> Vec<(Option<Cost>, Claim)> {
    if solved.impossible {
        return vec![(None, solved.about.clone())];
    }
    let costs = solved
        .plan
        .and_then(|plan| check::costs(solved.instance, plan));
    let mut claims = Vec::new();
    let mut most = solved.about.most.clone();
    for &cost in objective(solved.instance).costs() {
        let Some(&bound) = solved.bounds.get(&cost) else {
            break;
        };
        if let Some(below) = bound.checked_sub(1) {
            let mut claim = solved.about.clone();
            claim.most.clone_from(&most);
            let before = claim.most.entry(cost).or_insert(below);
            *before = below.min(*before);
            claims.push((Some(cost), claim));
        }
        // Later claims are about plans that meet this bound.
        if costs.is_some_and(|costs| costs.get(cost) != bound) {
            break;
        }
        most.insert(cost, bound);
    }
    claims
}

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
        if let Some(cost) = cost
            && self.may_have_lemmas(&claim)
        {
            // A small formula of all agents is shown sooner.
            let small = Budget {
                clauses: self.budget.clauses.min(self.budget.small_formula),
                proof_bytes: self.budget.proof_bytes.min(SMALL_PROOF),
                ..*self.budget
            };
            let entry = self.proof(name, &claim, &small).ok();
            let entry = entry.or_else(|| self.alone(&claim));
            if let Some(entry) = entry.or_else(|| self.lemmas(cost, &claim, Effort::Suggested)) {
                self.claims.push(entry);
                return;
            }
        }
        if let Some(far) = claim.horizon(self.solved.instance) {
            let asked = self.solved.within.filter(|&last| last < far);
            // The makespan that the person set is mostly no part of such a claim:
            // only where a later plan would break it.
            match (self.proof(name, &claim, self.budget), asked) {
                (Err(Missing::Contradicted), Some(_)) if !self.solved.complete => {
                    let claim = claim.within(asked);
                    let entry = self.proof(name, &claim, self.budget);
                    let entry = entry.unwrap_or_else(|why| Entry::None { claim, why });
                    self.claims.push(entry);
                }
                (Ok(entry), _) => self.claims.push(entry),
                (Err(why), _) => {
                    let further = cost.filter(|_| self.may_have_lemmas(&claim));
                    let entry = further.and_then(|cost| self.lemmas(cost, &claim, Effort::Further));
                    let entry = entry.or_else(|| self.search(&claim));
                    self.claims
                        .push(entry.unwrap_or(Entry::None { claim, why }));
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
