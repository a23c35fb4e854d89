//! Answers that were wrong once, asked again: claims beyond the horizon, limits
//! and edges. `data/wrong/README.md` names the cases.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_solve::explain::{Edit, ExplainAnswer, Repair, Verdict};
use giveway_solve::{Limits, Status};
use giveway_tests::ask;
use giveway_tests::picture;
use giveway_tests::wrong::{explain, instance, plan};

/// What a question about a case is answered within a horizon.
fn asked(case: &str, question: &str, within: u32) -> ExplainAnswer {
    let instance = instance(&format!("{case}.json"));
    let plan = match question.split_once(' ') {
        Some(("yield", _)) => Some(plan(&format!("{case}.plan.json"))),
        _ => None,
    };
    explain(&instance, plan, question, Some(within), Limits::default())
}

/// What is necessary within a horizon, and is not with a later one, is never
/// said to be so whatever the horizon.
#[test]
fn what_is_necessary_within_a_horizon_is_no_more_than_that() {
    for (case, question, within, later) in [
        ("necessary-whatever-horizon-charges", "charges A1", 11, 20),
        ("necessary-charges-small", "charges A1", 10, 12),
        ("necessary-whatever-horizon-moves", "moves A1", 8, 9),
        ("necessary-whatever-horizon-moves", "length A1", 8, 9),
        (
            "necessary-whatever-horizon-yield",
            "yield A1 A2 --at 2,1",
            5,
            7,
        ),
        ("yield-2x2", "yield A2 A1 --at 1,1", 3, 5),
    ] {
        let answer = asked(case, question, within);
        assert_eq!(answer.verdict, Verdict::Necessary, "{case} {question}");
        assert!(!answer.reach.is_complete(), "{case} {question}");
        assert_eq!(answer.reach.within(), Some(within), "{case} {question}");
        if let Some(core) = &answer.core {
            assert!(!core.reach.is_complete(), "{case} {question}");
            assert_eq!(core.reach.within(), Some(within), "{case} {question}");
        }
        // The same plan, asked about with more time.
        let scene = instance(&format!("{case}.json"));
        let same = answer
            .plan
            .or_else(|| Some(plan(&format!("{case}.plan.json"))));
        let answer = explain(&scene, same, question, Some(later), Limits::default());
        assert_ne!(answer.verdict, Verdict::Necessary, "{case} {question}");
        let costs = answer.costs.unwrap();
        assert!(costs.makespan > within, "{case} {question}: {costs:?}");
    }
}

/// That the plan asked about is the best of its horizon says nothing of later
/// plans.
#[test]
fn what_is_needless_within_a_horizon_is_no_more_than_that() {
    let case = "needless-whatever-horizon";
    let answer = asked(case, "charge A1 --time 5", 6);
    assert_eq!(answer.verdict, Verdict::Needless);
    assert_eq!(
        (answer.reach.is_complete(), answer.reach.within()),
        (false, Some(6))
    );
    let cheap = ask::best(&instance(&format!("{case}.json")), Some(7)).costs;
    assert_eq!(
        cheap.map(|costs| (costs.charges, costs.makespan)),
        Some((1, 7))
    );
}

#[test]
fn a_deadline_that_helps_is_the_least_one() {
    let answer = asked("deadline-not-least", "unsolvable", 0);
    let single = |repair: &&Repair| repair.edits.len() == 1;
    let singles: Vec<&Repair> = answer.repairs.iter().filter(single).collect();
    let [deadline] = singles[..] else {
        panic!("{:?}", answer.repairs)
    };
    assert_eq!(deadline.edits, [Edit::Deadline { within: 3 }]);
    assert!(deadline.least);
    let instance = instance("deadline-not-least.json");
    assert_eq!(ask::best(&instance, Some(2)).status, Status::Impossible);
    assert_eq!(ask::best(&instance, Some(3)).status, Status::Optimal);
}

/// The last times that a number can hold are times as all others.
#[test]
fn the_end_of_time_is_no_edge() {
    let instance = instance("visit-time-u32max.json");
    for question in [
        "visit A1 --at 2,0 --time",
        "no-move A1 --from-cell 0,0 --to-cell 1,0 --time",
    ] {
        let [last, before] = [u32::MAX, u32::MAX - 1].map(|time| {
            let question = format!("{question} {time}");
            let answer = explain(&instance, None, &question, None, Limits::default());
            (
                answer.verdict,
                answer.reach.is_complete(),
                answer.reach.within(),
            )
        });
        assert_eq!(last, before, "{question}");
    }
    let answer = explain(
        &instance,
        None,
        "visit A1 --at 2,0 --time 4294967295",
        None,
        Limits::default(),
    );
    assert_eq!(
        (answer.verdict, answer.reach.is_complete()),
        (Verdict::Necessary, false)
    );
}

/// A horizon far beyond any use takes neither time nor memory: no plan needs as
/// many steps as there are joint states.
#[test]
fn a_horizon_beyond_any_use_costs_nothing() {
    let limits = Limits {
        conflicts: Some(20_000),
        memory_bytes: Some(100_000_000),
        ..Limits::default()
    };
    let corridor = picture::instance("aB . bA");
    let vanishing = picture::instance("a . B\nb . A\nvanish\nminimise moves,waits");
    for within in [1_000_000, 4_000_000_000, u32::MAX] {
        let answer = ask::best_within_conflicts(&corridor, Some(within), 20_000);
        assert_eq!(
            (answer.status, answer.reach.is_complete()),
            (Status::Impossible, true)
        );
        let answer = ask::best_within_conflicts(&vanishing, Some(within), 20_000);
        assert_eq!(
            (answer.status, answer.reach.is_complete()),
            (Status::Optimal, true)
        );
        for question in [
            "moves",
            "arrival a",
            "length b",
            "move a --from-cell 0,0 --to-cell 1,0",
        ] {
            let answer = explain(&vanishing, None, question, Some(within), limits);
            assert_ne!(answer.verdict, Verdict::Unknown, "{question}");
        }
        // Where the joint states are too many to tell, limits are kept at least.
        let case = instance("necessary-charges-small.json");
        let answer = explain(&case, None, "charges A1", Some(within), limits);
        assert_ne!(answer.verdict, Verdict::Unknown);
    }
}

/// Facts about whichever agent may say nothing of one that could do what is asked
/// for: then what would help that one may be missed, and nobody says otherwise.
#[test]
fn repairs_about_whichever_agent_are_not_called_all_that_help() {
    let scene = r#"{ "giveway": 1, "map": ["...", ".#.", ".#.", "+#+", "+.."],
        "rules": { "at_goal": "vanish" },
        "objective": ["makespan", "charges", "sum-of-costs", "waits", "moves"],
        "agents": [
            { "name": "A1", "start": [2, 1], "goal": [0, 3],
              "battery": { "capacity": 6, "initial": 4 } },
            { "name": "A2", "start": [1, 4], "goal": [2, 2],
              "battery": { "capacity": 2, "initial": 2 } }] }"#;
    let plan = r#"{ "giveway": 1, "paths": {
        "A1": [[2, 1], [2, 1], [2, 2], [2, 3], [2, 2], [2, 1], [2, 2], [2, 3], [2, 4], [1, 4],
               [0, 4], [0, 3]],
        "A2": [[1, 4], [2, 4], [2, 3], [2, 4], [2, 3], [2, 2]] },
        "charges": { "A1": [3, 10], "A2": [2] } }"#;
    let scene = giveway_model::format::native::read_instance(scene).unwrap();
    let plan = giveway_model::format::native::read_plan(plan).unwrap();
    let question = "no-visit any --at 0,1";
    let answer = explain(&scene, Some(plan), question, None, Limits::default());
    assert_eq!(answer.verdict, Verdict::Costly);
    let mut edits = answer.repairs.iter().flat_map(|repair| &repair.edits);
    let frees = edits.any(|edit| matches!(edit, Edit::RemoveObstacle { .. }));
    assert!(frees || !answer.exhaustive, "{:?}", answer.core);
}

/// A sum whose last bounds were closed at once stays limited for the agents that the
/// SAT solver takes in later, whatever the order of the agents.
#[test]
fn a_further_cost_is_minimised_among_plans_of_the_least_sum() {
    let scene = instance("sum-not-pinned.json").to_scene();
    for (objective, first, expected) in [
        ("sum-of-costs,moves", 0, vec![527, 463]),
        ("makespan,sum-of-costs,moves", 0, vec![83, 537, 461]),
        ("makespan,sum-of-costs,moves", 3, vec![83, 537, 461]),
    ] {
        let mut scene = scene.clone();
        scene.agents.rotate_left(first);
        let instance = giveway_model::Instance::new(scene).unwrap();
        let objective: giveway_model::Objective = objective.parse().unwrap();
        let answer = ask::best(&instance.with_objective(objective.clone()), None);
        assert_eq!(answer.status, Status::Optimal, "{objective}");
        assert_eq!(answer.costs.unwrap().vector(&objective), expected);
        assert!(answer.reach.is_complete(), "{objective}");
    }
}

/// Four agents on nine cells have few joint states: they are exhausted.
#[test]
fn few_joint_states_are_exhausted() {
    let answer = ask::best_within_conflicts(&instance("few-joint-states.json"), None, 20_000);
    assert_eq!(answer.status, Status::Impossible);
    assert!(answer.reach.is_complete());
}
