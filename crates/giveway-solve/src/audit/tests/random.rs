//! Random instances: their best plans, plans on the way to them, and plans of which
//! one step is spoiled.

use std::cell::{Cell, RefCell};

use fastrand::Rng;
use giveway_model::{Cell as Square, Costs, Instance, Plan, check::check};

use super::{audit, request};
use crate::audit::{AuditAnswer, AuditStatus};
use crate::tests::random;
use crate::{Host, Progress, Request, Response, SilentHost, SolveRequest, Status, serve};

/// Notes the events, and gives up after so many questions whether to.
struct Listener {
    events: RefCell<Vec<Progress>>,
    questions: Cell<u32>,
}

impl Listener {
    fn new(questions: u32) -> Self {
        Self {
            events: RefCell::default(),
            questions: Cell::new(questions),
        }
    }
}

impl Host for Listener {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        let left = self.questions.get();
        self.questions.set(left.saturating_sub(1));
        left == 0
    }

    fn progress(&self, event: &Progress) {
        self.events.borrow_mut().push(event.clone());
    }
}

/// A best plan with its costs, and the plans found before it.
fn solved(instance: &Instance) -> Option<(Plan, Costs, Vec<Plan>)> {
    let host = Listener::new(u32::MAX);
    let request = SolveRequest {
        scene: instance.to_scene(),
        limits: request(instance, &Plan::default()).limits,
        ..SolveRequest::default()
    };
    let Response::Solved(answer) = serve(&Request::Solve(request), &host) else {
        panic!("no answer");
    };
    if answer.status != Status::Optimal {
        return None;
    }
    let plans = host.events.into_inner().into_iter();
    let plans = plans.filter_map(|event| match event {
        Progress::Plan { plan, .. } => Some(plan),
        _ => None,
    });
    Some((answer.plan?, answer.costs?, plans.collect()))
}

/// What must be so of every audit that was not cut short.
fn judge(instance: &Instance, best: &Costs, plan: &Plan, answer: &AuditAnswer) -> AuditStatus {
    let vector = |costs: &Costs| costs.vector(instance.objective());
    let report = check(instance, plan);
    assert_eq!(answer.violations, report.violations);
    assert_eq!(answer.costs, report.costs);
    assert_eq!(answer.legal, report.is_valid());
    assert_eq!(answer.search, Status::Optimal);
    if let (Some(better), Some(costs)) = (&answer.better, &answer.better_costs) {
        let report = check(instance, better);
        assert_eq!(
            (report.violations, report.costs),
            (Vec::new(), Some(*costs))
        );
        assert_eq!(vector(costs), vector(best));
    }
    let own = report.costs.filter(|_| report.violations.is_empty());
    let expected = match own {
        None => AuditStatus::Illegal,
        Some(own) if vector(&own) == vector(best) => AuditStatus::Optimal,
        Some(_) => AuditStatus::Feasible,
    };
    assert_eq!(answer.status, expected);
    assert_eq!(answer.better.is_none(), expected == AuditStatus::Optimal);
    if expected == AuditStatus::Optimal {
        assert_eq!(answer.gap, Some(0.0));
    }
    expected
}

#[test]
fn the_best_plan_is_found_to_be_it_and_no_other_is() {
    let mut counts = [0, 0];
    for seed in 0..120 {
        let instance = random(seed, 3);
        let Some((plan, best, others)) = solved(&instance) else {
            continue;
        };
        let answer = audit(&request(&instance, &plan), &SilentHost);
        assert_eq!(
            judge(&instance, &best, &plan, &answer),
            AuditStatus::Optimal
        );
        counts[0] += 1;
        for other in others {
            let answer = audit(&request(&instance, &other), &SilentHost);
            let found = judge(&instance, &best, &other, &answer);
            counts[1] += u32::from(found == AuditStatus::Feasible);
        }
    }
    assert!(counts[0] > 30 && counts[1] > 5, "{counts:?}");
}

/// A plan with one step otherwise: elsewhere, twice, or left out.
fn spoiled(instance: &Instance, plan: &Plan, rng: &mut Rng) -> Plan {
    let mut plan = plan.clone();
    let agents = instance.agents();
    let agent = &agents[rng.usize(..agents.len())].name;
    let path = plan.paths.get_mut(agent).unwrap();
    let at = rng.usize(..path.len());
    match rng.u32(..4) {
        0 => path.insert(at, path[at]),
        1 if path.len() > 1 => drop(path.remove(at)),
        _ => {
            let grid = instance.grid();
            let cell = Square::new(rng.u32(..grid.width()), rng.u32(..grid.height()));
            path[at] = Some(cell);
        }
    }
    plan
}

#[test]
fn a_plan_with_one_step_spoiled_is_illegal_or_not_the_best() {
    let mut counts = [0, 0, 0];
    for seed in 0..120 {
        let instance = random(seed, 3);
        let Some((plan, best, _)) = solved(&instance) else {
            continue;
        };
        let mut rng = Rng::with_seed(seed);
        for _ in 0..6 {
            let spoiled = spoiled(&instance, &plan, &mut rng);
            let answer = audit(&request(&instance, &spoiled), &SilentHost);
            counts[judge(&instance, &best, &spoiled, &answer) as usize] += 1;
        }
    }
    let [_, feasible, illegal] = counts;
    assert!(feasible > 5 && illegal > 50, "{counts:?}");
}

#[test]
fn however_soon_it_ends_a_bound_is_known_and_none_is_too_high() {
    let mut within = 0;
    let orders = ["sum-of-costs,makespan", "moves,makespan", "waits,moves"];
    for seed in 0..100 {
        let order = orders[seed as usize % orders.len()];
        let instance = random(seed, 3).with_objective(order.parse().unwrap());
        let Some((plan, best, others)) = solved(&instance) else {
            continue;
        };
        let plan = others.first().unwrap_or(&plan);
        let first = instance.objective().costs()[0];
        for (questions, horizon) in [(3, None), (20, None), (40, Some(1)), (80, Some(4))] {
            let host = Listener::new(questions);
            let mut request = request(&instance, plan);
            request.within = horizon;
            let answer = audit(&request, &host);
            let events = host.events.into_inner();
            let is_first = match events.first() {
                Some(Progress::Bound { cost, .. }) => *cost == first,
                _ => answer.bounds.is_empty(), // it ended before a bound was counted
            };
            assert!(is_first, "{seed}: {events:?}");
            assert!(answer.legal, "{seed}");
            if let Some(&bound) = answer.bounds.get(&first) {
                let own = answer.costs.unwrap().get(first);
                assert!(bound <= own, "{seed}");
                assert!(
                    !answer.reach.is_complete() || bound <= best.get(first),
                    "{seed}"
                );
                assert!(
                    answer.reach.is_complete() || answer.reach.within().is_some(),
                    "{seed}"
                );
            } else {
                assert_eq!(answer.status, AuditStatus::Unknown, "{seed}");
            }
            within += u32::from(!answer.reach.is_complete());
        }
    }
    assert!(within > 0);
}
