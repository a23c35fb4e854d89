//! Guesses at a value for which a lesson lists answers: what is said of them, and what is
//! kept.

use std::rc::Rc;

use giveway_course::judge::words::said;
use giveway_course::learner::{Action, Effect, Learner, Progress, reduce};
use giveway_course::lesson::{Lesson, Task, Value};
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
    let learner = guessed(opened(Learner::default(), lesson), guess);
    let verdict = learner.open.as_ref().unwrap().judge().verdict().unwrap();
    said(verdict, &step).text.plain()
}

/// At the second step of a lesson.
fn opened(learner: Learner, lesson: Lesson) -> Learner {
    let open = Action::Open {
        id: "room-to-pass".parse().unwrap(),
        lesson: Rc::new(lesson),
        at: Some(1),
    };
    reduce(learner, open).0
}

fn guessed(learner: Learner, guess: u32) -> Learner {
    let (mut learner, mut effects) = reduce(learner, Action::Guess(Value::Number(guess)));
    while let Some(Effect::Ask { number, request }) = effects
        .iter()
        .find(|effect| matches!(effect, Effect::Ask { .. }))
    {
        let response = Box::new(serve(request, &SilentHost));
        let number = *number;
        (learner, effects) = reduce(learner, Action::Answered { number, response });
    }
    learner
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

#[test]
fn a_solved_step_is_shown_as_solved_after_a_reload_unless_it_was_edited() {
    let lesson = shipped::lesson("room-to-pass");
    let was_solved = |learner: &Learner| learner.open.as_ref().unwrap().was_solved();
    // The page after a reload: only the progress is left.
    let reloaded = |learner: &Learner, lesson: Lesson| {
        let text = learner.progress.write();
        let progress = Progress::read(&text).unwrap();
        let (learner, _) = reduce(Learner::default(), Action::Kept(progress));
        opened(learner, lesson)
    };
    let before = |learner: &Learner| learner.open.as_ref().unwrap().answer_before();
    let fresh = opened(Learner::default(), lesson.clone());
    assert!(!was_solved(&fresh) && before(&fresh).is_none());
    assert!(!was_solved(&reloaded(
        &guessed(fresh.clone(), 7),
        lesson.clone()
    )));
    let solved = guessed(fresh, 9);
    let again = reloaded(&solved, lesson.clone());
    assert!(was_solved(&again));
    assert!(before(&again).unwrap().starts_with("At 9."));
    // It can be done again, and then what is said is of that.
    let (anew, _) = reduce(again.clone(), Action::Afresh);
    assert!(!was_solved(&anew));
    let wrong = guessed(again.clone(), 7);
    assert!(!was_solved(&wrong) && before(&wrong).is_none());
    let (forgotten, _) = reduce(again, Action::Reset);
    assert!(!was_solved(&forgotten) && before(&forgotten).is_none());
    let mut edited = lesson;
    edited.steps[1].title += "!";
    assert!(!was_solved(&reloaded(&solved, edited)));
}
