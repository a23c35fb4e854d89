//! The rules of the problem as a formula, a second time: plainly.
//!
//! The formula of a claim is satisfiable exactly where the claim is wrong. It is
//! written from the text of the problem, rule by rule, and shares nothing with
//! the solver's own encoding. Nothing is left out but what grid distances from
//! the start and to the goal exclude; no clause is lazy, nothing is assumed.

mod agent;
mod cnf;
mod condition;
mod constraints;
mod count;
mod distance;
mod levels;
mod meet;
mod names;

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance};

use crate::condition::{NoRule, with_rule};
use crate::lemma::Lemma;
use crate::{Budget, Claim};

pub use cnf::{Cnf, Lit};
pub use levels::of_lemmas;
pub use names::Name;

use agent::Walker;
pub(crate) use distance::grid_distance;

/// Why there is no formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFormula {
    /// The claim is about plans of any makespan, which no formula is.
    NoHorizon,
    /// It would be larger than the budget.
    TooLarge,
    /// The claim is about an agent that there is not.
    NoAgent,
}

/// The formula that is satisfiable exactly where there is a plan of the kind
/// that the claim excludes.
///
/// # Errors
/// Where the claim has no horizon, or the formula is larger than the budget.
///
/// ```
/// use giveway_model::{Cost, format::native};
/// use giveway_proof::{Budget, Claim, plain};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
///     "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let claim = Claim::at_most([(Cost::Makespan, 1)]);
/// let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
/// assert!(formula.text().starts_with("p cnf "));
/// ```
pub fn formula(instance: &Instance, claim: &Claim, budget: &Budget<'_>) -> Result<Cnf, NoFormula> {
    let last = claim.horizon(instance).ok_or(NoFormula::NoHorizon)?;
    let with_rule = with_rule(instance, claim.condition.as_ref());
    let instance = with_rule.map_err(|NoRule| NoFormula::NoAgent)?;
    let instance = instance.as_ref();
    let limits = Limits {
        by: vec![last; instance.agents().len()],
        last,
        most: &claim.most,
    };
    let (mut cnf, walkers) = written(instance, &limits, budget)?;
    if let Some(condition) = &claim.condition {
        condition::require(&mut cnf, instance, &walkers, condition, budget.clauses)?;
        check(&cnf, budget)?;
    }
    Ok(cnf)
}

/// The formula that is satisfiable exactly where a lemma is wrong. The instance has just the agents of
/// the lemma ([`Lemma::scene`]).
///
/// # Errors
/// Where it is larger than the budget, or the agents are others.
pub fn of_lemma(instance: &Instance, lemma: &Lemma, budget: &Budget<'_>) -> Result<Cnf, NoFormula> {
    let agents = instance.agents().iter();
    let by: Option<Vec<u32>> = agents.map(|it| lemma.by.get(&it.name).copied()).collect();
    let by = by.ok_or(NoFormula::NoAgent)?;
    let limits = Limits {
        last: by.iter().copied().max().ok_or(NoFormula::NoAgent)?,
        by,
        most: &lemma.most,
    };
    Ok(written(instance, &limits, budget)?.0)
}

/// Plans in which each agent that is asked for arrives by its time: a formula to be solved under
/// assumptions, with the literal of each agent that asks for it. Some agents may have a limit on a sum of
/// costs. Rules of the scene's own are left out.
pub(crate) fn of_some(
    instance: &Instance,
    by: &[u32],
    limit: Option<&SumLimit>,
    budget: &Budget<'_>,
) -> Result<(Cnf, Vec<Lit>), NoFormula> {
    let last = by.iter().copied().max().ok_or(NoFormula::NoAgent)?;
    let mut cnf = Cnf::default();
    let walkers = walkers(&mut cnf, instance, (by, last), budget)?;
    let mut asked = Vec::new();
    for walker in &walkers {
        let asks = cnf.variable(Name::Group);
        cnf.given(asks, |cnf| walker.rules(cnf));
        asked.push(asks);
        check(&cnf, budget)?;
    }
    meet::vertices(&mut cnf, instance, last, &walkers);
    meet::edges(&mut cnf, instance, last, &walkers);
    check(&cnf, budget)?;
    if let Some(SumLimit { cost, agents, most }) = limit {
        let of_sum = agents.iter().filter_map(|&agent| walkers.get(agent));
        let counted: Vec<Vec<Lit>> = of_sum.map(|it| it.counted(&mut cnf, *cost)).collect();
        let name = |n| Name::AtLeast(*cost, n);
        count::at_most(
            &mut cnf,
            &name,
            &counted,
            false,
            *most as usize,
            budget.clauses,
        );
        check(&cnf, budget)?;
    }
    Ok((cnf, asked))
}

/// The agents with their variables, each with the time by which it has arrived.
fn walkers<'a>(
    cnf: &mut Cnf,
    instance: &'a Instance,
    (by, last): (&[u32], u32),
    budget: &Budget<'_>,
) -> Result<Vec<Walker<'a>>, NoFormula> {
    // Each cell at each time is some clauses, and is looked at even without agents.
    let cells = instance.grid().width() as usize * instance.grid().height() as usize;
    if cells.saturating_mul((last as usize).saturating_add(1)) > budget.clauses {
        return Err(NoFormula::TooLarge);
    }
    let mut walkers = Vec::new();
    for (index, &by) in by.iter().enumerate() {
        let world = World {
            instance,
            index,
            last,
            by,
        };
        walkers.push(Walker::new(cnf, world));
        check(cnf, budget)?;
    }
    Ok(walkers)
}

/// A limit on what some agents cost together.
pub(crate) struct SumLimit {
    pub(crate) cost: Cost,
    /// By their numbers.
    pub(crate) agents: Vec<usize>,
    pub(crate) most: u32,
}

/// The limits that the plans of a formula keep.
struct Limits<'a> {
    /// The last time.
    last: u32,
    /// The time by which each agent has arrived.
    by: Vec<u32>,
    /// The costs of all agents; the makespan is the last time.
    most: &'a BTreeMap<Cost, u32>,
}

/// Plans within limits, and the agents with their variables.
fn written<'a>(
    instance: &'a Instance,
    limits: &Limits<'_>,
    budget: &Budget<'_>,
) -> Result<(Cnf, Vec<Walker<'a>>), NoFormula> {
    let last = limits.last;
    let mut cnf = Cnf::default();
    let walkers = walkers(&mut cnf, instance, (&limits.by, last), budget)?;
    for walker in &walkers {
        walker.rules(&mut cnf);
        check(&cnf, budget)?;
    }
    meet::vertices(&mut cnf, instance, last, &walkers);
    meet::edges(&mut cnf, instance, last, &walkers);
    check(&cnf, budget)?;
    constraints::require(&mut cnf, instance, &walkers, budget)?;
    for (&cost, &most) in limits.most {
        if cost == Cost::Makespan {
            continue; // the last time is this limit
        }
        if cost == Cost::Penalty {
            let mut paid = Vec::new();
            for walker in &walkers {
                paid.extend(constraints::penalties(&mut cnf, instance, walker));
                check(&cnf, budget)?;
            }
            constraints::limit(&mut cnf, &paid, most, budget.clauses)?;
            check(&cnf, budget)?;
            continue;
        }
        let counted: Vec<Vec<Lit>> = walkers
            .iter()
            .map(|walker| walker.counted(&mut cnf, cost))
            .collect();
        // Arrivals come sorted and need no sorting clauses.
        let sorted = cost == Cost::SumOfCosts;
        count::at_most(
            &mut cnf,
            &|n| Name::AtLeast(cost, n),
            &counted,
            sorted,
            most as usize,
            budget.clauses,
        );
        check(&cnf, budget)?;
    }
    Ok((cnf, walkers))
}

fn check(cnf: &Cnf, budget: &Budget<'_>) -> Result<(), NoFormula> {
    if cnf.clauses() > budget.clauses || !(budget.go_on)() {
        return Err(NoFormula::TooLarge);
    }
    Ok(())
}

/// One agent and what it moves in.
#[derive(Clone, Copy)]
struct World<'a> {
    instance: &'a Instance,
    index: usize,
    /// The last time; every agent has arrived by then.
    last: u32,
    /// The time by which this agent has arrived.
    by: u32,
}
