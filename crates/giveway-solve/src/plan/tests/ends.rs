//! How planners end, and what is claimed of their plans.

use giveway_model::Cost;
use serde_json::{Value, json};

use super::{CROSSING, SWAP, planned, planned_by, request, said};
use crate::{
    Host, Limits, Progress, Reach, Refusal, Request, Response, SilentHost,
    budget::Stop,
    plan::{Lack, PlanEnd, PlanRequest, Planner},
    serve,
};

#[test]
fn cbs_is_best_in_the_first_cost() {
    let answer = planned(request(CROSSING, Planner::Cbs));
    assert_eq!(
        answer.ended,
        PlanEnd::Best {
            reach: Reach::unproved(None)
        }
    );
    assert_eq!(answer.bounds.get(&Cost::SumOfCosts), Some(&5));
    assert_eq!(answer.costs.unwrap().sum_of_costs, 5);
    assert!(answer.plan.is_some() && answer.trace.is_none());
    assert_eq!(answer.stats.steps, 2);
    assert_eq!(
        said(&answer),
        "Best plan: sum of costs 5, makespan 3. No plan has a smaller sum of costs, no matter how \
         many steps you allow."
    );
}

#[test]
fn an_order_works_or_it_does_not() {
    let answer = planned(request(CROSSING, Planner::Prioritised));
    assert_eq!(answer.ended, PlanEnd::Found);
    assert!(answer.bounds.is_empty());
    assert_eq!(
        said(&answer),
        "Plan found: sum of costs 5, makespan 3. There may be better plans."
    );
    let in_order = PlanRequest {
        order: Some(vec!["B".to_owned()]),
        ..request(SWAP, Planner::Prioritised)
    };
    assert_eq!(
        said(&planned(in_order)),
        "This order does not work within makespan 28: A cannot get past B. Another order or another planner may find \
         a plan."
    );
    let found = said(&planned(request(SWAP, Planner::Prioritised)));
    assert!(
        found.starts_with("No plan found: none of 2 orders works within makespan 28."),
        "{found}"
    );
}

#[test]
fn an_order_of_strangers_is_refused() {
    let request = PlanRequest {
        order: Some(vec!["C".to_owned()]),
        ..request(SWAP, Planner::Prioritised)
    };
    let response = serve(&Request::Plan(request), &SilentHost);
    let Response::Refused(Refusal::Request { fault }) = response else {
        panic!("{response:?}");
    };
    assert_eq!(fault.place, "order");
}

/// A host that asks to stop after it was asked a hundred times.
struct Impatient(std::cell::Cell<u32>);

impl Host for Impatient {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.0.set(self.0.get() + 1);
        self.0.get() > 100
    }

    fn progress(&self, _: &Progress) {}
}

#[test]
fn without_a_plan_cbs_never_says_that_there_is_none() {
    let endless = PlanRequest {
        within: Some(40),
        ..request(SWAP, Planner::Cbs)
    };
    let answer = planned_by(endless, &Impatient(0.into()));
    let PlanEnd::Stopped { reason } = &answer.ended else {
        panic!("{answer:?}");
    };
    assert_eq!(*reason, Stop::Cancelled.into());
    assert!(answer.bounds[&Cost::Makespan] > 2);
    let text = said(&answer);
    assert!(
        text.contains("There may be a plan; none was found yet."),
        "{text}"
    );
    // Where all plans up to a horizon are excluded, longer ones are not.
    let short = PlanRequest {
        within: Some(3),
        ..request(SWAP, Planner::Cbs)
    };
    let answer = planned(short);
    assert_eq!(answer.ended, PlanEnd::Horizon { within: 3 });
    assert_eq!(answer.bounds[&Cost::Makespan], 4);
}

#[test]
fn what_a_planner_cannot_do_it_says() {
    let scene = CROSSING.replace(
        r#""goal": [2, 1]"#,
        r#""goal": [2, 1], "waypoints": [[1, 2]]"#,
    );
    let answer = planned(request(&scene, Planner::Pibt));
    let lack = Lack::Waypoints {
        agent: "A".to_owned(),
    };
    assert_eq!(answer.ended, PlanEnd::Refused { lack });
    assert_eq!(
        said(&answer),
        "Not for this planner: PIBT cannot plan for waypoints, and A has some."
    );
    assert!(answer.plan.is_none());
    let scene = CROSSING.replace(r#""sum-of-costs""#, r#""waits""#);
    let answer = planned(request(&scene, Planner::Cbs));
    let lack = Lack::Cost { cost: Cost::Waits };
    assert_eq!(answer.ended, PlanEnd::Refused { lack });
}

#[test]
fn who_cannot_do_its_task_alone_is_named() {
    let scene = SWAP.replace("...", ".#.");
    let answer = planned(request(&scene, Planner::Cbs));
    assert_eq!(
        said(&answer),
        "No plan exists, no matter how many steps you allow: A cannot do its task, even alone."
    );
}

#[test]
fn a_budget_that_is_spent_is_said() {
    let spent = PlanRequest {
        limits: Limits {
            memory_bytes: Some(1),
            ..Limits::default()
        },
        ..request(CROSSING, Planner::Prioritised)
    };
    let answer = planned(spent);
    assert!(
        matches!(answer.ended, PlanEnd::Stopped { .. }),
        "{answer:?}"
    );
}

#[test]
fn neighbourhoods_lessen_a_penalty_that_the_objective_does_not_name() {
    // The planned order lets B wait where each time costs 2; A may wait as well.
    let mut scene: Value = serde_json::from_str(CROSSING).unwrap();
    scene["zones"] = json!([{ "name": "dock", "cells": [[1, 0]] }]);
    scene["constraints"] = json!([{ "kind": "avoid", "zone": "dock", "weight": 2 }]);
    let scene = scene.to_string();
    let costs = |planner| {
        let answer = planned(request(&scene, planner));
        let costs = answer.objective.costs();
        assert_eq!(costs, [Cost::SumOfCosts, Cost::Makespan, Cost::Penalty]);
        answer.costs.unwrap().vector(&answer.objective)
    };
    assert_eq!(costs(Planner::Prioritised), [5, 3, 4]);
    assert_eq!(costs(Planner::Lns), [5, 3, 2]);
}

#[test]
fn pibt_says_after_how_many_steps_it_ended() {
    let answer = planned(request(SWAP, Planner::Pibt));
    let text = said(&answer);
    assert!(
        text.ends_with("There may be a plan; none was found yet."),
        "{text}"
    );
    assert!(
        text.starts_with("After 112 steps 0 of 2 robots were at their goals"),
        "{text}"
    );
}

/// A horizon, and not the robots, may be why there is no plan.
#[test]
fn what_ends_with_the_horizon_says_so() {
    let lane = r#"{ "giveway": 1, "map": ["......"],
        "agents": [{ "name": "A", "start": [0, 0], "goal": [5, 0] }] }"#;
    let within = |planner, within| {
        said(&planned(PlanRequest {
            within: Some(within),
            ..request(lane, planner)
        }))
    };
    assert_eq!(
        within(Planner::Pibt, 3),
        "After 3 steps 0 of 1 robots were at their goals, and the planner ended. \
         There may be a plan; none was found yet."
    );
    for planner in [Planner::Lacam, Planner::Lns] {
        assert_eq!(
            within(planner, 3),
            "The planner's search came to its end without a plan that fits. \
             There may be a plan; none was found yet."
        );
    }
    let order = planned(PlanRequest {
        within: Some(2),
        ..request(CROSSING, Planner::Prioritised)
    });
    let PlanEnd::NoOrderWorks { within, .. } = order.ended else {
        panic!("{order:?}");
    };
    assert_eq!(within, 2);
    assert!(
        said(&order).contains("within makespan 2"),
        "{}",
        said(&order)
    );
}
