//! The tree of CBS by hand through the door.

use giveway_model::Cost;

use super::{CROSSING, Planner, planned, request};
use crate::plan::{ByHand, HandSplit, NodeFate, PlanAnswer, PlanEnd, PlanRequest, Went, words};
use crate::{Request, Response, SilentHost, serve};

/// The second split by hand gives a plan, while a branch is open that costs less.
const LANES: &str = r##"{
    "giveway": 1,
    "map": ["......", "#..##.", ".#..#.", "......"],
    "objective": ["sum-of-costs"],
    "agents": [
        { "name": "A1", "start": [0, 3], "goal": [2, 0] },
        { "name": "A2", "start": [3, 2], "goal": [2, 2] },
        { "name": "A3", "start": [4, 0], "goal": [0, 3] }
    ]
}"##;

fn by_hand(scene: &str, splits: &[(u64, u32, &str)], node: u64) -> PlanRequest {
    let split = |&(node, conflict, agent): &(u64, u32, &str)| HandSplit {
        node,
        conflict,
        agent: agent.to_owned(),
    };
    PlanRequest {
        by_hand: Some(ByHand {
            splits: splits.iter().map(split).collect(),
            node,
        }),
        ..request(scene, Planner::Cbs)
    }
}

/// The split of these two at a node, as it is told.
fn split_of(answer: &PlanAnswer, pair: [&str; 2], agent: &'static str) -> (u64, u32, &'static str) {
    let Some(Went::CbsByHand { choices, .. }) = answer.trace.as_ref().map(|trace| &trace.went)
    else {
        panic!("{answer:?}");
    };
    let choices = choices.as_ref().unwrap();
    let mut told = choices.conflicts.iter();
    let at = told.position(|one| {
        let parties = words::parties(&one.conflict);
        parties.iter().all(|party| pair.contains(&party.as_str()))
    });
    (choices.node, at.unwrap() as u32, agent)
}

#[test]
fn a_plan_is_best_only_when_no_open_branch_costs_less() {
    let root = planned(by_hand(LANES, &[], 0));
    assert_eq!(root.bounds, [(Cost::SumOfCosts, 13)].into());
    assert!(root.plan.is_none());
    let first = split_of(&root, ["A2", "A3"], "A2");
    let later = planned(by_hand(LANES, &[first], 2));
    let second = split_of(&later, ["A1", "A2"], "A2");
    let early = planned(by_hand(LANES, &[first, second], 1));
    assert_eq!(early.costs.map(|costs| costs.sum_of_costs), Some(18));
    assert_eq!(early.bounds, [(Cost::SumOfCosts, 17)].into());
    assert!(matches!(early.ended, PlanEnd::Stopped { .. }), "{early:?}");
    let third = split_of(&early, ["A1", "A3"], "A1");
    let done = planned(by_hand(LANES, &[first, second, third], 0));
    assert!(matches!(done.ended, PlanEnd::Best { reach } if reach.within().is_none()));
    let Some(Went::CbsByHand {
        nodes,
        splits,
        choices,
    }) = done.trace.map(|trace| trace.went)
    else {
        panic!();
    };
    assert_eq!((nodes.len(), splits.len(), choices), (7, 3, None));
    assert!(matches!(
        nodes[3].fate,
        NodeFate::Best {
            turn: 3,
            bypassed: 0
        }
    ));
    // The planner would have begun elsewhere.
    assert!(!splits[0].is_rule);
    let gives = |branches: &[crate::plan::ToldBranch; 2]| branches.each_ref().map(|one| one.cost);
    assert_eq!(gives(&splits[0].rule.branches), [Some(16), Some(21)]);
    assert_eq!(splits[0].branches, [1, 2]);
}

#[test]
fn what_each_split_would_give_is_told_before() {
    let root = planned(by_hand(CROSSING, &[], 0));
    let Some(Went::CbsByHand {
        choices: Some(choices),
        ..
    }) = root.trace.map(|trace| trace.went)
    else {
        panic!();
    };
    assert_eq!(
        (choices.node, choices.conflicts.len(), choices.left_out),
        (0, 1, 0)
    );
    let [of_first, of_second] = &choices.conflicts[0].branches;
    let told = |branch: &crate::plan::ToldBranch| {
        (
            words::branch(&branch.constraint),
            branch.cost,
            branch.conflicts,
        )
    };
    assert_eq!(told(&of_first[0]), ("A keeps away".to_owned(), Some(5), 0));
    assert_eq!(
        told(&of_second[1]),
        ("B is there, others keep away".to_owned(), Some(5), 0)
    );
}

#[test]
fn a_split_of_another_tree_is_refused_by_its_place() {
    let refused = |splits: &[(u64, u32, &str)]| match serve(
        &Request::Plan(by_hand(CROSSING, splits, 0)),
        &SilentHost,
    ) {
        Response::Refused(refusal) => refusal.sentences().join(" "),
        other => panic!("{other:?}"),
    };
    assert!(refused(&[(3, 0, "A")]).contains("by_hand.splits[0].node"));
    assert!(refused(&[(0, 1, "A")]).contains("by_hand.splits[0].conflict"));
    assert!(refused(&[(0, 0, "C")]).contains("\"A\" or \"B\""));
    assert!(refused(&[(0, 0, "A"), (0, 0, "A")]).contains("by_hand.splits[1].node"));
    let other = PlanRequest {
        planner: Planner::Pibt,
        ..by_hand(CROSSING, &[], 0)
    };
    assert!(matches!(
        serve(&Request::Plan(other), &SilentHost),
        Response::Refused(_)
    ));
}

#[test]
fn what_cbs_cannot_do_it_cannot_do_by_hand() {
    let scene = CROSSING.replace("sum-of-costs", "moves");
    let answer = planned(by_hand(&scene, &[], 0));
    assert!(matches!(answer.ended, PlanEnd::Refused { .. }));
    assert_eq!(answer.trace, None);
}

#[test]
fn it_is_the_same_each_time_and_can_be_written() {
    let asked = by_hand(LANES, &[(0, 0, "A1")], 1);
    assert_eq!(planned(asked.clone()).trace, planned(asked.clone()).trace);
    let text = serde_json::to_string(&asked).unwrap();
    assert!(
        text.contains(r#""by_hand":{"splits":[{"node":0,"conflict":0,"agent":"A1"}],"node":1}"#)
    );
    assert_eq!(serde_json::from_str::<PlanRequest>(&text).unwrap(), asked);
}
