//! The check of a lesson before it is shared: what its reducer keeps, drops and shares.

use std::rc::Rc;

use giveway_course::author::check::{
    Action, Effect, LessonCheck, Standing, Subject, reduce, to_do,
};
use giveway_course::learner::AskNumber;
use giveway_course::lesson::Lesson;
use giveway_solve::{Request, Response, SilentHost, SolveAnswer, serve};
use serde_json::{Value as Json, json};

use super::judges;

/// A lesson of one step with a task, as the check takes it.
pub(crate) fn lesson(scene: &Json, step: &Json, task: &Json) -> Rc<Lesson> {
    Rc::new(judges::lesson(scene, step, task))
}

/// Two robots that meet in a corridor with a way around.
pub(crate) fn ring() -> Json {
    json!({ "giveway": 1, "map": ["...", ".#.", "..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }, { "name": "A2", "start": [2, 2], "goal": [0, 2] }] })
}

/// Two robots whose ways cross: one has to wait.
pub(crate) fn crossing() -> Json {
    json!({ "giveway": 1, "map": ["#.#", "...", "#.#"], "agents": [
        { "name": "A1", "start": [0, 1], "goal": [2, 1] }, { "name": "A2", "start": [1, 2], "goal": [1, 0] }] })
}

/// A task to predict the makespan, with these values to pick from.
pub(crate) fn offers(values: &[u32]) -> Json {
    let answer = |value: &u32| json!({ "value": value, "text": "So many.", "reply": "Look." });
    let answers: Vec<Json> = values.iter().map(answer).collect();
    json!({ "kind": "predict", "what": { "is": "cost", "cost": "makespan" }, "answers": answers })
}

pub(crate) fn share(lesson: &Rc<Lesson>, anyway: bool) -> Action {
    let lesson = Rc::clone(lesson);
    Action::Share { lesson, anyway }
}

/// Does something, and has the solver answer all that is asked; the lessons shared then.
pub(crate) fn run(check: &mut LessonCheck, action: Action) -> (Vec<Rc<Lesson>>, usize) {
    run_with(check, action, |request| serve(request, &SilentHost))
}

fn run_with(
    check: &mut LessonCheck,
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
    let mut check = LessonCheck::default();
    run(&mut check, share(&one, false));
    assert_eq!(check.standing(&one), Standing::Failed);
    run(&mut check, Action::Solved(subject.clone()));
    assert_eq!(check.standing(&one), Standing::Passed);
    assert_eq!(run(&mut check, share(&one, false)), (vec![one.clone()], 0));
    assert_eq!(check.standing(&other), Standing::Unchecked);
    run(&mut check, share(&other, false));
    assert_eq!(check.standing(&other), Standing::Failed);
    // Solved first and checked then: only its start is looked at.
    let mut check = LessonCheck::default();
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
    let mut check = LessonCheck::default();
    assert_eq!(run(&mut check, share(&one, false)), (vec![one], 1));
    assert_eq!(run(&mut check, share(&other, false)), (vec![other], 0));
}

#[test]
fn what_is_not_known_is_shared_only_when_that_is_said() {
    let one = lesson(&crossing(), &json!({}), &offers(&[2, 3]));
    let lost = |request: &Request| match serve(request, &SilentHost) {
        Response::Solved(answer) => Response::Solved(SolveAnswer {
            reach: answer.reach.of_bounds(),
            ..answer
        }),
        other => other,
    };
    let mut check = LessonCheck::default();
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
    let (check, effects) = reduce(LessonCheck::default(), share(&one, false));
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
