//! One method at one time: its problem, its search, its answer.

mod answer;
mod cause;
mod judged;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Agent;

use super::{
    Cause, MethodAnswer,
    freed::Fewest,
    keep::{self, MethodRefusal},
    method_case::{MethodCase, Trouble},
};
use crate::{
    Progress,
    budget::Stop,
    problem::Problem,
    search::{Bounded, Contact, Proved, Verdict, solve},
    walk::Walk,
};
use answer::{answer, without_search};
use cause::{blocked, cause_of};
use judged::judged;

/// The result of a method, with the agents that it freed.
struct MethodFound {
    problem: Problem,
    bounded: Bounded,
    verdict: Verdict,
    freed: BTreeSet<usize>,
    cause: Option<Cause>,
    fewest: bool,
    /// How far it is shown that no fewer could be freed, as a makespan; `None` for ever.
    fewest_within: Option<u32>,
}

/// Goes on by a method.
pub(super) fn run(case: &MethodCase<'_, '_>) -> MethodAnswer {
    let (freed, cause) = match free_impossible(case) {
        Ok(freed) => freed,
        Err(answer) => return *answer,
    };
    let problem = match case.problem(&freed) {
        Ok(problem) => problem,
        Err(trouble) => return without_search(case, trouble),
    };
    let bounded = case.bounded(&problem);
    let verdict = search(case, &problem, &bounded, &freed);
    let found = MethodFound {
        problem,
        bounded,
        verdict,
        freed,
        cause,
        fewest: true,
        fewest_within: None,
    };
    let none = found.verdict.best.is_none() && found.verdict.stop.is_none();
    if !none || case.held(&found.freed).is_empty() {
        return answer(case, &found);
    }
    match case.fewest(&found.freed) {
        Ok(Some(fewest)) => match free_fewest(case, &found, fewest) {
            Ok(better) => answer(case, &better),
            Err(stop) => answer(case, &stopped(found, stop)),
        },
        // No path is the cause.
        Ok(None) => answer(case, &found),
        Err(stop) => answer(case, &stopped(found, stop)),
    }
}

/// The search for the best plan with these agents freed; it tells the host of
/// each better one, behind the past.
fn search(
    case: &MethodCase<'_, '_>,
    problem: &Problem,
    bounded: &Bounded,
    freed: &BTreeSet<usize>,
) -> Verdict {
    let on_better = |walks: &[Walk], _| {
        if let Some((plan, costs)) = judged(case, problem, freed, walks, &[]) {
            case.budget.report(&Progress::Plan { costs, plan });
        }
    };
    let contact = Contact {
        start: None,
        earlier: None,
        on_better: &on_better,
    };
    solve(problem, case.objective, bounded, &contact, &case.budget)
}

/// The same, ended by the budget.
fn stopped(mut found: MethodFound, stop: Stop) -> MethodFound {
    found.verdict.stop = Some(stop);
    found.fewest = false;
    found
}

/// Frees those who cannot do by themselves what the method asks for.
fn free_impossible(
    case: &MethodCase<'_, '_>,
) -> Result<(BTreeSet<usize>, Option<Cause>), Box<MethodAnswer>> {
    let mut freed = BTreeSet::new();
    let mut causes: BTreeMap<usize, MethodRefusal> = BTreeMap::new();
    let terrain = case.terrain();
    let is_blocked = |agent: &Agent| keep::blocked(agent, &terrain).is_some();
    let agents = case.snapshot.instance.agents().iter();
    for (number, (agent, running)) in agents.zip(&case.snapshot.agents).enumerate() {
        if !is_blocked(agent)
            && let Err(fault) = keep::bounds(case.method, agent, running, &terrain)
        {
            freed.insert(number);
            causes.insert(number, fault);
        }
    }
    loop {
        match case.problem(&freed) {
            Ok(_) => break,
            Err(trouble @ (Trouble::Alone(agent, fault, _) | Trouble::Held(agent, fault)))
                if case.held(&freed).contains(&agent) =>
            {
                if case
                    .agent(agent)
                    .is_some_and(|(agent, _)| is_blocked(agent))
                {
                    return Err(Box::new(without_search(case, trouble)));
                }
                freed.insert(agent);
                causes.insert(agent, fault);
            }
            Err(trouble) => return Err(Box::new(without_search(case, trouble))),
        }
    }
    let first = causes.first_key_value();
    let cause = first.map(|(&agent, &fault)| cause_of(case, agent, fault));
    Ok((freed, cause))
}

/// The best plan of those with the fewest agents freed.
fn free_fewest(
    case: &MethodCase<'_, '_>,
    before: &MethodFound,
    fewest: Fewest,
) -> Result<MethodFound, Stop> {
    let shown = before.verdict.reach.and_then(Proved::within);
    let within = match shown {
        Some(within) if !case.is_deadlocked(&before.freed)? => Some(case.snapshot.at + within),
        _ => None,
    };
    let cause = blocked(case, &fewest.core, &before.freed, within);
    let fewest_within = fewest.within.map(|within| case.snapshot.at + within);
    let mut best: Option<MethodFound> = None;
    let mut stop = fewest.left;
    let mut reach: Option<Proved> = None;
    for freed in fewest.sets {
        let problem = match case.problem(&freed) {
            Ok(problem) => problem,
            Err(Trouble::Stopped(why)) => {
                stop = Some(why);
                break;
            }
            Err(_) => continue,
        };
        let bounded = case.bounded(&problem);
        let verdict = search(case, &problem, &bounded, &freed);
        // The best of all sets is shown as far as each was looked at.
        stop = stop.or(verdict.stop);
        reach = match (reach, verdict.reach) {
            (Some(reach), Some(own)) => Some(reach.and(own)),
            (one, other) => one.or(other),
        };
        let vector = |found: &Verdict| {
            let costs = found.best.as_ref().map(|(_, costs)| *costs);
            costs.map(|costs| costs.vector(case.objective))
        };
        let better = match (&best, vector(&verdict)) {
            (_, None) => false,
            (None, _) => true,
            (Some(best), own) => own < vector(&best.verdict),
        };
        if better {
            best = Some(MethodFound {
                problem,
                bounded,
                verdict,
                freed,
                cause: before.cause.clone().or_else(|| Some(cause.clone())),
                fewest: true,
                fewest_within,
            });
        }
    }
    let mut best = best.ok_or(stop.unwrap_or(Stop::Contradiction))?;
    best.verdict.reach = reach;
    best.verdict.stop = stop;
    Ok(best)
}
