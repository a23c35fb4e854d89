//! How a plan of the same costs does without what was asked about.

use giveway_model::{Instance, Plan, question::from_words};

use super::{read, scenario_1};
use crate::{
    Limits, Request, Response, SilentHost,
    explain::{AgentDifference, ExplainAnswer, ExplainRequest, How, Verdict, how_of},
    serve,
};

fn explain(instance: &Instance, plan: &Plan, words: &str) -> ExplainAnswer {
    let words: Vec<&str> = words.split_whitespace().collect();
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
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

/// A1 has time to spare: A2 needs 5 steps, and only the makespan counts.
fn spare() -> (Instance, Plan) {
    let instance = r#"{ "giveway": 1, "map": ["......", "......", ".@@@@@", "......"],
        "objective": ["makespan"], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [3, 0] },
        { "name": "A2", "start": [0, 3], "goal": [5, 3] }] }"#;
    let instance = instance.replace('@', "#");
    let plan = r#"{ "giveway": 1, "paths": {
        "A1": [[0, 0], [0, 0], [1, 0], [2, 0], [3, 0]],
        "A2": [[0, 3], [1, 3], [2, 3], [3, 3], [4, 3], [5, 3]] } }"#;
    read(&instance, plan)
}

#[test]
fn another_robot_pays() {
    let (instance, plan, _) = scenario_1();
    let answer = explain(&instance, &plan, "wait A2 --at 3,1");
    assert_eq!(
        (answer.verdict, answer.how.as_slice()),
        (Verdict::Needless, [How::Others].as_slice())
    );
    let row = |agent: &str, arrival, other, more_waits| AgentDifference {
        agent: agent.to_owned(),
        arrival,
        other,
        more_waits,
        other_way: false,
    };
    assert_eq!(answer.pays, [row("A1", 3, 4, 1), row("A2", 4, 3, -1)]);
    assert_eq!(
        how_of(&answer).unwrap(),
        "A1 could wait instead; then A1 arrives 1 later."
    );
}

#[test]
fn it_can_wait_elsewhere_or_not_at_all() {
    let (instance, plan) = spare();
    let answer = explain(&instance, &plan, "wait A1 --at 0,0");
    assert_eq!(
        (answer.verdict, answer.how.as_slice()),
        (Verdict::Needless, [How::Elsewhere].as_slice())
    );
    assert_eq!(how_of(&answer).unwrap(), "A1 could wait elsewhere.");
    let answer = explain(&instance, &plan, "wait A1");
    assert_eq!(
        (answer.verdict, answer.how.as_slice()),
        (Verdict::Needless, [How::Free].as_slice())
    );
    assert_eq!(how_of(&answer).unwrap(), "A1 need not wait here at all.");
    assert_eq!((answer.pays[0].arrival, answer.pays[0].other), (4, 3));
}

#[test]
fn it_can_drive_another_way() {
    let (instance, plan) = spare();
    let answer = explain(&instance, &plan, "visit A1 --at 1,0");
    assert_eq!(
        (answer.verdict, answer.how.as_slice()),
        (Verdict::Needless, [How::OtherWay].as_slice())
    );
    assert!(answer.pays[0].other_way);
    assert_eq!(how_of(&answer).unwrap(), "A1 could drive around instead.");
    // Of what costs more it is not told, but who pays is.
    let answer = explain(&instance, &plan, "visit A2 --at 2,3");
    assert_eq!(answer.verdict, Verdict::Necessary);
    assert!(answer.how.is_empty() && answer.pays.is_empty());
}
