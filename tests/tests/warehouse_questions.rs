//! The published warehouse, asked about from every side.
//!
//! The deltas are the project's own findings; that the other plans are what is
//! asked for is judged by the checker and by the judge of questions, neither of
//! which knows the solver.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::format::native;
use giveway_model::question::{from_words, holds};
use giveway_model::{Cost, Instance, Plan, check::check, check::costs};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, Verdict};
use giveway_solve::{Limits, Request, Response, SilentHost, serve};

fn instance() -> Instance {
    native::read_instance(include_str!("../data/seed/warehouse.json")).unwrap()
}

fn plan() -> Plan {
    native::read_plan(include_str!("../data/seed/warehouse.plan.json")).unwrap()
}

fn answer(words: &str) -> ExplainAnswer {
    let words: Vec<&str> = words.split(' ').collect();
    let request = Request::Explain(ExplainRequest {
        scene: instance().to_scene(),
        plan: Some(plan()),
        question: from_words(&words).unwrap(),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{words:?}: {other:?}"),
    }
}

/// The other plan keeps every rule, is what is asked for, and costs what is said.
#[track_caller]
fn verified(words: &str, deltas: [i64; 3]) -> ExplainAnswer {
    let answer = answer(words);
    let instance = instance();
    let other = answer.alternative.as_ref().unwrap();
    assert!(check(&instance, other).is_valid(), "{words}");
    let judged = holds(&answer.question, &instance, &plan(), other);
    assert_eq!(judged, Some(true), "{words}");
    let [before, after] = [&plan(), other].map(|plan| costs(&instance, plan).unwrap());
    assert_eq!(answer.costs, Some(after), "{words}");
    let objective = [Cost::Makespan, Cost::SumOfCosts, Cost::Charges];
    for (cost, delta) in objective.into_iter().zip(deltas) {
        let counted = i64::from(after.get(cost)) - i64::from(before.get(cost));
        assert_eq!((counted, answer.deltas[&cost]), (delta, delta), "{words}");
    }
    assert!(answer.closest && answer.reach.is_complete(), "{words}");
    assert!(!answer.words.is_empty(), "{words}");
    answer
}

/// In the papers cells are numbered row by row from 1: 27 is (6, 2), 24 (3, 2).
#[test]
fn where_it_charges() {
    for words in [
        "charge A1 --at 6,2",
        "charge A1 --time 9",
        "no-charge A1 --at 3,2",
    ] {
        let answer = verified(words, [0, 0, 0]);
        assert_eq!(answer.verdict, Verdict::Needless, "{words}");
        // It goes the same way and charges elsewhere.
        assert_eq!(answer.alternative.unwrap().paths, plan().paths, "{words}");
    }
}

#[test]
fn over_the_corridor_and_in_this_order() {
    for (words, deltas) in [
        ("slow A1", [5, 6, 1]),
        ("visit A1 --at 6,0", [2, 3, 0]),
        ("move A1 --from-cell 3,1 --to-cell 3,2", [2, 3, 0]),
        ("no-move A1 --from-cell 5,2 --to-cell 4,2", [1, 2, 1]),
        ("order A1 --first 2,0 --second 4,2", [8, 9, 1]),
        ("order A1 --first 2,0 --second 7,0", [15, 16, 2]),
        ("order A2 --first 5,0 --second 1,2", [10, 11, 1]),
        ("visit A2 --at 6,0 --time 5", [1, 1, 0]),
        ("no-visit A1 --at 1,2", [2, 3, 0]),
        ("yield A1 A2 --at 6,0", [7, 7, 1]),
        ("yield A2 A1 --at 3,2", [6, 7, 1]),
    ] {
        let answer = verified(words, deltas);
        assert_eq!(answer.verdict, Verdict::Costly, "{words}");
        assert!(answer.core.is_some(), "{words}");
    }
}

#[test]
fn why_not_sooner_nor_with_less() {
    for words in [
        "makespan",
        "sum-of-costs",
        "arrival A1",
        "arrival A2",
        "length A1",
        "charges A1",
        "charge A2",
        "slow A2",
    ] {
        let answer = answer(words);
        assert_eq!(answer.verdict, Verdict::Necessary, "{words}");
        assert!(
            answer.reach.is_complete() && answer.reach.within().is_none(),
            "{words}"
        );
        assert!(answer.alternative.is_none() && answer.costs.is_none());
        let core = answer.core.unwrap();
        assert!(core.minimal && !core.facts.is_empty(), "{words}");
        assert!(!answer.repairs.is_empty(), "{words}");
    }
}
