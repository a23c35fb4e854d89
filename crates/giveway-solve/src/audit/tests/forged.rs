//! A search that contradicts the judge is not believed.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Instance, Plan, check::check};

use super::{audit, request};
use crate::audit::{AuditStatus, conclude::conclude};
use crate::budget::Stop;
use crate::tests::instance;
use crate::{Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve};

fn solved(instance: &Instance) -> SolveAnswer {
    let request = SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(request), &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

/// Two in a corridor with a bay.
fn bay() -> (Instance, SolveAnswer) {
    let bay = instance(
        "a   .   B
         b   .   A",
    );
    let answer = solved(&bay);
    assert_eq!(answer.status, Status::Optimal);
    (bay, answer)
}

#[test]
fn what_a_legal_plan_disproves_is_never_claimed() {
    let (bay, honest) = bay();
    let plan = honest.plan.clone().unwrap();
    let objective = bay.objective().clone();
    let own = honest.costs.unwrap();
    let first = objective.costs()[0];
    let last = objective.costs()[1];
    let above = |cost: Cost, by: u32| {
        let mut bounds = honest.bounds.clone();
        bounds.insert(cost, own.get(cost) + by);
        bounds
    };
    let worse = Costs {
        makespan: own.makespan + 1,
        ..own
    };
    let forged = [
        SolveAnswer {
            bounds: above(first, 1),
            ..honest.clone()
        },
        SolveAnswer {
            bounds: above(last, 3),
            status: Status::Feasible,
            ..honest.clone()
        },
        SolveAnswer {
            status: Status::Impossible,
            costs: None,
            plan: None,
            bounds: BTreeMap::new(),
            ..honest.clone()
        },
        SolveAnswer {
            costs: Some(worse),
            ..honest.clone()
        },
        SolveAnswer {
            costs: None,
            plan: None,
            ..honest.clone()
        },
    ];
    for forged in forged {
        let answer = conclude(objective.clone(), check(&bay, &plan), forged);
        assert_eq!(answer.status, AuditStatus::Unknown);
        assert_eq!(answer.bounds, BTreeMap::new());
        assert_eq!((answer.gap, &answer.better), (None, &None));
        assert!(!answer.reach.is_complete());
        assert!(answer.reason == Some(Stop::Contradiction.into()));
    }
    let answer = conclude(objective, check(&bay, &plan), honest);
    assert_eq!(answer.status, AuditStatus::Optimal);
}

#[test]
fn a_bound_on_a_later_cost_says_nothing_of_a_plan_that_is_worse_before() {
    let (bay, honest) = bay();
    let objective = bay.objective().clone();
    let mut plan = honest.plan.clone().unwrap();
    for path in plan.paths.values_mut() {
        path.insert(0, path[0]);
    }
    let mut search = honest;
    // Among the plans of least makespan the sum may be larger than in this one.
    let own = check(&bay, &plan).costs.unwrap();
    search.bounds.insert(Cost::SumOfCosts, own.sum_of_costs + 5);
    let answer = conclude(objective, check(&bay, &plan), search);
    assert_eq!(answer.status, AuditStatus::Feasible);
}

#[test]
fn an_illegal_plan_is_never_the_best_whatever_it_costs() {
    let (bay, honest) = bay();
    let mut plan = honest.plan.unwrap();
    let path = plan.paths.get_mut("a").unwrap();
    let goal = *path.last().unwrap();
    path.truncate(1);
    path.push(goal);
    let answer = audit(&request(&bay, &plan), &SilentHost);
    assert_eq!(answer.status, AuditStatus::Illegal);
    assert_eq!(answer.gap, None);
    assert_eq!(answer.better_costs, honest.costs);
    assert_eq!(answer.search, Status::Optimal);
}

#[test]
fn where_there_is_no_legal_plan_that_is_said() {
    let walled = instance(
        "a   #   A
         b   B   #",
    );
    let answer = audit(&request(&walled, &Plan::default()), &SilentHost);
    assert_eq!(answer.status, AuditStatus::Illegal);
    assert_eq!(answer.search, Status::Impossible);
    assert!(answer.reach.is_complete());
    assert_eq!(answer.costs, None);
}

#[test]
fn the_plan_itself_is_always_within_the_horizon() {
    let (bay, honest) = bay();
    let mut plan = honest.plan.unwrap();
    for path in plan.paths.values_mut() {
        for _ in 0..9 {
            path.insert(0, path[0]);
        }
    }
    let mut request = request(&bay, &plan);
    request.within = Some(0);
    let answer = audit(&request, &SilentHost);
    assert_eq!(answer.status, AuditStatus::Feasible);
    assert_eq!(answer.better_costs, honest.costs);
}
