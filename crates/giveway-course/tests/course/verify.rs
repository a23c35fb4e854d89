//! The check of a lesson before it is shared: each kind of task, right and wrong, with the
//! real solver; and what its reducer keeps, drops and shares.

use std::rc::Rc;

use giveway_course::author::verify::{
    Action, Effect, Finding, Problem, Standing, Subject, Verification, reduce, sentence, to_do,
};
use giveway_course::learner::AskNumber;
use giveway_course::lesson::{Lesson, Step, Task, Value, read_lesson};
use giveway_model::Cost;
use giveway_solve::{Request, Response, SilentHost, SolveAnswer, serve};
use serde_json::{Value as Json, json};

use super::shipped;

/// A lesson of one step with a task.
fn lesson(scene: &Json, step: &Json, task: &Json) -> Rc<Lesson> {
    let mut whole = json!({
        "title": "Step", "text": ["Text."], "scene": scene, "hints": ["Hint."], "reason": "Reason.",
    });
    for (key, value) in step.as_object().unwrap() {
        whole[key] = value.clone();
    }
    whole["task"] = task.clone();
    whole["task"]["say"] = json!("Do it.");
    let lesson =
        json!({ "giveway": 1, "title": "T", "minutes": 4, "about": "About.", "steps": [whole] });
    Rc::new(read_lesson(&lesson.to_string(), &shipped::glossary()).unwrap())
}

/// Two robots that meet in a corridor with a way around.
fn ring() -> Json {
    json!({ "giveway": 1, "map": ["...", ".#.", "..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }, { "name": "A2", "start": [2, 2], "goal": [0, 2] }] })
}

/// Two robots whose ways cross: one has to wait.
fn crossing() -> Json {
    json!({ "giveway": 1, "map": ["#.#", "...", "#.#"], "agents": [
        { "name": "A1", "start": [0, 1], "goal": [2, 1] }, { "name": "A2", "start": [1, 2], "goal": [1, 0] }] })
}

/// Two robots that would have to swap in a dead end.
fn stuck() -> Json {
    json!({ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }, { "name": "A2", "start": [2, 0], "goal": [0, 0] }] })
}

fn share(lesson: &Rc<Lesson>, anyway: bool) -> Action {
    let lesson = Rc::clone(lesson);
    Action::Share { lesson, anyway }
}

/// Does something, and has the solver answer all that is asked; the lessons shared then.
fn run(check: &mut Verification, action: Action) -> (Vec<Rc<Lesson>>, usize) {
    run_with(check, action, |request| serve(request, &SilentHost))
}

fn run_with(
    check: &mut Verification,
    action: Action,
    answer: impl Fn(&Request) -> Response,
) -> (Vec<Rc<Lesson>>, usize) {
    let (mut shared, mut asked) = (Vec::new(), 0);
    let mut actions = vec![action];
    while let Some(action) = actions.pop() {
        let (next, effects) = reduce(std::mem::take(check), action);
        *check = next;
        for effect in effects {
            match effect {
                Effect::Ask { number, request } => {
                    asked += 1;
                    let response = Box::new(answer(&request));
                    actions.push(Action::Answered { number, response });
                }
                Effect::Forget => {}
                Effect::Share(lesson) => shared.push(lesson),
            }
        }
    }
    (shared, asked)
}

/// What is found for the only task of a lesson; it is shared just where that has passed.
#[track_caller]
fn found(lesson: &Rc<Lesson>) -> Finding {
    let mut check = Verification::default();
    let (shared, _) = run(&mut check, share(lesson, false));
    let subject = Subject::all(lesson).remove(0);
    let finding = check.of(&subject).unwrap().clone();
    assert_eq!(check.progress(), None);
    assert_eq!(shared.is_empty(), finding != Finding::Passed, "{finding:?}");
    assert_eq!(sentence(&finding).is_none(), finding == Finding::Passed);
    finding
}

#[track_caller]
fn passes(scene: &Json, step: &Json, task: &Json) {
    assert_eq!(found(&lesson(scene, step, task)), Finding::Passed);
}

#[track_caller]
fn fails(scene: &Json, step: &Json, task: &Json, problem: Problem) {
    assert_eq!(found(&lesson(scene, step, task)), Finding::Failed(problem));
}

fn offers(values: &[u32]) -> Json {
    let answer = |value: &u32| json!({ "value": value, "text": "So many.", "reply": "Look." });
    let answers: Vec<Json> = values.iter().map(answer).collect();
    json!({ "kind": "predict", "what": { "is": "cost", "cost": "makespan" }, "answers": answers })
}

#[test]
fn one_of_the_offered_values_must_be_the_proved_one() {
    passes(&crossing(), &json!({}), &offers(&[2, 3]));
    let none = Problem::NotOffered(Value::Number(3));
    fails(&crossing(), &json!({}), &offers(&[2, 4]), none);
    passes(&crossing(), &json!({}), &offers(&[]));
    fails(&stuck(), &json!({}), &offers(&[2, 3]), Problem::NoPlan);
    let arrival = json!({ "kind": "predict", "what": { "is": "arrival", "robot": "A1" } });
    fails(&crossing(), &json!({}), &arrival, Problem::Differs);
}

#[test]
fn what_answers_claim_must_be_so_and_one_is_right() {
    let task = |right: [bool; 2], claims: [&str; 2]| {
        let answer = |index: usize| {
            json!({ "text": "It is so.", "reply": "Look.", "right": right[index],
                "claim": { "is": claims[index] } })
        };
        json!({ "kind": "choose", "answers": [answer(0), answer(1)] })
    };
    let claims = ["solvable", "impossible"];
    passes(&crossing(), &json!({}), &task([true, false], claims));
    let wrong = task([false, true], claims);
    fails(&crossing(), &json!({}), &wrong, Problem::True(0));
    fails(
        &stuck(),
        &json!({}),
        &task([true, false], claims),
        Problem::False(0),
    );
    let both = task([true, true], claims);
    fails(&crossing(), &json!({}), &both, Problem::Right(2));
}

#[test]
fn a_plan_to_look_at_has_conflicts() {
    let task = json!({ "kind": "spot" });
    let paths = json!({ "A1": [[0, 1], [1, 1], [2, 1]], "A2": [[1, 2], [1, 1], [1, 0]] });
    let plan = json!({ "plan": { "giveway": 1, "paths": paths } });
    passes(&crossing(), &plan, &task);
    let swap = json!({ "A1": [[0, 0], [1, 0], [2, 0]], "A2": [[2, 0], [1, 0], [0, 0]] });
    passes(
        &stuck(),
        &json!({ "plan": { "giveway": 1, "paths": swap } }),
        &task,
    );
    // It breaks a rule, but no two robots are in conflict.
    let jump = json!({ "A1": [[0, 1], [2, 1]], "A2": [[1, 2], [1, 1], [1, 0]] });
    let plan = json!({ "plan": { "giveway": 1, "paths": jump } });
    fails(&crossing(), &plan, &task, Problem::NoConflicts);
}

#[test]
fn a_plan_by_hand_must_be_possible() {
    let task = |aim: Json| json!({ "kind": "lead", "robots": ["A1", "A2"], "aim": aim });
    let most = |most: u32| task(json!({ "is": "cost", "cost": "makespan", "at-most": most }));
    let none = json!({});
    passes(&crossing(), &none, &task(json!({ "is": "legal" })));
    passes(&crossing(), &none, &task(json!({ "is": "best" })));
    passes(&crossing(), &none, &most(3));
    let (cost, best) = (Cost::Makespan, 3);
    fails(&crossing(), &none, &most(2), Problem::Dear { cost, best });
    fails(
        &stuck(),
        &none,
        &task(json!({ "is": "legal" })),
        Problem::NoPlan,
    );
    let home = json!({ "giveway": 1, "map": [".."], "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 0] }] });
    let alone = json!({ "kind": "lead", "robots": ["A1"], "aim": { "is": "legal" } });
    fails(&home, &none, &alone, Problem::StartSolved);
}

#[test]
fn a_robot_that_is_not_led_goes_as_the_learner_has_it() {
    let alone = json!({ "kind": "lead", "robots": ["A1"], "aim": { "is": "legal" } });
    // Without a plan A2 stands still, and never arrives.
    fails(&crossing(), &json!({}), &alone, Problem::Unsolved);
}

#[test]
fn a_scene_to_edit_is_not_solved_at_first_and_one_edit_solves_it() {
    let step = json!({ "tools": ["obstacle"], "edits": 1 });
    let task = |is: &str| json!({ "kind": "paint", "until": { "is": is } });
    passes(&ring(), &step, &task("impossible"));
    fails(&ring(), &step, &task("solvable"), Problem::StartSolved);
    let elsewhere = json!({ "tools": ["obstacle"], "edits": 1, "cells": [[1, 1]] });
    fails(&ring(), &elsewhere, &task("impossible"), Problem::Unsolved);
    // A robot whose goal is another one's leaves no valid scene; two robots fill no ring.
    let robots = json!({ "tools": ["robot"], "edits": 1, "cells": [[1, 0], [1, 2]] });
    fails(&ring(), &robots, &task("impossible"), Problem::Unsolved);
    let dear = json!({ "is": "raised", "cost": "makespan", "by": 1 });
    let dear = json!({ "kind": "paint", "until": dear });
    let goal = json!({ "tools": ["goal"], "edits": 1 });
    let behind = json!({ "giveway": 1, "map": ["...."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [3, 0] }, { "name": "A2", "start": [1, 0], "goal": [2, 0] }] });
    passes(&behind, &goal, &task("solvable"));
    let lane = json!({ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }] });
    passes(&lane, &json!({ "tools": ["slow-zone"] }), &dear);
    let both = json!({ "tools": ["obstacle"] });
    let alone = json!({ "giveway": 1, "map": ["...", "..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }] });
    // Two obstacles together shut both rows.
    passes(&alone, &both, &task("impossible"));
    let one = json!({ "tools": ["obstacle"], "edits": 1 });
    fails(&alone, &one, &task("impossible"), Problem::Unsolved);
}

#[test]
fn an_order_works_or_none_does() {
    let task = |find: &str| json!({ "kind": "order", "find": find });
    let Finding::Failed(Problem::SomeOrderWorks(order)) =
        found(&lesson(&crossing(), &json!({}), &task("none")))
    else {
        panic!("no order works");
    };
    assert_eq!(order, ["A1", "A2"]);
    passes(&crossing(), &json!({}), &task("works"));
    passes(&crossing(), &json!({}), &task("best"));
    fails(&crossing(), &json!({}), &task("worse"), Problem::NoOrder);
}

#[test]
fn some_method_reaches_what_is_asked() {
    let mut lessons = shipped::lessons().into_iter();
    let (_, lesson) = lessons
        .find(|(name, _)| name == "when-the-world-changes")
        .unwrap();
    let is_change = |step: &&Step| matches!(step.task, Some(Task::Change(_)));
    let step = lesson.steps.iter().find(is_change).unwrap().clone();
    let mut lesson = Lesson {
        steps: vec![step],
        ..lesson
    };
    assert_eq!(found(&Rc::new(lesson.clone())), Finding::Passed);
    let Some(Task::Change(task)) = &mut lesson.steps[0].task else {
        unreachable!()
    };
    task.kept = Some(9);
    let none = Finding::Failed(Problem::NoMethod);
    assert_eq!(found(&Rc::new(lesson)), none);
}

#[test]
fn the_tasks_of_the_course_pass() {
    for (name, lesson) in shipped::lessons() {
        let only = std::env::var("GIVEWAY_LESSON").ok();
        if only.is_some_and(|only| only != name) {
            continue;
        }
        let lesson = Rc::new(lesson);
        let mut check = Verification::default();
        run(&mut check, share(&lesson, false));
        for subject in Subject::all(&lesson) {
            let finding = check.of(&subject).unwrap();
            assert_eq!(finding, &Finding::Passed, "{name}: {subject:?}");
        }
    }
}

#[test]
fn what_the_author_solves_counts_for_that_text_only() {
    let mut larger = ring();
    larger["map"] = json!(["...", ".#.", "...", "..."]);
    let until = json!({ "is": "impossible" });
    let task = json!({ "kind": "paint", "until": until });
    let step = json!({ "tools": ["robot"], "cells": [[1, 0], [1, 2]] });
    let (one, other) = (
        lesson(&ring(), &step, &task),
        lesson(&crossing(), &step, &task),
    );
    let subject = Box::new(Subject::all(&one).remove(0));
    let mut check = Verification::default();
    run(&mut check, share(&one, false));
    assert_eq!(check.standing(&one), Standing::Failed);
    run(&mut check, Action::Solved(subject.clone()));
    assert_eq!(check.standing(&one), Standing::Passed);
    assert_eq!(run(&mut check, share(&one, false)), (vec![one.clone()], 0));
    assert_eq!(check.standing(&other), Standing::Unchecked);
    run(&mut check, share(&other, false));
    assert_eq!(check.standing(&other), Standing::Failed);
    // Solved first and checked then: only its start is looked at.
    let mut check = Verification::default();
    run(&mut check, Action::Solved(subject));
    assert_eq!(run(&mut check, share(&one, false)), (vec![one], 1));
}

#[test]
fn prose_is_no_part_of_what_is_checked() {
    let one = lesson(&crossing(), &json!({}), &offers(&[2, 3]));
    let mut other = (*one).clone();
    other.steps[0].title = "Another title".into();
    other.steps[0].hints.clear();
    let other = Rc::new(other);
    let mut check = Verification::default();
    assert_eq!(run(&mut check, share(&one, false)), (vec![one], 1));
    assert_eq!(run(&mut check, share(&other, false)), (vec![other], 0));
}

#[test]
fn what_is_not_known_is_shared_only_when_that_is_said() {
    let one = lesson(&crossing(), &json!({}), &offers(&[2, 3]));
    let lost = |request: &Request| match serve(request, &SilentHost) {
        Response::Solved(answer) => Response::Solved(SolveAnswer {
            complete: false,
            ..answer
        }),
        other => other,
    };
    let mut check = Verification::default();
    // Before anything was checked, it is not.
    assert_eq!(run_with(&mut check, share(&one, true), lost).0, []);
    assert_eq!(check.standing(&one), Standing::Unknown);
    let subject = Subject::all(&one).remove(0);
    let findings = [check.of(&subject).cloned()];
    assert_eq!(to_do(&findings).len(), 1);
    assert_eq!(run_with(&mut check, share(&one, false), lost), (vec![], 1));
    assert_eq!(run(&mut check, share(&one, true)), (vec![one.clone()], 0));
    // What is wrong is never shared.
    let wrong = lesson(&crossing(), &json!({}), &offers(&[2, 4]));
    run(&mut check, share(&wrong, false));
    assert_eq!(run(&mut check, share(&wrong, true)), (vec![], 0));
}

#[test]
fn a_late_answer_counts_for_nothing() {
    let one = lesson(&crossing(), &json!({}), &offers(&[2, 3]));
    let (check, effects) = reduce(Verification::default(), share(&one, false));
    let [Effect::Ask { number, request }] = &*effects else {
        panic!("{effects:?}");
    };
    assert_eq!(check.progress(), Some((1, 1)));
    let answered = |number: AskNumber| Action::Answered {
        number,
        response: Box::new(serve(request, &SilentHost)),
    };
    let (check, effects) = reduce(check, Action::Cancel);
    assert_eq!(effects, [Effect::Forget]);
    let (check, effects) = reduce(check, answered(*number));
    assert_eq!(
        (check.standing(&one), effects),
        (Standing::Unchecked, vec![])
    );
    // Nor does it for a check that was begun since.
    let (check, _) = reduce(check, share(&one, false));
    let (check, effects) = reduce(check, answered(*number));
    assert_eq!((check.progress(), effects), (Some((1, 1)), vec![]));
    // A solver that breaks down leaves the task unknown.
    let failed = Action::Failed {
        number: AskNumber(number.0 + 1),
        sentence: "The solver is no more.".into(),
    };
    let (check, effects) = reduce(check, failed);
    assert_eq!((check.standing(&one), effects), (Standing::Unknown, vec![]));
}
