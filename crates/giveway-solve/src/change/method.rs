//! One method at one time: its problem, its search, its answer.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{
    Cost, Costs, Plan, Version,
    check::{check_history, costs_over_time},
    sorting,
};

use super::{
    Cause, CauseKind, Method, MethodAnswer,
    compare::{Comparison, compare},
    freed::{Case, Fewest, Trouble},
    keep::{self, Fault},
    splice::splice,
    words,
};
use crate::{
    Progress, SolveAnswer, Status,
    budget::Stop,
    judged::{Judged, told},
    problem::Problem,
    search::{Aim, Before, Bounded, Contact, Extent, Reach, Verdict, closest, solve},
    walk::Walk,
};

/// What a method found, with the agents that it freed.
struct MethodFound {
    problem: Problem,
    bounded: Bounded,
    verdict: Verdict,
    freed: BTreeSet<usize>,
    cause: Option<Cause>,
    fewest: bool,
}

/// Goes on by a method.
pub(super) fn run(case: &Case<'_, '_>) -> MethodAnswer {
    let (freed, cause) = match free_hopeless(case) {
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
        // Nobody's path is to blame.
        Ok(None) => answer(case, &found),
        Err(stop) => answer(case, &stopped(found, stop)),
    }
}

/// The search for the best plan with these agents freed; it tells the host of
/// each better one, behind the past.
fn search(
    case: &Case<'_, '_>,
    problem: &Problem,
    bounded: &Bounded,
    freed: &BTreeSet<usize>,
) -> Verdict {
    let on_better = |walks: &[Walk]| {
        if let Some((plan, costs)) = judged(case, problem, freed, walks, &[]) {
            case.budget.report(&Progress::Plan { costs, plan });
        }
    };
    let contact = Contact {
        start: None,
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
fn free_hopeless(
    case: &Case<'_, '_>,
) -> Result<(BTreeSet<usize>, Option<Cause>), Box<MethodAnswer>> {
    let mut freed = BTreeSet::new();
    let mut causes: BTreeMap<usize, Fault> = BTreeMap::new();
    let terrain = case.world.terrain();
    for (agent, member) in case.world.members.iter().enumerate() {
        if keep::blocked(member, &terrain).is_none()
            && let Err(fault) = keep::bounds(case.method, member, &terrain)
        {
            freed.insert(agent);
            causes.insert(agent, fault);
        }
    }
    loop {
        match case.problem(&freed) {
            Ok(_) => break,
            Err(trouble @ (Trouble::Alone(agent, fault, _) | Trouble::Held(agent, fault)))
                if case.held(&freed).contains(&agent) =>
            {
                let member = case.member(agent);
                if member.is_some_and(|member| keep::blocked(member, &terrain).is_some()) {
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
    case: &Case<'_, '_>,
    before: &MethodFound,
    fewest: Fewest,
) -> Result<MethodFound, Stop> {
    let shown = before.verdict.reach.and_then(Reach::within);
    let within = match shown {
        Some(within) if !case.is_deadlocked(&before.freed)? => Some(case.world.at + within),
        _ => None,
    };
    let cause = blocked(case, &fewest.core, within);
    let mut best: Option<MethodFound> = None;
    let mut stop = fewest.left;
    let mut reach: Option<Reach> = None;
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
            });
        }
    }
    let mut best = best.ok_or(stop.unwrap_or(Stop::Contradiction))?;
    best.verdict.reach = reach;
    best.verdict.stop = stop;
    Ok(best)
}

/// The answer where there is nothing to search in.
fn without_search(case: &Case<'_, '_>, trouble: Trouble) -> MethodAnswer {
    let name = |agent| case.member(agent).map_or("", |member| member.name.as_str());
    let (status, reach, reason, cause) = match trouble {
        Trouble::Alone(agent, fault, reason) => {
            // However it is bound, it cannot.
            let free = Method::Replan;
            let text = words::cause(free, name(agent), fault.kind, fault.cell, &[]);
            let cause = Cause {
                agent: name(agent).to_owned(),
                kind: fault.kind,
                cell: fault.cell,
                agents: Vec::new(),
                within: None,
                text: text.clone(),
            };
            let reach = Reach::ForEver(reason);
            (Status::Impossible, Some(reach), text, Some(cause))
        }
        // (Whoever cannot be held to the method is freed before.)
        Trouble::Held(..) => {
            let reason = Stop::Contradiction.sentence().to_owned();
            (Status::Unknown, None, reason, None)
        }
        Trouble::TooManyWaypoints(agent) => {
            let name = name(agent);
            let reason = format!("{name} has more waypoints than can be planned for.");
            (Status::Unknown, None, reason, None)
        }
        Trouble::Stopped(stop) => (Status::Unknown, None, stop.sentence().to_owned(), None),
    };
    let (complete, within) = told(reach);
    MethodAnswer {
        result: SolveAnswer {
            giveway: Version,
            status,
            costs: None,
            bounds: BTreeMap::new(),
            within,
            complete,
            reason: Some(reason),
            plan: None,
            stats: case.budget.stats(),
        },
        kept: Vec::new(),
        retimed: Vec::new(),
        rerouted: Vec::new(),
        added: Vec::new(),
        freed: Vec::new(),
        fewest: false,
        cause,
        closest: false,
    }
}

/// A verdict as an answer: the plan with the fewest agents disturbed, put behind
/// the past and judged.
fn answer(case: &Case<'_, '_>, found: &MethodFound) -> MethodAnswer {
    let names = |agents: &mut dyn Iterator<Item = usize>| -> Vec<String> {
        let members = agents.filter_map(|agent| case.member(agent));
        members.map(|member| member.name.clone()).collect()
    };
    let stop = found.verdict.stop;
    let mut closest = false;
    let best = found.verdict.best.as_ref();
    let claim = (found.verdict.reach, stop);
    let judged = Judged::new(best, &Aim::Best, claim, |(walks, costs)| {
        let near = stop.is_none().then(|| disturb_few(case, found, *costs));
        let near = near.flatten();
        closest = near.as_ref().is_some_and(|near| near.2);
        let near = near
            .as_ref()
            .map(|(walks, same, _)| (walks.as_slice(), same.as_slice()));
        let judge =
            |walks: &[Walk], same: &[bool]| judged(case, &found.problem, &found.freed, walks, same);
        let judged = near.and_then(|(walks, same)| judge(walks, same));
        closest &= judged.is_some();
        judged.or_else(|| judge(walks, &[]))
    });
    let Judged {
        plan, status, stop, ..
    } = judged;
    let (complete, within) = told(judged.reach);
    let within = within.map(|within| case.world.at.saturating_add(within));
    let clash = &found.verdict.clash;
    let cause = match status {
        Status::Impossible => Some(blocked(case, clash, within)),
        _ => found.cause.clone(),
    };
    let reason = match (stop, &cause) {
        (Some(stop), _) => Some(stop.sentence().to_owned()),
        (None, Some(cause)) if status == Status::Impossible => Some(cause.text.clone()),
        _ => None,
    };
    let comparison = plan.as_ref().map(|(plan, _)| compare(case.world, plan));
    let Comparison {
        kept,
        retimed,
        rerouted,
        added,
    } = comparison.unwrap_or_default();
    let bounds = bounds(case, found, plan.as_ref().map(|(_, costs)| costs));
    let (plan, costs) = plan.unzip();
    MethodAnswer {
        result: SolveAnswer {
            giveway: Version,
            status,
            costs,
            bounds,
            within,
            complete,
            reason,
            plan,
            stats: case.budget.stats(),
        },
        kept,
        retimed,
        rerouted,
        added,
        freed: names(&mut found.freed.iter().copied()),
        fewest: found.fewest,
        cause,
        closest,
    }
}

/// Of all plans as good as the best, one that disturbs few old agents: its
/// walks, who does the same, and whether none disturbs fewer.
fn disturb_few(
    case: &Case<'_, '_>,
    found: &MethodFound,
    costs: Costs,
) -> Option<(Vec<Walk>, Vec<bool>, bool)> {
    let problem = &found.problem;
    let members = case.world.members.iter().zip(&problem.tasks);
    let before: Vec<Before> = members
        .map(|(member, task)| member.before(task, &problem.terrain))
        .collect();
    let objective = case.objective.costs().iter();
    let bounded = Bounded {
        horizon: found.bounded.horizon.up_to(costs.makespan),
        limits: sorting::map(objective.map(|&cost| (cost, costs.get(cost)))),
    };
    let near = closest(problem, &before, &bounded, Extent::Agents, &case.budget);
    let near = near.ok().flatten()?;
    Some((near.walks, near.same, near.proved.is_some()))
}

/// The plan behind the past with its costs, where the judge passes it and every
/// agent that is held to the method keeps to it.
fn judged(
    case: &Case<'_, '_>,
    problem: &Problem,
    freed: &BTreeSet<usize>,
    walks: &[Walk],
    same: &[bool],
) -> Option<(Plan, Costs)> {
    let plan = splice(case.world, problem, walks, same);
    let report = check_history(case.world.after, &plan);
    let costs = report.costs.filter(|_| report.is_valid())?;
    if case.method == Method::Revise {
        let held = case.held(freed);
        let rerouted = compare(case.world, &plan).rerouted;
        let strays = |agent: usize| {
            let member = case.member(agent);
            member.is_some_and(|member| rerouted.contains(&member.name))
        };
        if held.into_iter().any(strays) {
            return None;
        }
    }
    Some((plan, costs))
}

/// The proved bounds as costs from time 0: what is past, and that times count
/// from the change, is the same in every plan.
fn bounds(case: &Case<'_, '_>, found: &MethodFound, costs: Option<&Costs>) -> BTreeMap<Cost, u32> {
    let at = case.world.at;
    let own = found.verdict.best.as_ref().map(|(_, costs)| costs);
    let bounds = found.verdict.bounds.iter();
    let bounds = bounds.filter_map(|(&cost, &bound)| {
        if cost == Cost::Makespan && bound > 0 {
            return Some((cost, bound + at));
        }
        let (own, costs) = (own?, costs?);
        let past = costs.get(cost).checked_sub(own.get(cost))?;
        Some((cost, past + bound))
    });
    sorting::map(bounds)
}

fn cause_of(case: &Case<'_, '_>, agent: usize, fault: Fault) -> Cause {
    let name = case.member(agent).map_or("", |member| member.name.as_str());
    Cause {
        agent: name.to_owned(),
        kind: fault.kind,
        cell: fault.cell,
        agents: Vec::new(),
        within: None,
        text: words::cause(case.method, name, fault.kind, fault.cell, &[]),
    }
}

/// Agents that block each other, and where the first of them first meets
/// another of them if nobody waits.
fn blocked(case: &Case<'_, '_>, agents: &[usize], within: Option<u32>) -> Cause {
    let members = agents.iter().filter_map(|&agent| case.member(agent));
    let names: Vec<String> = members.clone().map(|member| member.name.clone()).collect();
    let first = members.clone().next();
    let others: Vec<_> = members.skip(1).collect();
    let cell = first.and_then(|first| {
        let mut cells = first.rest.iter();
        let met = |cell: &&giveway_model::Cell| others.iter().any(|it| it.rest.contains(cell));
        cells.find(met).copied()
    });
    let agent = names.first().cloned().unwrap_or_default();
    let text = words::cause(case.method, &agent, CauseKind::Blocked, cell, &names);
    Cause {
        agent,
        kind: CauseKind::Blocked,
        cell,
        agents: names,
        within,
        text,
    }
}

/// The costs of the plan before the changes.
pub(super) fn costs_before(case: &super::world::World<'_>) -> Option<Costs> {
    costs_over_time(case.before, case.plan)
}
