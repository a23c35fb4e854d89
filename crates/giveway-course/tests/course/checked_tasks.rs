//! The check of each kind of task, right and wrong, with the real solver.

use std::rc::Rc;

use giveway_course::author::check::{Finding, LessonCheck, Problem, Subject, sentence};
use giveway_course::lesson::{Lesson, Step, Task, Value};
use giveway_model::Cost;
use serde_json::{Value as Json, json};

use super::checked::{crossing, lesson, offers, ring, run, share};
use super::shipped;

/// Two robots that would have to swap in a dead end.
fn stuck() -> Json {
    json!({ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }, { "name": "A2", "start": [2, 0], "goal": [0, 0] }] })
}

/// What is found for the only task of a lesson; it is shared just where that has passed.
#[track_caller]
fn found(lesson: &Rc<Lesson>) -> Finding {
    let mut check = LessonCheck::default();
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
        let mut check = LessonCheck::default();
        run(&mut check, share(&lesson, false));
        for subject in Subject::all(&lesson) {
            let finding = check.of(&subject).unwrap();
            assert_eq!(finding, &Finding::Passed, "{name}: {subject:?}");
        }
    }
}
