//! What cannot be answered of a plan around which the world has changed: the past, later
//! changes, and the way on where there is none.

use giveway_model::{Question, format::native};
use giveway_proof::Claim;

use super::{around, course, explained};
use crate::{CertifyRequest, Refusal, explain::Verdict};

#[test]
fn what_is_past_is_refused() {
    let course = around();
    assert_eq!(
        course.refused("visit a --at 1,1 --time 1"),
        "Time 1 is already past: the question is about the plan from time 3 on, and the past \
         cannot change."
    );
    assert_eq!(
        course.refused("visit a --at 1,1"),
        "From time 3 on: a never passes (1, 1). You can ask: no-visit a --at 1,1"
    );
    assert_eq!(
        course.refused("arrival b"),
        "b was already at its goal at time 3, and the past cannot change."
    );
    assert!(
        course
            .refused("wait a --at 5,0")
            .contains("at (3, 1) from time 3 to 4")
    );
}

#[test]
fn changes_after_the_time_shown_do_not_count() {
    let mut course = around();
    let later = r#"{ "giveway": 1, "changes": [
        { "at": 3, "change": "add-obstacle", "cell": [4, 1] },
        { "at": 5, "change": "remove-agent", "agent": "b" }] }"#;
    course.changes = native::read_changes(later).unwrap();
    let mut request = course.request("arrival a");
    request.at = Some(4);
    assert_eq!(explained(request.clone()).unwrap().since, Some(3));
    // Before any change it is a question about the plan in one world.
    request.at = Some(2);
    request.question = Question::Arrival {
        agent: "b".to_owned(),
    };
    let answer = explained(request.clone()).unwrap();
    assert_eq!((answer.since, answer.verdict), (None, Verdict::Necessary));
    // With the later change the plan is none: `b` is not said to be gone.
    request.at = None;
    assert!(matches!(
        explained(request.clone()),
        Err(Refusal::Plan { .. })
    ));
    request.plan = None;
    assert!(matches!(explained(request), Err(Refusal::Request { .. })));
}

#[test]
fn why_there_is_no_way_to_go_on() {
    let course = course(
        r#"{ "giveway": 1, "map": ["...."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [2, 0] }"#,
    );
    let answer = course.ask("unsolvable");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    assert!(answer.reach.is_complete());
    let words = answer.words;
    assert!(words.starts_with("This is about the plan from time 1 on. There is no plan."));
    assert!(words.contains("a must go from (1, 0) to (3, 0)"), "{words}");
    assert!(
        words.contains("pass through the obstacle at (2, 0) at time 2"),
        "{words}"
    );
    let repair = answer.repairs.first().unwrap();
    assert_eq!(
        repair.text,
        "Remove the obstacle at (2, 0): makespan 3, sum of costs 3."
    );
    assert_eq!(repair.plan.paths, course.plan.paths);
    assert_eq!(repair.plan.knows, Some(1));
    // Where there is a way, that is said.
    let mut open = around();
    open.plan.paths.insert(
        "a".to_owned(),
        (0..6).map(|x| Some((x, 1).into())).collect(),
    );
    let refused = open.refused("unsolvable");
    assert!(
        refused.starts_with("There is a plan, with a makespan of 7."),
        "{refused}"
    );
}

#[test]
fn a_goal_in_an_obstacle_is_said_plainly() {
    let course = course(
        r#"{ "giveway": 1, "map": ["...."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [3, 0] }"#,
    );
    assert_eq!(
        course.refused("unsolvable"),
        "There is no plan from time 1 on, because a has to go to (3, 0), where there is an obstacle."
    );
}

#[test]
fn no_certificate_is_made_of_what_is_about_two_worlds() {
    let course = around();
    let answer = course.ask("makespan");
    let request = CertifyRequest::of_explained(&course.instance, Some(&course.plan), &answer);
    assert!(request.bounds.is_empty() && !request.impossible);
    assert_eq!((request.plan, request.about), (None, Claim::default()));
}
