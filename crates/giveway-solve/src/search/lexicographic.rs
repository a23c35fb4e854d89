//! One cost after the other, in the order of the objective.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs, Objective};

use super::{
    deadlines::Keeping,
    feasible,
    for_ever::{self, ForEver, Known, Reach},
    horizon::Horizon,
    incumbent::{Incumbent, OnBetter, free_of_collisions},
    makespan,
    stage::{End, Search},
    sum::SumStage,
    tally::least,
};
use crate::{
    Limits,
    budget::{Budget, Stop},
    joint,
    local::{apart, first_plan},
    problem::Problem,
    single::TaskConstraint,
    walk::Walk,
};

/// What a plan must keep to, beside the rules.
#[derive(Clone, Debug)]
pub(crate) struct Bounded {
    /// The makespan beyond which nothing is looked for.
    pub(crate) horizon: Horizon,
    /// The most that a plan may have of some costs.
    pub(crate) limits: BTreeMap<Cost, u32>,
}

impl Bounded {
    /// The latest arrival of any plan that is looked for.
    pub(super) fn latest(&self) -> u32 {
        let limit = self.limits.get(&Cost::Makespan).copied();
        self.horizon.latest().min(limit.unwrap_or(u32::MAX))
    }
}

/// What is looked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The best plan, and the proof that it is.
    Best,
    /// A plan whose costs, in the order of the objective, are no worse than
    /// these.
    AtMost(Vec<u32>),
    /// Any plan.
    Any,
}

impl Aim {
    /// Whether a plan of these costs is all that is looked for.
    fn is_met(&self, vector: &[u32]) -> bool {
        match self {
            Self::Best => false,
            Self::AtMost(most) => vector <= most.as_slice(),
            Self::Any => true,
        }
    }

    /// Whether nothing can be as good as is looked for, where `least` are the
    /// optima of the first costs.
    fn is_missed(&self, least: &[u32]) -> bool {
        match self {
            Self::AtMost(most) => most.get(..least.len()).is_some_and(|most| most < least),
            _ => false,
        }
    }
}

/// What is known at the end.
#[derive(Debug)]
pub(crate) struct Verdict {
    /// The best plan, if there is one.
    pub(crate) best: Option<(Vec<Walk>, Costs)>,
    /// The proved lower bounds, of each cost that was reached.
    pub(crate) bounds: BTreeMap<Cost, u32>,
    /// How far the claim reaches; `None` where it is not settled, or nothing is
    /// claimed but that there is a plan.
    pub(crate) reach: Option<Reach>,
    /// Why it is not settled; `None` where it is.
    pub(crate) stop: Option<Stop>,
    /// Agents that cannot all arrive, where there is no plan.
    pub(crate) clash: Vec<usize>,
}

/// What a search for the best plan begins with, and whom it tells.
pub(crate) struct Contact<'a> {
    /// The walks of a plan that is known already.
    pub(crate) start: Option<&'a [Walk]>,
    /// Is told of each better plan.
    pub(crate) on_better: &'a OnBetter<'a>,
}

/// Finds and proves the lexicographic optimum.
pub(crate) fn solve(
    problem: &Problem,
    objective: &Objective,
    bounded: &Bounded,
    contact: &Contact,
    budget: &Rc<Budget>,
) -> Verdict {
    find_from(problem, objective, bounded, &Aim::Best, contact, budget)
}

/// Finds what is looked for, or proves that there is nothing like it.
pub(crate) fn find(
    problem: &Problem,
    objective: &Objective,
    bounded: &Bounded,
    aim: &Aim,
    budget: &Rc<Budget>,
) -> Verdict {
    let contact = Contact {
        start: None,
        on_better: &|_| {},
    };
    find_from(problem, objective, bounded, aim, &contact, budget)
}

fn find_from(
    problem: &Problem,
    objective: &Objective,
    bounded: &Bounded,
    aim: &Aim,
    contact: &Contact,
    budget: &Rc<Budget>,
) -> Verdict {
    let mut bounded = bounded.clone();
    if let Aim::AtMost(most) = aim
        && let (Some(&cost), Some(&most)) = (objective.costs().first(), most.first())
    {
        let limit = bounded.limits.entry(cost).or_insert(most);
        *limit = most.min(*limit);
    }
    let bounded = &bounded;
    let mut incumbent = Incumbent::new(
        objective.clone(),
        bounded.horizon.latest(),
        bounded.limits.clone(),
        contact.on_better,
    );
    if let Some(walks) = contact.start {
        incumbent.offer(problem, walks);
    }
    let mut verdict = Verdict {
        best: None,
        bounds: BTreeMap::new(),
        reach: None,
        stop: None,
        clash: Vec::new(),
    };
    let end = run(problem, bounded, aim, &mut incumbent, &mut verdict, budget);
    match end {
        Ok(Shown::Plan) => {}
        Ok(Shown::Claim(reason)) => {
            verdict.reach = Some(Reach::new(reason, bounded.horizon.latest()));
        }
        Err(stop) => verdict.stop = Some(stop),
    }
    verdict.best = incumbent.into_best();
    if *aim != Aim::Best
        && let Some((_, costs)) = &verdict.best
        && !aim.is_met(&costs.vector(objective))
    {
        verdict.best = None;
    }
    verdict
}

/// What a search has shown in the end.
#[derive(Clone, Copy, Debug)]
enum Shown {
    /// No more than the plan at hand, which is all that was looked for.
    Plan,
    /// That there is no plan, or no better one: within the horizon, or for this
    /// reason at any.
    Claim(Option<ForEver>),
}

fn run(
    problem: &Problem,
    bounded: &Bounded,
    aim: &Aim,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
    budget: &Rc<Budget>,
) -> Result<Shown, Stop> {
    let horizon = bounded.latest();
    let latest = |agent: usize| horizon.min(problem.not_after(agent));
    let late = (0..problem.agents()).find(|&agent| problem.optima[agent] > latest(agent));
    if let Some(agent) = late {
        verdict.clash = vec![agent];
        return Ok(Shown::Claim(for_ever::too_late(problem, bounded, agent)));
    }
    if let Some(agent) = above_least(problem, budget)? {
        verdict.clash = vec![agent];
        return Ok(Shown::Claim(Some(for_ever::above_minima())));
    }
    let walks = apart(problem, budget)?;
    if free_of_collisions(problem, &walks) {
        incumbent.offer(problem, &walks);
    } else if *aim == Aim::Best
        && incumbent.costs().is_none()
        // (Where any will do, SAT finds one as soon, and else refutes it.)
        && let Some(plan) = first_plan(problem, walks.clone(), horizon, budget)?
    {
        incumbent.offer(problem, &plan);
    }
    if incumbent.costs().is_none() {
        // Where few agents find no plan there is mostly none, which is quickly
        // shown where their joint states can be exhausted.
        // Where more than the rules is asked for, none was looked for as it should be.
        let all: Vec<usize> = (0..problem.agents()).collect();
        if !for_ever::have_limited_time(problem, bounded) // (else SAT is quick, and its proof complete)
            && (!problem.is_asked() || joint::is_small(problem))
            && let Some(reason) = for_ever::exhausted(problem, &all, budget)?
        {
            verdict.clash = all;
            return Ok(Shown::Claim(Some(reason)));
        }
        if joint::is_small(problem)
            && let Some(reason) = for_ever::above_limits(problem, bounded, budget)?
        {
            verdict.clash = all;
            return Ok(Shown::Claim(Some(reason)));
        }
        let mut search = Search::new(
            problem,
            walks.clone(),
            bounded,
            Keeping::Assumed,
            incumbent,
            Rc::clone(budget),
        );
        if !keep_limits(&mut search, bounded)? {
            // Each agent alone needs too much already.
            return Ok(Shown::Claim(Some(for_ever::above_minima())));
        }
        if let Some(clash) = feasible::run(&mut search)? {
            let reason = for_ever::impossible(&search, bounded, &clash)?;
            verdict.clash = clash;
            return Ok(Shown::Claim(reason));
        }
    }
    if is_met(aim, incumbent) {
        return Ok(Shown::Plan);
    }
    prove(problem, &walks, bounded, aim, incumbent, verdict, budget)
}

/// An agent of which a question asks for less than it could have alone.
fn above_least(problem: &Problem, budget: &Budget) -> Result<Option<usize>, Stop> {
    for (agent, task) in problem.tasks.iter().enumerate() {
        if let Some(TaskConstraint::AtMost { cost, most }) = task.demand
            && least(problem, agent, cost, budget)? > most
        {
            return Ok(Some(agent));
        }
    }
    Ok(None)
}

/// Whether the best plan is all that is looked for.
fn is_met(aim: &Aim, incumbent: &Incumbent) -> bool {
    let vector = incumbent.costs().map(|c| c.vector(incumbent.objective()));
    vector.is_some_and(|vector| aim.is_met(&vector))
}

/// Conflicts after which few joint states are exhausted instead.
const PATIENCE: u64 = 4_000;

/// The optima of all costs, one after the other. Where there are few joint
/// states and SAT finds it hard, they are exhausted.
fn prove(
    problem: &Problem,
    walks: &[Walk],
    bounded: &Bounded,
    aim: &Aim,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
    budget: &Rc<Budget>,
) -> Result<Shown, Stop> {
    if !(joint::is_small(problem) && bounded.limits.is_empty()) {
        return prove_by_sat(problem, walks, bounded, aim, incumbent, verdict, budget);
    }
    let patience = Limits {
        conflicts: Some(PATIENCE),
        ..Limits::default()
    };
    let part = Rc::new(budget.part(patience));
    let shown = prove_by_sat(problem, walks, bounded, aim, incumbent, verdict, &part);
    budget.absorb(&part);
    if !matches!(shown, Err(Stop::Conflicts)) {
        return shown;
    }
    budget.check()?;
    if let Some(optima) = for_ever::best(problem, incumbent, budget)? {
        verdict.bounds = optima.bounds;
        return Ok(Shown::Claim(Some(optima.reason)));
    }
    prove_by_sat(problem, walks, bounded, aim, incumbent, verdict, budget)
}

/// The stages, one for each cost of the objective.
fn prove_by_sat(
    problem: &Problem,
    walks: &[Walk],
    bounded: &Bounded,
    aim: &Aim,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
    budget: &Rc<Budget>,
) -> Result<Shown, Stop> {
    if let Some((cost, known)) = for_ever::known_for_ever(problem, bounded, incumbent, budget)? {
        let mut limited = bounded.clone();
        limited.limits.insert(cost, known.least);
        let known = Some(known);
        let limited = &limited;
        if let Some(shown) = stages(
            problem, walks, limited, aim, known, incumbent, verdict, budget,
        )? {
            return Ok(shown);
        }
        // Its plans all need more time than the horizon allows.
        verdict.bounds.clear();
    }
    let shown = stages(
        problem, walks, bounded, aim, None, incumbent, verdict, budget,
    )?;
    shown.ok_or(Stop::Contradiction) // a plan is at hand, so there is one
}

/// One stage after the other; `None` where there is no plan. The optimum of the
/// first cost may be `known`, and a limit.
#[expect(clippy::too_many_arguments, reason = "all that a search is made of")]
fn stages(
    problem: &Problem,
    walks: &[Walk],
    bounded: &Bounded,
    aim: &Aim,
    known: Option<Known>,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
    budget: &Rc<Budget>,
) -> Result<Option<Shown>, Stop> {
    let objective = incumbent.objective().clone();
    let mut search = Search::new(
        problem,
        walks.to_vec(),
        bounded,
        Keeping::Hard,
        incumbent,
        Rc::clone(budget),
    );
    keep_limits(&mut search, bounded)?;
    // Once the makespan or the sum of costs is bounded, no later plan counts.
    let mut time_is_bounded = for_ever::limits_time(problem, bounded);
    let mut known = known;
    let mut optima = Vec::new();
    let mut all: Option<ForEver> = None;
    for (i, &cost) in objective.costs().iter().enumerate() {
        let mut bound = 0;
        let known = known.take();
        let last = i + 1 == objective.costs().len();
        let end = if cost == Cost::Makespan {
            makespan::run(&mut search, &mut bound)
        } else {
            SumStage::run(&mut search, cost, known.map(|k| k.least), last, &mut bound)
        };
        verdict.bounds.insert(cost, bound);
        let End::Least(least) = end? else {
            return Ok(None);
        };
        search.finish(cost, least);
        if i == 0 && cost == Cost::Makespan {
            search = search.afresh(least, walks.to_vec());
            keep_limits(&mut search, bounded)?;
        }
        let reason = match time_is_bounded.or(known.map(|known| known.reason)) {
            None => for_ever::of_bound(&mut search, cost, least, bounded)?,
            known => known,
        };
        all = if i == 0 {
            reason
        } else {
            ForEver::both(all, reason)
        };
        time_is_bounded = time_is_bounded.or(for_ever::time_is_bounded(cost));
        optima.push(least);
        if aim.is_missed(&optima) || is_met(aim, search.incumbent) {
            break;
        }
    }
    Ok(Some(Shown::Claim(all)))
}

/// Makes the limits hold; false where the agents' own minima break one.
pub(super) fn keep_limits(search: &mut Search, bounded: &Bounded) -> Result<bool, Stop> {
    for (&cost, &most) in &bounded.limits {
        if cost != Cost::Makespan && !search.limit(cost, most)? {
            return Ok(false);
        }
    }
    // Whoever enters takes its share of the limits.
    search.enter_insiders()?;
    Ok(true)
}
