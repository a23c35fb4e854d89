//! A verdict before the best other plan is known: what is not proved of that plan is not claimed.

use std::rc::Rc;

use giveway_model::{Cost, Question, check::costs, question::from_words};

use super::{handed_on::Eager, read};
use crate::{
    Limits, ProvedBest, Request, Response, SolveRequest,
    budget::Budget,
    explain::{
        Verdict,
        fitting::FittingQuestion,
        verdict::{by_closest, compare_all_costs},
        whole::WholePlan,
    },
    serve,
};

/// A robot drives along a row of five cells. Around the middle one it needs 2 steps more; the plan
/// that is known needs 4.
#[test]
fn a_dear_plan_that_is_known_is_no_bound_of_the_best() {
    let scene = r#"{ "giveway": 1, "objective": ["makespan", "sum-of-costs"],
        "map": [".....", ".....", "....."],
        "agents": [{ "name": "A1", "start": [0, 1], "goal": [4, 1] }] }"#;
    let plan = r#"{ "giveway": 1, "paths": { "A1": [[0, 1], [1, 1], [2, 1], [3, 1], [4, 1]] } }"#;
    let dear = r#"{ "giveway": 1, "paths": { "A1": [[0, 1], [0, 1], [0, 1], [0, 0], [1, 0], [2, 0],
        [3, 0], [4, 0], [4, 1]] } }"#;
    let (instance, plan) = read(scene, plan);
    let (_, dear) = read(scene, dear);
    let host = Eager::default();
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    let Response::Solved(solved) = serve(&request, &host) else {
        panic!("it is solved");
    };
    let budget = Rc::new(Budget::new(&host, Limits::default()));
    let question: Question = from_words(&["visit", "A1", "--at", "2,1"]).unwrap();
    let whole = WholePlan::default();
    let own = costs(&instance, &plan).unwrap();
    let mut case = FittingQuestion::new(&instance, &question, &plan, own, None, whole);
    case.optimal = ProvedBest::by_search(&solved).reach.handed_on();
    let known = (dear.clone(), costs(&instance, &dear).unwrap());

    let compared = by_closest(&case, Some(&known), &budget).unwrap();
    assert_eq!(compared.verdict, Verdict::Costly);
    assert_eq!(compared.deltas.get(&Cost::Makespan), Some(&4));
    let open = compared.open.unwrap();
    assert!(open.least.is_none());
    let best = compare_all_costs(&case, compared.other, open.optima().as_ref(), &budget);
    assert_eq!(best.verdict, Verdict::Costly);
    assert_eq!(best.deltas.get(&Cost::Makespan), Some(&2));
}
