//! How many steps every plan loses that costs no more before the sum of costs.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs, Objective, check::check, sorting::map};

use super::{DelayProof, DelaysAnswer, running::RunningPlan, words};
use crate::{
    SolveAnswer,
    budget::Budget,
    problem::Problem,
    search::{self, Bounded, Contact, Horizon, Minima, reach_of_bounds},
    walk::{Walk, to_plan},
};

impl DelaysAnswer {
    /// Takes back what is said of all plans.
    pub(crate) fn prove_nothing(&mut self) {
        if let Some(proof) = &mut self.proof {
            proof.at_least = 0;
            proof.reach = crate::Reach::default();
        }
        self.words = words::all(self);
    }

    /// Takes the proof from the answer to a solve request for the same scene and objective. It
    /// says nothing where that answer's plan has other costs before the sum of costs, or the
    /// world changed while the plan ran.
    pub fn prove_by(&mut self, known: &SolveAnswer) {
        let Some(costs) = self.costs.filter(|_| self.since.is_none()) else {
            return;
        };
        let given = given(&self.objective, &costs);
        if !proves(known, &given) || !self.objective.costs().contains(&Cost::SumOfCosts) {
            return;
        }
        let Some(&bound) = known.bounds.get(&Cost::SumOfCosts) else {
            return;
        };
        let keeps = |other: &Costs| given.iter().all(|(&cost, &value)| other.get(cost) <= value);
        let best = known.costs.filter(keeps).map(|other| other.sum_of_costs);
        self.proof = Some(DelayProof {
            given,
            at_least: bound.saturating_sub(self.alone),
            at_most: best.map_or(self.delay, |best| {
                self.delay.min(best.saturating_sub(self.alone))
            }),
            reach: known.reach,
        });
        self.pending = false;
        self.words = words::all(self);
    }

    /// The least sum of costs of the best plans, where this proves more of it than the answer to a
    /// solve request for the same scene and objective.
    pub fn raised_bound(&self, known: &SolveAnswer) -> Option<u32> {
        let is_wanted = self.objective.costs().contains(&Cost::SumOfCosts) && self.since.is_none();
        let proof = self.proof.as_ref().filter(|_| is_wanted)?;
        let is_of_both = proof.reach.of_bounds() == known.reach.of_bounds();
        let bound = known.bounds.get(&Cost::SumOfCosts).copied();
        let least = self.alone + proof.at_least;
        (is_of_both && proves(known, &proof.given) && Some(least) > bound).then_some(least)
    }
}

/// Whether an answer proves that no plan has less of any of these costs.
fn proves(known: &SolveAnswer, given: &BTreeMap<Cost, u32>) -> bool {
    let mut given = given.iter();
    given.all(|(cost, value)| known.bounds.get(cost) == Some(value))
}

/// The costs before the sum of costs, or all where it is none of the objective, with the values
/// that a plan has.
fn given(objective: &Objective, costs: &Costs) -> BTreeMap<Cost, u32> {
    let before = objective.costs().iter();
    let before = before.take_while(|&&cost| cost != Cost::SumOfCosts);
    map(before.map(|&cost| (cost, costs.get(cost))))
}

/// A plan and what is known of it.
pub(super) struct Proving<'a> {
    pub(super) running: &'a RunningPlan<'a>,
    pub(super) problem: &'a Problem,
    pub(super) walks: &'a [Walk],
    /// The costs of the plan; after changes of its rest.
    pub(super) costs: Costs,
    /// The horizon, where a person set one, in times of the whole plan.
    pub(super) within: Option<u32>,
}

/// The search for a plan of as much before the sum of costs that loses less.
pub(super) fn prove(proving: &Proving, budget: &Rc<Budget>) -> DelayProof {
    let Proving {
        running,
        problem,
        walks,
        costs,
        within,
    } = proving;
    let instance = running.instance;
    let limits = given(instance.objective(), costs);
    let least = (0..problem.agents()).map(|agent| problem.least_cost(agent));
    let alone = least.fold(0, u32::saturating_add);
    let whole = running.whole_costs(*costs);
    let mut proof = DelayProof {
        given: given(instance.objective(), &whole),
        at_least: 0,
        at_most: costs.sum_of_costs.saturating_sub(alone),
        reach: crate::Reach::default(),
    };
    let Ok(objective) = Objective::new(vec![Cost::SumOfCosts]) else {
        return proof;
    };
    let within = within.map(|it| it.saturating_sub(running.since()).max(costs.makespan));
    let horizon = Horizon::of(problem, instance.grid(), within, costs.makespan);
    let bounded = Bounded { horizon, limits };
    let contact = Contact {
        start: Some(walks),
        earlier: None,
        on_better: &|_, _| {},
    };
    let found = search::solve(problem, &objective, &bounded, &contact, budget);
    let best = found.best.and_then(|(walks, costs)| {
        let plan = to_plan(problem, &running.names(), &walks);
        let report = check(instance, &plan);
        let keeps = bounded
            .limits
            .iter()
            .all(|(&cost, &most)| costs.get(cost) <= most);
        (keeps && report.is_valid() && report.costs == Some(costs)).then_some(costs.sum_of_costs)
    });
    let Some(best) = best else {
        return proof; // the plan itself is one: never trust the search
    };
    proof.at_most = proof.at_most.min(best.saturating_sub(alone));
    if found.stop.is_none() {
        proof.at_least = proof.at_most;
        proof.reach = found.reach.into();
    } else {
        let lone = Minima::default().bound(problem, Cost::SumOfCosts, budget);
        let lone = map(lone.ok().map(|bound| (Cost::SumOfCosts, bound)));
        let bound = found.bounds.get(&Cost::SumOfCosts).copied().unwrap_or(0);
        proof.at_least = bound.saturating_sub(alone).min(proof.at_most);
        let reach = reach_of_bounds(problem, horizon, &objective, &found.bounds, &lone);
        proof.reach = Some(reach).into();
    }
    proof.reach = proof.reach.later(running.since());
    proof
}
