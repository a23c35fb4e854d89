//! Plans that go on in a changed world: the solver asked, and what differs from the
//! oracle.

use giveway_model::change::Changes;
use giveway_model::{Cost, Instance, Objective, Plan};
use giveway_solve::change::{ChangeAnswer, ChangeRequest, Method, MethodAnswer};
use giveway_solve::{Limits, Refusal, Request, Response, SilentHost, SolveRequest, Status, serve};

use crate::oracle::{Changed, Held, Known};

/// Joint states that the oracle may look at.
const CAP: usize = 30_000;

/// An optimal plan of an instance.
pub fn plan_of(instance: &Instance) -> Option<Plan> {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        limits: limits(),
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer.plan,
        other => panic!("{other:?}"),
    }
}

fn limits() -> Limits {
    Limits {
        conflicts: Some(20_000),
        ..Limits::default()
    }
}

/// How to go on; `None` where the changes contradict the world.
pub fn go_on(
    instance: &Instance,
    plan: &Plan,
    changes: &Changes,
    methods: &[Method],
) -> Option<ChangeAnswer> {
    let request = Request::Change(ChangeRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.clone(),
        since: None,
        methods: methods.to_vec(),
        objective: None,
        within: None,
        limits: limits(),
    });
    match serve(&request, &SilentHost) {
        Response::Changed(answer) => Some(*answer),
        Response::Refused(Refusal::Changes { .. }) => None,
        other => panic!("{other:?}"),
    }
}

/// The makespan and the costs of the objective: what the oracle counts.
pub fn costs(instance: &Instance) -> Vec<Cost> {
    let others = instance.objective().costs().iter().copied();
    let others = others.filter(|&cost| cost != Cost::Makespan);
    [Cost::Makespan].into_iter().chain(others).collect()
}

/// There were too many joint states.
#[derive(Debug)]
pub struct TooMany;

/// The fewest agents freed with which there is a way, and the best of these.
///
/// # Errors
/// When there are more joint states than it may look at.
pub fn oracle(changed: &mut Changed, held: Held) -> Result<Option<(usize, Vec<u32>)>, TooMany> {
    let old: Vec<String> = changed.old().into_iter().map(str::to_owned).collect();
    let most = if held == Held::Nothing { 0 } else { old.len() };
    for size in 0..=most {
        let mut best: Option<Vec<u32>> = None;
        for set in 0_u32..1 << old.len() {
            if set.count_ones() as usize != size {
                continue;
            }
            let freed: Vec<&str> = (0..old.len())
                .filter(|i| set & 1 << i != 0)
                .map(|i| old[i].as_str())
                .collect();
            match changed.best(held, &freed, CAP) {
                Known::Capped => return Err(TooMany),
                Known::None => {}
                Known::Best(vector) => {
                    best = Some(best.map_or(vector.clone(), |best| best.min(vector)));
                }
            }
        }
        if let Some(best) = best {
            return Ok(Some((size, best)));
        }
    }
    Ok(None)
}

/// What differs between an answer and the oracle.
pub fn difference(
    costs: &[Cost],
    method: &MethodAnswer,
    known: Option<&(usize, Vec<u32>)>,
) -> Option<String> {
    let result = &method.result;
    let told = |what: &str| Some(format!("{what}: the oracle has {known:?}, not {method:?}"));
    match (result.status, known) {
        (Status::Impossible, Some((_, vector))) => match result.reach.within() {
            Some(within) if vector[0] > within => None,
            _ => told("impossible"),
        },
        (Status::Optimal, Some((freed, vector))) => {
            let objective = Objective::new(costs.to_vec()).unwrap();
            let own = result.costs.unwrap().vector(&objective);
            let disturbed = method.retimed.len() + method.rerouted.len();
            if own != vector[..costs.len()] {
                told("costs")
            } else if method.freed.len() != *freed || !method.fewest {
                told("freed")
            } else if *freed == 0 && method.closest && disturbed as u32 != vector[costs.len()] {
                told("disturbed")
            } else if result
                .bounds
                .iter()
                .any(|(&cost, &bound)| result.costs.unwrap().get(cost) != bound)
            {
                told("bounds")
            } else {
                None
            }
        }
        (Status::Impossible, None) | (Status::Unknown | Status::Feasible, _) => None,
        (Status::Optimal, None) => told("optimal"),
    }
}
