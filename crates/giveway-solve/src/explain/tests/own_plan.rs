//! A person's own plan, beside the best.

use std::rc::Rc;

use giveway_model::{Cost, Instance, Plan};

use super::{read, scenario_1};
use crate::{
    Limits, SilentHost,
    budget::Budget,
    explain::{
        answer::Excess,
        own_plan::{OwnPlanReport, judge},
        whole::WholePlan,
        words::own_plan,
    },
};

fn judged(instance: &Instance, plan: &Plan) -> (OwnPlanReport, String) {
    let budget = Rc::new(Budget::new(&SilentHost, Limits::default()));
    let whole = WholePlan::default();
    let judged = judge(instance, plan, instance.objective(), None, whole, &budget);
    let costs = judged.costs.unwrap_or_default();
    let better = judged.better.as_ref().map(|(_, costs)| costs);
    let words = own_plan(&judged, instance.objective(), &costs, better, None);
    (judged, words)
}

#[test]
fn an_optimal_plan_is_confirmed() {
    let (instance, plan, _) = scenario_1();
    let (judged, words) = judged(&instance, &plan);
    assert_eq!(judged.optimal, Some(true));
    assert_eq!(words, "The plan keeps all rules, and no plan is better.");
}

#[test]
fn of_a_broken_plan_every_violation_is_told() {
    let (instance, mut plan, _) = scenario_1();
    plan.paths.get_mut("A2").unwrap().remove(0);
    let (judged, words) = judged(&instance, &plan);
    assert_eq!((judged.violations.len(), judged.optimal), (2, None));
    assert_eq!(
        words,
        "The plan breaks a rule: A1 and A2 are both at (2, 1) at time 1. \
         There is one more violation."
    );
}

#[test]
fn of_a_poor_plan_it_is_told_what_is_too_much() {
    let (instance, plan) = read(
        r#"{ "giveway": 1, "map": ["...", "..."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [2, 0] },
            { "name": "A2", "start": [0, 1], "goal": [2, 1] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "A1": [[0, 0], [0, 0], [1, 0], [2, 0]],
            "A2": [[0, 1], [1, 1], [2, 1]] } }"#,
    );
    let (judged, words) = judged(&instance, &plan);
    assert_eq!(judged.optimal, Some(false));
    let more = |cost| Excess {
        agent: "A1".to_owned(),
        cost,
        by: 1,
    };
    assert_eq!(judged.excess, [more(Cost::SumOfCosts), more(Cost::Waits)]);
    assert_eq!(
        words,
        "The plan keeps all rules, but there is a better one: a makespan of 2 instead of 3 \
         and a sum of costs of 4 instead of 5. In it A1 arrives 1 step sooner and A1 waits \
         1 step less."
    );
}
