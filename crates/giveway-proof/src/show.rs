//! From what a solver answered to what shows it: proofs and searches.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, Objective, Plan, check};

use crate::bundle::manifest::NO_PLAN;
use crate::bundle::{Entry, Method, Missing};
use crate::exhaust::{Exhausted, alone_at_least, exhaust_kind, least};
use crate::plain::{Cnf, NoFormula};
use crate::queue::counted_at_least;
use crate::{Budget, Claim, Outcome, plain, prove};

/// More agents than this have too many states together to try.
const FEW_AGENTS: usize = 3;
/// From so many agents at a bottleneck on, a proof by clauses takes too long to try it first.
const MANY_AT_GATE: usize = 7;
/// With fewer agents, nothing is counted.
const FEWEST_AT_GATE: usize = 2;

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
}

/// The objective of an instance, with the penalty where rules of the scene's own make one.
pub(crate) fn objective(instance: &Instance) -> Objective {
    instance.in_force(instance.objective().clone())
}

/// The claims to certify, each with a name for its files.
fn claims(solved: &Solved<'_>) -> Vec<(String, Claim)> {
    if solved.impossible {
        return vec![(NO_PLAN.to_owned(), solved.about.clone())];
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
            claims.push((cost.name().to_owned(), claim));
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
        claims: Vec::new(),
    };
    for (name, claim) in claims(solved) {
        showing.certify(&name, claim);
    }
    showing.claims
}

/// Keeps a proof with its formula by the name of its files.
pub(crate) type Keep<'a> = dyn FnMut(&str, &Cnf, Vec<u8>) + 'a;

struct Showing<'a> {
    solved: &'a Solved<'a>,
    budget: &'a Budget<'a>,
    keep: &'a mut Keep<'a>,
    claims: Vec<Entry>,
}

impl Showing<'_> {
    /// A proof where the claim has a horizon. Where it has none: a search for
    /// all of it, where the solver claimed all of it, and a proof up to some
    /// makespan.
    fn certify(&mut self, name: &str, claim: Claim) {
        (self.budget.tell)(&claim);
        if counts(self.solved.instance, &claim, MANY_AT_GATE, self.budget) == Some(true) {
            let method = Method::Counting;
            self.claims.push(Entry::Search { claim, method });
            return;
        }
        if let Some(far) = claim.horizon(self.solved.instance) {
            let asked = self.solved.within.filter(|&last| last < far);
            // The makespan that the person set is mostly no part of such a claim:
            // only where a later plan would break it.
            match (self.proof(name, &claim), asked) {
                (Err(Missing::Contradicted), Some(_)) if !self.solved.complete => {
                    let claim = claim.within(asked);
                    let entry = self.proof(name, &claim);
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
            match self.proof(name, &claim) {
                Ok(entry) => self.claims.push(entry),
                Err(why) => self.claims.push(Entry::None { claim, why }),
            }
        }
        if let Some(claim) = missing {
            let why = Missing::SearchTooLarge;
            self.claims.push(Entry::None { claim, why });
        }
    }

    /// A proof, or why there is none.
    fn proof(&mut self, name: &str, claim: &Claim) -> Result<Entry, Missing> {
        let instance = self.solved.instance;
        let formula = match plain::formula(instance, claim, self.budget) {
            Ok(formula) => formula,
            Err(NoFormula::TooLarge) => return Err(Missing::FormulaTooLarge),
            Err(NoFormula::NoHorizon) => return Err(Missing::NoHorizon),
            Err(NoFormula::NoAgent) => return Err(Missing::NoAgent),
        };
        match prove(&formula, self.budget) {
            Outcome::Proof(proof) => {
                (self.keep)(name, &formula, proof);
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

impl Method {
    /// The searches that are worth trying, the smallest first.
    fn try_in_turn(instance: &Instance) -> impl Iterator<Item = Self> {
        let joint = instance.agents().len() <= FEW_AGENTS;
        [Self::Alone, Self::Counting]
            .into_iter()
            .chain(joint.then_some(Self::Joint))
    }

    /// Whether this search shows a claim; `None` where the budget ran out. Of agents
    /// alone it shows that there is no plan, whatever the condition.
    pub(crate) fn shows(
        self,
        instance: &Instance,
        claim: &Claim,
        budget: &Budget<'_>,
    ) -> Option<bool> {
        match self {
            Self::Joint => match exhaust_kind(instance, claim, budget) {
                Exhausted::NoPlan => Some(true),
                Exhausted::Plan(_) => Some(false),
                Exhausted::Stopped => None,
            },
            Self::Counting => counts(instance, claim, FEWEST_AT_GATE, budget),
            Self::Alone if claim.most.is_empty() => {
                // An agent that cannot arrive even alone costs more than anything.
                alone_at_least(instance, Cost::Makespan, u32::MAX, budget)
            }
            Self::Alone => {
                // One limit that the agents break each alone is enough.
                let mut shown = Some(false);
                for (&cost, &most) in &claim.most {
                    // More than the largest number nothing costs.
                    let Some(more) = most.checked_add(1) else {
                        continue;
                    };
                    match alone_at_least(instance, cost, more, budget) {
                        Some(true) => return Some(true),
                        Some(false) => {}
                        None => shown = None,
                    }
                }
                shown
            }
        }
    }
}

/// Whether counting at a bottleneck with at least so many agents shows a claim: it is enough that one
/// limit cannot be kept, whatever else the plans of the claim have to keep.
fn counts(instance: &Instance, claim: &Claim, fewest: usize, budget: &Budget<'_>) -> Option<bool> {
    let within = claim.most.get(&Cost::Makespan).copied();
    for (&cost, &most) in &claim.most {
        if let Some(more) = most.checked_add(1)
            && counted_at_least(instance, (cost, more), within, fewest, budget)?
        {
            return Some(true);
        }
    }
    Some(false)
}
