//! One cost after the other, in the order of the objective: first a plan, or the
//! proof that there is none; then the proof that none is better.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Objective};

use super::{
    aim::{Aim, Bounded, Contact, Verdict},
    deadlines::Keeping,
    feasible,
    for_ever::{self, Proved},
    incumbent::{Incumbent, free_of_collisions},
    prove::{SearchEnd, SearchInput, is_met, or_exhausted, prove},
    stage::{Search, Subject},
};
use crate::{
    budget::{Budget, Stop},
    first::first_plan,
    joint,
    lns::{Effort, Lns},
    local::apart,
    problem::Problem,
    trace::FoundBy,
    walk::Walk,
};

/// The first improvement of a plan expands at most `agents`³ / `CUBE_DIVISOR` states of single
/// agents: little for few agents.
const CUBE_DIVISOR: u64 = 3;
/// And at most this many: not much more than a second for a thousand agents.
const MOST_STATES: u64 = 3_000_000;
/// States between two reports of a better plan.
const TURN: u64 = 300_000;

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
        earlier: None,
        on_better: &|_, _| {},
    };
    find_from(problem, objective, bounded, aim, &contact, budget)
}

/// The same, from what is known already.
pub(crate) fn find_from(
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
        incumbent.offer(problem, walks, FoundBy::Given);
    }
    let mut verdict = Verdict {
        best: None,
        bounds: BTreeMap::new(),
        reach: None,
        stop: None,
        clash: Vec::new(),
        latest: None,
    };
    let given = SearchInput {
        problem,
        bounded,
        aim,
        earlier: contact.earlier,
        budget,
    };
    let end = run(given, &mut incumbent, &mut verdict);
    match end {
        Ok(SearchEnd::Plan) => {}
        Ok(SearchEnd::NoPlan(reason)) if incumbent.costs().is_none() => {
            verdict.reach = Some(Proved::new(reason, bounded.horizon.latest()));
        }
        Ok(SearchEnd::Best(reason)) if incumbent.costs().is_some() => {
            verdict.reach = Some(Proved::new(reason, bounded.horizon.latest()));
        }
        // The proof contradicts the plan that was found.
        Ok(SearchEnd::NoPlan(_) | SearchEnd::Best(_)) => verdict.stop = Some(Stop::Contradiction),
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

fn run(
    given: SearchInput,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<SearchEnd, Stop> {
    let SearchInput {
        problem,
        bounded,
        aim,
        budget,
        ..
    } = given;
    if let Some((agent, reason)) = for_ever::too_late(problem, bounded, budget)? {
        verdict.clash = vec![agent];
        return Ok(SearchEnd::NoPlan(reason));
    }
    if let Some((agent, too_low)) = for_ever::asked_below_minimum(problem, budget)? {
        verdict.clash = vec![agent];
        return Ok(SearchEnd::NoPlan(Some(too_low.into())));
    }
    if let Some((agents, reason)) = for_ever::queue_too_long(problem, bounded, budget)? {
        verdict.clash = agents;
        return Ok(SearchEnd::NoPlan(reason));
    }
    let walks = apart(problem, budget)?;
    // Outside the SAT solver each agent has a walk at its optimum.
    let insiders = problem.insiders();
    let has_walk = |agent: usize| !walks[agent].is_empty();
    if !(0..walks.len()).all(|agent| has_walk(agent) || insiders.contains(&agent)) {
        return Err(Stop::LateTimes);
    }
    if free_of_collisions(problem, &walks) {
        incumbent.offer(problem, &walks, FoundBy::Alone);
    } else if *aim == Aim::Best
        && incumbent.costs().is_none()
        // (Where any will do, SAT finds one as soon, and else refutes it.)
        && let Some((plan, by)) = first_plan(problem, walks.clone(), bounded.latest(), budget)?
    {
        incumbent.offer(problem, &plan, by.into());
        first_polish(given, plan, incumbent)?;
    }
    if incumbent.costs().is_none() {
        // If few agents find no plan, there is mostly none, and exhausting their joint states
        // shows it quickly. With conditions the initial planners were not asked, so their
        // failure says nothing. Where the limits bound the time, SAT is quick and its proof complete.
        let all: Vec<usize> = (0..problem.agents()).collect();
        let Bounded { horizon, limits } = bounded;
        if horizon.covers_limits(problem, limits).is_none()
            && (!problem.has_conditions() || joint::is_small(problem, budget))
            && let Some(shown) = for_ever::soonest(problem, bounded, incumbent, budget)?
        {
            verdict.clash = all;
            return Ok(shown);
        }
        if incumbent.costs().is_some() {
            return prove_or_take(given, &walks, incumbent, verdict);
        }
        if joint::is_small(problem, budget)
            && let Some(reason) = for_ever::above_limits(problem, bounded, budget)?
        {
            verdict.clash = all;
            return Ok(SearchEnd::NoPlan(Some(reason)));
        }
        let by_sat = |given: SearchInput, incumbent: &mut Incumbent, verdict: &mut Verdict| {
            first_by_sat(given, &walks, incumbent, verdict)
        };
        if let Some(shown) = or_exhausted(given, incumbent, verdict, by_sat, Some)? {
            return Ok(shown);
        }
    }
    prove_or_take(given, &walks, incumbent, verdict)
}

/// A first plan of many agents is made better before the proof begins: that is where
/// the proof takes long, and the plan is far from the best.
fn first_polish(
    given: SearchInput,
    mut plan: Vec<Walk>,
    incumbent: &mut Incumbent,
) -> Result<(), Stop> {
    let objective = incumbent.objective().clone();
    let best = incumbent
        .costs()
        .and_then(|costs| costs.vector(&objective).first().copied());
    let least = match objective.costs().first() {
        Some(Cost::SumOfCosts) => given.problem.optima.iter().sum(),
        _ => given.problem.optima.iter().copied().max().unwrap_or(0),
    };
    if best.is_none_or(|best| best <= least + least / 20) {
        return Ok(());
    }
    let agents = given.problem.agents() as u64;
    let states = (agents * agents * agents / CUBE_DIVISOR).min(MOST_STATES);
    let turns = states.div_ceil(TURN);
    let mut lns = Lns::default();
    for _ in 0..turns {
        let effort = Effort {
            states: TURN.min(states),
            horizon: given.bounded.latest(),
            enough: 0,
        };
        let better = lns.improve(given.problem, &mut plan, effort, &objective, given.budget);
        incumbent.offer(given.problem, &plan, FoundBy::Lns);
        if !better? {
            break;
        }
    }
    Ok(())
}

/// The proof that no plan is better than the one at hand, where that is asked for.
fn prove_or_take(
    given: SearchInput,
    walks: &[Walk],
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<SearchEnd, Stop> {
    if is_met(given.aim, incumbent) {
        return Ok(SearchEnd::Plan);
    }
    prove(given, walks, incumbent, verdict)
}

/// Looks for a first plan by SAT and offers it; the claim that there is none, where that was
/// proved instead.
fn first_by_sat(
    given: SearchInput,
    walks: &[Walk],
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<Option<SearchEnd>, Stop> {
    let SearchInput {
        problem,
        bounded,
        budget,
        ..
    } = given;
    let subject = Subject {
        problem,
        walks,
        bounded,
    };
    let mut search = Search::new(subject, Keeping::Assumed, incumbent, Rc::clone(budget));
    if let Some(too_low) = search.keep_limits(bounded)? {
        return Ok(Some(SearchEnd::NoPlan(Some(too_low.into()))));
    }
    let Some(core) = feasible::run(&mut search)? else {
        return Ok(None);
    };
    let reason = for_ever::impossible(&search, bounded, &core)?;
    verdict.clash = core.agents().to_vec();
    Ok(Some(SearchEnd::NoPlan(reason)))
}
