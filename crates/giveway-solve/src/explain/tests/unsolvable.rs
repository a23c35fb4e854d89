//! No plan: the published answer, and minimal sets by leaving each fact out.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Cell, Instance, Question,
    check::{Rule, check},
};

use crate::{
    Limits, Request, Response, SilentHost, Status,
    budget::Budget,
    explain::{
        ExplainAnswer, ExplainRequest, Verdict,
        answer::{Class, Edit, FactKind},
        ask::{Ask, Found, any},
        edits::edited,
        group::{groups, without},
        unsolvable::{AnyPlan, core, of_class},
        whole::WholePlan,
    },
    problem::Relaxed,
    serve,
    tests::{instance, random},
};

fn budget() -> Rc<Budget<'static>> {
    Rc::new(Budget::new(&SilentHost, Limits::default()))
}

fn find(instance: &Instance, within: Option<u32>) -> Found {
    let ask = Ask {
        instance,
        relaxed: &Relaxed::default(),
        conditions: &[],
        objective: instance.objective(),
        caps: &BTreeMap::new(),
        within,
        at_least_within: 0,
    };
    any(&ask, &budget())
}

/// The whole answer, as the service gives it.
pub(super) fn why(instance: &Instance, within: Option<u32>) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: None,
        question: Question::Unsolvable,
        changes: None,
        at: None,
        objective: None,
        within,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

/// Scenario 6 of Bogatarkan (2021).
fn scenario_6() -> Instance {
    instance(
        "aB #  bA
         .  #  .
         .  .  .",
    )
}

#[test]
fn scenario_6_is_answered_as_published() {
    let why = why(&scenario_6(), None);
    let told = |class| {
        let of = of_class(&why.witness, class).into_iter();
        of.map(|v| (v.rule, v.agents.join(" "), v.cell, v.time))
            .collect::<Vec<_>>()
    };
    let cell = |x, y| Some(Cell::new(x, y));
    let meet = (Rule::Vertex, "a b".to_owned(), cell(1, 2), 3);
    assert_eq!(told(Class::Collision), [meet]);
    let hit = (Rule::Obstacle, "a".to_owned(), cell(1, 0), 1);
    assert_eq!(told(Class::Obstacle), [hit]);
    assert!(told(Class::Battery).is_empty() && told(Class::Waypoint).is_empty());
    assert_eq!(
        (why.verdict, why.reach.is_complete()),
        (Verdict::Necessary, true)
    );

    let core = why.core.unwrap();
    assert!(core.minimal && core.reach.is_complete());
    let facts: Vec<&str> = core.facts.iter().map(|fact| fact.text.as_str()).collect();
    assert_eq!(
        facts,
        [
            "a must go from (0, 0) to (2, 0)",
            "b must go from (2, 0) to (0, 0)",
            "(1, 0) is an obstacle",
            "(1, 1) is an obstacle",
            "a and b must not collide",
        ]
    );

    let texts: Vec<&str> = why.repairs.iter().map(|r| r.text.as_str()).collect();
    assert_eq!(
        texts,
        [
            "Remove the obstacle at (1, 0): makespan 6, sum of costs 8.",
            "Leave a out: makespan 6, sum of costs 6.",
            "Remove the obstacle at (1, 1): makespan 6, sum of costs 10.",
            "Leave b out: makespan 6, sum of costs 6.",
        ]
    );
    assert!(why.exhaustive);
    assert_eq!(
        why.words,
        "There is no plan. These facts together rule it out: a must go from (0, 0) to (2, 0); \
         b must go from (2, 0) to (0, 0); (1, 0) is an obstacle; (1, 1) is an obstacle; \
         a and b must not collide. If robots could pass through each other, only this would go \
         wrong: a would meet b at (1, 2) at time 3. If robots could pass through obstacles, only \
         this would go wrong: a would pass through the obstacle at (1, 0) at time 1. \
         It would help to remove the obstacle at (1, 0): makespan 6, sum of costs 8."
    );
}

#[test]
fn every_repair_has_a_plan_that_the_judge_passes() {
    let empty = instance(
        "a . . . A
         battery a 2/3",
    );
    let why = why(&empty, None);
    let repairs = &why.repairs;
    for repair in repairs {
        let variant = edited(&empty, &repair.edits, None, WholePlan::default());
        let report = check(&variant.instance, &repair.plan);
        assert_eq!(
            (report.violations, report.costs),
            (vec![], Some(repair.costs))
        );
    }
    let larger = Edit::Battery {
        agent: "a".to_owned(),
        capacity: 4,
        initial: 4,
    };
    assert!(
        repairs
            .iter()
            .any(|repair| repair.edits == [larger.clone()])
    );
    let charger = |x| Edit::AddCharger {
        cell: Cell::new(x, 0),
    };
    assert!(repairs.iter().any(|repair| repair.edits == [charger(1)]));
    assert!(!repairs.iter().any(|repair| repair.edits == [charger(3)]));
    assert_eq!(of_class(&why.witness, Class::Battery).len(), 1);
}

#[test]
fn a_deadline_is_a_fact_where_it_was_set() {
    let straight = instance("a . . A");
    let why = why(&straight, Some(2));
    let kinds: Vec<FactKind> = why.core.unwrap().facts.iter().map(|f| f.kind).collect();
    assert_eq!(kinds, [FactKind::Task, FactKind::Deadline]);
    let later = Edit::Deadline { within: 3 };
    assert_eq!(why.repairs[0].edits, [later]);
}

#[test]
fn of_a_minimal_set_no_fact_can_be_left_out() {
    let mut kinds: BTreeMap<FactKind, u32> = BTreeMap::new();
    let mut cores = 0;
    for seed in 0..300 {
        let instance = random(seed, 2 + (seed % 2) as usize);
        let found = find(&instance, None);
        if found.status != Status::Impossible {
            continue;
        }
        let mut any_plan = AnyPlan {
            objective: instance.objective(),
            horizon: found.horizon,
            budget: budget(),
            whole: WholePlan::default(),
        };
        let core = core(&instance, None, &found, &mut any_plan).unwrap();
        assert!(core.minimal, "{seed}");
        assert_eq!(core.reach.within(), None, "{seed}");
        let mut left_out: std::collections::BTreeSet<_> =
            groups(&instance, &[], false).into_iter().collect();
        for part in &core.groups {
            left_out.remove(part);
        }
        let status = |left_out: &std::collections::BTreeSet<_>| {
            let variant = without(&instance, left_out, None);
            let ask = Ask {
                instance: &variant.instance,
                relaxed: &variant.relaxed,
                conditions: &[],
                objective: instance.objective(),
                caps: &BTreeMap::new(),
                within: None,
                at_least_within: 0,
            };
            any(&ask, &budget()).status
        };
        assert_eq!(
            status(&left_out),
            Status::Impossible,
            "{seed}: {:?}",
            core.groups
        );
        for &part in &core.groups {
            let mut less = left_out.clone();
            less.insert(part);
            assert_eq!(status(&less), Status::Feasible, "{seed}: without {part:?}");
            *kinds.entry(part.kind()).or_default() += 1;
        }
        cores += 1;
    }
    assert!(cores > 60, "{cores}");
    assert!(kinds.len() >= 6, "{kinds:?}");
}
