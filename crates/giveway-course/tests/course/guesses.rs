//! What is said of a guess at a value for which a lesson lists answers.

use std::rc::Rc;

use giveway_course::judge::words::said;
use giveway_course::learner::{Action, Effect, Learner, reduce};
use giveway_course::lesson::{Task, Value};
use giveway_solve::{SilentHost, serve};

use super::shipped;

/// What is said of a guess at a makespan of 9, of a lesson that lists these answers.
fn said_of(guess: u32, listed: &[u32]) -> String {
    let mut lesson = shipped::lesson("room-to-pass");
    let step = &mut lesson.steps[1];
    let Some(Task::Predict(task)) = &mut step.task else {
        unreachable!()
    };
    task.answers
        .retain(|answer| matches!(answer.value, Value::Number(it) if listed.contains(&it)));
    let step = step.clone();
    let open = Action::Open {
        id: "room-to-pass".parse().unwrap(),
        lesson: Rc::new(lesson),
        at: Some(1),
    };
    let (learner, _) = reduce(Learner::default(), open);
    let (mut learner, mut effects) = reduce(learner, Action::Guess(Value::Number(guess)));
    while let Some(Effect::Ask { number, request }) = effects
        .iter()
        .find(|effect| matches!(effect, Effect::Ask { .. }))
    {
        let response = Box::new(serve(request, &SilentHost));
        let number = *number;
        (learner, effects) = reduce(learner, Action::Answered { number, response });
    }
    let verdict = learner.open.as_ref().unwrap().judge().verdict().unwrap();
    said(verdict, &step).text.plain()
}

#[test]
fn a_wrong_guess_is_told_as_wrong_whether_the_right_answer_is_listed_or_not() {
    for listed in [&[7, 9][..], &[7]] {
        let said = said_of(7, listed);
        assert!(said.starts_with("Not this: it is 9. "), "{said}");
    }
    let said = said_of(9, &[7, 9]);
    assert!(!said.contains("Not this"), "{said}");
}
