//! The judges on small scenes: each condition, quantity and aim, each way to be outside.

mod outside;

use giveway_course::judge::words::said;
use giveway_course::judge::{Did, Judging, Kind, Situation, Verdict, Why, begin, conclude};
use giveway_course::lesson::{Lesson, Step, Value, read_lesson};
use giveway_model::{Cell, Scene};
use giveway_solve::{SilentHost, serve};
use serde_json::{Value as Json, json};

use super::shipped;

/// A lesson of one step with a task.
pub(crate) fn lesson(scene: &Json, step: &Json, task: &Json) -> Lesson {
    let mut whole = json!({
        "title": "Step", "text": ["Text."], "scene": scene, "hints": ["Hint."], "reason": "Reason.",
    });
    for (key, value) in step.as_object().unwrap() {
        whole[key] = value.clone();
    }
    whole["task"] = task.clone();
    whole["task"]["say"] = json!("Do it.");
    let lesson = json!({
        "giveway": 1, "title": "T", "minutes": 4, "about": "About.", "steps": [whole],
    });
    read_lesson(&lesson.to_string(), &shipped::glossary()).unwrap()
}

pub(crate) fn scene(map: &[&str], agents: &[(&str, [u32; 2], [u32; 2])]) -> Json {
    let agents: Vec<Json> = agents
        .iter()
        .map(|(name, start, goal)| json!({ "name": name, "start": start, "goal": goal }))
        .collect();
    json!({ "giveway": 1, "map": map, "agents": agents })
}

fn crossing() -> Json {
    scene(
        &["#.#", "...", "#.#"],
        &[("A1", [0, 1], [2, 1]), ("A2", [1, 2], [1, 0])],
    )
}

pub(crate) fn judged(lesson: &Lesson, scene: &Scene, did: &Did) -> Verdict {
    let step: &Step = &lesson.steps[0];
    let situation = Situation {
        step,
        start: step.scene.as_ref().unwrap(),
        scene,
    };
    match begin(situation, did).unwrap() {
        Judging::Verdict(verdict) => *verdict,
        Judging::Ask(requests) => {
            let responses: Vec<_> = requests.iter().map(|r| serve(r, &SilentHost)).collect();
            conclude(situation, did, &responses).unwrap()
        }
    }
}

/// What is said of what was done on a board.
fn told(lesson: &Lesson, verdict: &Verdict) -> String {
    let said = said(verdict, &lesson.steps[0]);
    format!("{}: {}", said.head, said.text.plain())
}

pub(crate) fn painted(lesson: &Lesson, change: impl FnOnce(&mut Scene)) -> (Verdict, String) {
    let mut scene = lesson.steps[0].scene.clone().unwrap();
    change(&mut scene);
    let verdict = judged(lesson, &scene, &Did::Edits);
    let told = told(lesson, &verdict);
    (verdict, told)
}

fn set(x: usize, y: usize, ground: &'static str) -> impl FnOnce(&mut Scene) {
    move |scene| scene.map[y].replace_range(x..=x, ground)
}

/// The truth of a quantity, by a guess that it never is.
fn truth(scene: &Json, what: &Json) -> Why {
    let lesson = lesson(
        scene,
        &json!({}),
        &json!({ "kind": "predict", "what": what }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let guess = Did::Guessed(Value::Robot("nobody".into()));
    judged(&lesson, &start, &guess).why
}

#[track_caller]
fn is_truth(scene: &Json, what: &Json, wanted: &Value) {
    match truth(scene, what) {
        Why::Guessed { truth, .. } => assert_eq!(truth, *wanted),
        other => panic!("{other:?}"),
    }
}

#[test]
fn quantities_are_those_of_every_best_plan() {
    let lane = scene(&["....", "#.##"], &[("A1", [0, 0], [3, 0])]);
    is_truth(
        &lane,
        &json!({ "is": "arrival", "robot": "A1" }),
        &Value::Number(3),
    );
    let place = |time: u32| json!({ "is": "place", "robot": "A1", "time": time });
    is_truth(&lane, &place(1), &Value::Cell(Cell::new(1, 0)));
    is_truth(&lane, &place(9), &Value::Cell(Cell::new(3, 0)));
    is_truth(&lane, &json!({ "is": "plans" }), &Value::Number(1));
    is_truth(&crossing(), &json!({ "is": "plans" }), &Value::Number(2));
    // A1 can only wait: A2 comes through its cell's only neighbour.
    let bay = scene(
        &["#.##", "...."],
        &[("A1", [0, 1], [3, 1]), ("A2", [3, 1], [1, 0])],
    );
    is_truth(
        &bay,
        &json!({ "is": "cost", "cost": "makespan" }),
        &Value::Number(5),
    );
}

#[test]
fn what_best_plans_differ_in_is_no_truth() {
    let waits = json!({ "is": "waits" });
    assert_eq!(truth(&crossing(), &waits), Why::Differs);
    let arrival = json!({ "is": "arrival", "robot": "A1" });
    assert_eq!(truth(&crossing(), &arrival), Why::Differs);
    let middle = json!({ "is": "place", "robot": "A1", "time": 1 });
    assert_eq!(truth(&crossing(), &middle), Why::Differs);
}

#[test]
fn the_one_that_waits_is_named() {
    // A2 has the shorter way and comes first; A1 is late in any case.
    let scene = json!({ "giveway": 1, "map": ["#.##", "....", "#.##"], "objective": ["sum-of-costs"],
        "agents": [{ "name": "A1", "start": [1, 2], "goal": [1, 0] },
                   { "name": "A2", "start": [0, 1], "goal": [3, 1], "battery": { "capacity": 3, "initial": 3 } }] });
    is_truth(
        &scene,
        &json!({ "is": "waits" }),
        &Value::Robot("A1".into()),
    );
}

#[test]
fn a_condition_that_is_raised_counts_from_the_start() {
    let lane = scene(&["...", "..."], &[("A1", [0, 0], [2, 0])]);
    let raised = |by: u32| {
        let until = json!({ "is": "raised", "cost": "makespan", "by": by });
        let task = json!({ "kind": "paint", "until": until });
        lesson(&lane, &json!({ "tools": ["obstacle"] }), &task)
    };
    assert!(painted(&raised(2), set(1, 0, "#")).0.is_solved());
    let (verdict, told) = painted(&raised(1), set(1, 0, "#"));
    assert_eq!(verdict.kind, Kind::NotYet);
    assert_eq!(
        told,
        "Not yet: the best makespan went from 2 to 4; 3 is asked for."
    );
    let (_, told) = painted(&raised(1), set(1, 1, "#"));
    assert_eq!(told, "Not yet: the best makespan is still 2.");
}

#[test]
fn a_verdict_of_a_question_can_be_painted() {
    let lane = scene(
        &["#.###", "....."],
        &[("A1", [0, 1], [4, 1]), ("A2", [4, 1], [1, 0])],
    );
    let until = json!({ "is": "verdict", "question": { "kind": "visit", "agent": "A1", "at": [2, 1] },
                        "verdict": "needless" });
    let task = json!({ "kind": "paint", "until": until });
    let lesson = lesson(&lane, &json!({ "tools": ["obstacle"] }), &task);
    let (verdict, told) = painted(&lesson, set(4, 0, "."));
    assert!(!verdict.is_solved());
    assert!(
        told.starts_with("Not yet: it is necessary, not needless."),
        "{told}"
    );
    let wide = painted(&lesson, |scene| scene.map[0] = "#....".into());
    // A1 can go above or below: the question does not fit, or its answer is needless.
    assert_ne!(wide.1, told);
}

#[test]
fn an_order_may_have_to_be_the_best() {
    let lesson = lesson(
        &crossing(),
        &json!({}),
        &json!({ "kind": "order", "find": "best" }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let order = |names: &[&str]| Did::Ordered(names.iter().map(|n| (*n).to_owned()).collect());
    assert!(judged(&lesson, &start, &order(&["A1", "A2"])).is_solved());
    for names in [&["A1"][..], &["A1", "A1"], &["A1", "A3"]] {
        assert_eq!(judged(&lesson, &start, &order(names)).why, Why::Untouched);
    }
    assert_eq!(judged(&lesson, &start, &Did::NoOrder).why, Why::Untouched);
}

#[test]
fn no_order_is_not_said_of_a_scene_in_which_one_works() {
    let lesson = lesson(
        &crossing(),
        &json!({}),
        &json!({ "kind": "order", "find": "none" }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let verdict = judged(&lesson, &start, &Did::NoOrder);
    assert!(!verdict.is_solved());
    assert_eq!(
        told(&lesson, &verdict),
        "Not yet: the order A1 and A2 works."
    );
}

/// To stand at its flag at a time in every best plan is not to arrive then.
#[test]
fn an_arrival_is_sure_where_the_step_before_is() {
    use giveway_solve::freedom::Known;
    let lane = scene(&["....", "#.##"], &[("A1", [0, 0], [3, 0])]);
    let what = json!({ "is": "arrival", "robot": "A1" });
    let lesson = lesson(
        &lane,
        &json!({}),
        &json!({ "kind": "predict", "what": what }),
    );
    let start = lesson.steps[0].scene.as_ref().unwrap();
    let situation = Situation {
        step: &lesson.steps[0],
        start,
        scene: start,
    };
    let guess = Did::Guessed(Value::Number(3));
    let Some(Judging::Ask(requests)) = begin(situation, &guess) else {
        panic!("nothing is asked");
    };
    let mut response = serve(&requests[0], &SilentHost);
    let judged = |response: &giveway_solve::Response| {
        conclude(situation, &guess, std::slice::from_ref(response)).unwrap()
    };
    assert!(judged(&response).is_solved());
    let giveway_solve::Response::Freedom(answer) = &mut response else {
        panic!("{response:?}");
    };
    let visits = answer.backbone.as_mut().unwrap().get_mut("A1").unwrap();
    let before = visits.len() - 2;
    visits[before].always = Known::No;
    assert_eq!(judged(&response).why, Why::Differs);
}
