//! A request for plans of more and more robots, solved one number after the other.

use std::rc::Rc;

use giveway_model::{Fault, Instance, Objective, Scene, Version};

use super::{SizingAnswer, SizingFloor, SizingPoint, SizingRequest, SlowestAlone, words};
use crate::{
    Host, Progress, Refusal, Stats, assumed,
    budget::Budget,
    problem::Problem,
    solve::{self, SolveTask},
};

/// Serves a request for plans of more and more robots, and tells the host of each plan.
///
/// # Errors
/// When a scene is no instance, or the numbers of robots are none of it.
pub(crate) fn serve(request: &SizingRequest, host: &dyn Host) -> Result<SizingAnswer, Refusal> {
    let this = instance(&request.scene, request.objective.as_ref())?;
    let beside = request.beside.as_ref();
    let beside = beside.map(|scene| instance(scene, request.objective.as_ref()));
    let beside = beside.transpose()?;
    let floors: Vec<(SizingFloor, &Instance)> = [
        Some((SizingFloor::This, &this)),
        beside.as_ref().map(|beside| (SizingFloor::Beside, beside)),
    ]
    .into_iter()
    .flatten()
    .collect();
    fits(request, &floors)?;
    let mut answer = SizingAnswer {
        giveway: Version,
        objective: this.objective().clone(),
        points: Vec::new(),
        beside: Vec::new(),
        pending: (request.counts.len() * floors.len()) as u32,
        words: String::new(),
        stats: Stats::default(),
    };
    'all: for &robots in &request.counts {
        for &(floor, instance) in &floors {
            if host.cancelled() {
                break 'all;
            }
            let (point, stats) = point(instance, robots, request, host);
            add(&mut answer.stats, &stats);
            // A plan that was cut off says nothing of how many robots the floor bears.
            if host.cancelled() && point.plan.is_none() {
                break 'all;
            }
            answer.pending -= 1;
            host.progress(&Progress::Sized {
                floor,
                point: Box::new(point.clone()),
                pending: answer.pending,
            });
            match floor {
                SizingFloor::This => answer.points.push(point),
                SizingFloor::Beside => answer.beside.push(point),
            }
        }
    }
    answer.words = words::all(&answer);
    Ok(answer)
}

/// The floor with all of its robots, under the objective that is in force.
fn instance(scene: &Scene, objective: Option<&Objective>) -> Result<Instance, Refusal> {
    let instance = Instance::new(scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    let objective = objective.unwrap_or_else(|| instance.objective()).clone();
    let objective = instance.in_force(objective);
    Ok(instance.with_objective(objective))
}

/// Whether the numbers are ascending, and each floor has so many robots.
fn fits(request: &SizingRequest, floors: &[(SizingFloor, &Instance)]) -> Result<(), Refusal> {
    let counts = &request.counts;
    let most = floors.iter().map(|(_, floor)| floor.agents().len()).min();
    let most = most.unwrap_or(0);
    let wrong = (0..counts.len()).find(|&place| {
        let before = place.checked_sub(1).map_or(0, |before| counts[before]);
        counts[place] <= before || counts[place] as usize > most
    });
    let (found, expected) = match wrong {
        Some(place) => (
            format!("{} at {place}", counts[place]),
            format!("ascending numbers of robots from 1 to {most}"),
        ),
        None if counts.is_empty() => (
            "no number".to_owned(),
            format!("numbers of robots from 1 to {most}"),
        ),
        None => return Ok(()),
    };
    let fault = Fault::at("counts", found, expected);
    Err(Refusal::Request { fault })
}

/// The best plan of the first robots of a floor, so many of them.
fn point(
    floor: &Instance,
    robots: u32,
    request: &SizingRequest,
    host: &dyn Host,
) -> (SizingPoint, Stats) {
    let mut instance = floor.clone();
    instance.truncate_agents(robots as usize);
    let objective = instance.objective().clone();
    let budget = Rc::new(Budget::new(host, request.limits));
    let lone = Problem::new(&instance, &budget).ok();
    let least = |problem: &Problem| -> Vec<u32> {
        let agents = 0..problem.agents();
        agents.map(|agent| problem.least_cost(agent)).collect()
    };
    let least = lone.as_ref().map(least);
    let slowest = least.iter().flatten().max().copied().and_then(|steps| {
        let place = least.iter().flatten().position(|&it| it == steps)?;
        let agent = instance.agents().get(place)?.name.clone();
        Some(SlowestAlone { agent, steps })
    });
    let task = SolveTask {
        instance: instance.clone(),
        objective: objective.clone(),
        within: request.within,
        start: None,
        as_found: false,
        budget,
    };
    let mut answer = solve::solve(&task).answer;
    assumed::weaken_solved((&instance, &objective), &mut answer);
    let point = SizingPoint {
        robots,
        status: answer.status,
        costs: answer.costs,
        bounds: answer.bounds,
        reach: answer.reach,
        reason: answer.reason,
        alone: least.map(|least| least.into_iter().fold(0, u32::saturating_add)),
        slowest,
        plan: answer.plan,
    };
    (point, answer.stats)
}

/// The work of all solves together.
fn add(sum: &mut Stats, one: &Stats) {
    sum.cpu_seconds += one.cpu_seconds;
    sum.solver_calls = sum.solver_calls.saturating_add(one.solver_calls);
    sum.variables = sum.variables.max(one.variables);
    sum.clauses = sum.clauses.max(one.clauses);
    sum.conflicts = sum.conflicts.saturating_add(one.conflicts);
    sum.work = sum.work.saturating_add(one.work);
}
