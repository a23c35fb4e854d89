//! What is kept of lessons: how far each has come, also in two tabs.

use std::rc::Rc;

use giveway_course::learner::{Action, Effect, Judge, Learner, Onward, Progress, Stage, reduce};
use giveway_course::lesson::{Id, Value};
use giveway_course::port::{BoardNumber, FromPage, Happened, ToPage};

use super::super::shipped;
use super::{answered, board, id, opened, painted, said};

#[test]
fn the_course_goes_on_with_what_was_begun_then_with_what_is_new() {
    let course = shipped::course();
    let all: Vec<Id> = course.lessons().map(|entry| entry.lesson.clone()).collect();
    let progress = |reached: &[(usize, usize, bool)]| {
        let lessons = reached.iter().map(|&(lesson, step, done)| {
            format!("\"{}\":{{\"step\":{step},\"done\":{done}}}", all[lesson])
        });
        let lessons = lessons.collect::<Vec<_>>().join(",");
        let text = format!("{{\"giveway\":1,\"lessons\":{{{lessons}}}}}");
        Progress::read(&text).unwrap()
    };
    let next = |progress: &Progress| {
        let onward = Onward::of(&course, progress).unwrap();
        let place = all.iter().position(|id| *id == onward.entry().lesson);
        let word = match onward {
            Onward::Start(_) => "start",
            Onward::GoOn(_) => "go on",
            Onward::Again(_) => "again",
        };
        (word, place.unwrap())
    };
    assert_eq!(next(&Progress::default()), ("start", 0));
    assert_eq!(
        next(&progress(&[(0, 0, true), (3, 2, false)])),
        ("go on", 3)
    );
    assert_eq!(next(&progress(&[(0, 0, true), (1, 0, true)])), ("go on", 2));
    let done: Vec<_> = (0..all.len()).map(|lesson| (lesson, 0, true)).collect();
    assert_eq!(next(&progress(&done)), ("again", 0));
    // Then with those of which tasks are left.
    let text = progress(&done).write();
    let from = format!("\"{}\":{{", all[5]);
    let at = text.find(&from).unwrap() + from.len();
    let end = at + text[at..].find('}').unwrap();
    let left = "\"step\":1,\"seen\":true,\"solved\":[2],\"tasks\":2";
    let text = [&text[..at], left, &text[end..]].concat();
    assert_eq!(next(&Progress::read(&text).unwrap()), ("go on", 5));
}

#[test]
fn a_lesson_is_done_when_all_of_its_tasks_are_solved() {
    let (mut learner, _) = opened("room-to-pass", 0);
    let name = id("room-to-pass");
    assert_eq!(learner.progress.stage(&name), Stage::Begun(0));
    for step in 1..4 {
        learner = reduce(learner, Action::Next).0;
        assert_eq!(learner.progress.stage(&name), Stage::Begun(step));
    }
    // Only read: all of its tasks are left.
    let (learner, effects) = reduce(learner, Action::Next);
    assert!(learner.open.is_none() && effects.contains(&Effect::Page(ToPage::Close)));
    let seen = |step, solved| Stage::Seen {
        step,
        solved,
        tasks: 3,
    };
    assert_eq!(learner.progress.stage(&name), seen(1, 0));
    assert_eq!(learner.progress.done(), 0);

    let reopen = |learner| {
        let lesson = Rc::new(shipped::lesson("room-to-pass"));
        let id = name.clone();
        reduce(
            learner,
            Action::Open {
                id,
                lesson,
                at: None,
            },
        )
    };
    // It is opened at the first task that is left; a wrong answer solves none.
    let (learner, _) = reopen(learner);
    assert_eq!(learner.open.as_ref().unwrap().index(), 1);
    let (learner, effects) = reduce(learner, Action::Guess(Value::Number(7)));
    let (learner, _) = answered(learner, effects);
    let (learner, _) = reduce(learner, Action::Go(2));
    let (learner, effects) = reduce(learner, Action::Choose(0));
    let (learner, _) = answered(learner, effects);
    assert_eq!(learner.progress.stage(&name), seen(2, 0));
    let (learner, effects) = reduce(learner, Action::Choose(1));
    let (learner, effects) = answered(learner, effects);
    assert!(effects.contains(&Effect::Keep(learner.progress.clone())));
    let (learner, effects) = reduce(learner, Action::Next);
    let edit = painted(&learner, 3, 1);
    let (learner, effects) = reduce(learner, said(board(&effects), edit));
    let (learner, _) = answered(learner, effects);
    let (learner, _) = reduce(learner, Action::Next);
    assert_eq!(learner.progress.stage(&name), seen(1, 2));
    let (learner, _) = reopen(learner);
    let (learner, effects) = reduce(learner, Action::Guess(Value::Number(9)));
    let (learner, _) = answered(learner, effects);
    assert_eq!(learner.progress.stage(&name), Stage::Done);
    assert_eq!(learner.progress.done(), 1);
    let kept = learner.progress.write();
    assert_eq!(Progress::read(&kept), Ok(learner.progress.clone()));
    // Once done, it begins at its first step again.
    let (learner, _) = reduce(learner, Action::Close);
    assert_eq!(reopen(learner).0.open.unwrap().index(), 0);
}

#[test]
fn progress_is_read_back_with_distrust() {
    // As it was kept when a lesson was done as soon as it was read to its end.
    let early =
        r#"{"giveway":1,"lessons":{"x":{"step":0,"done":true},"y":{"step":2,"done":false}}}"#;
    let early = Progress::read(early).unwrap();
    assert_eq!(early.stage(&id("x")), Stage::Done);
    assert_eq!(early.stage(&id("y")), Stage::Begun(2));
    let (learner, _) = reduce(Learner::default(), Action::Kept(early.clone()));
    assert_eq!(learner.progress, early);
    for bad in [
        "",
        "[]",
        r#"{"giveway":2,"lessons":{}}"#,
        r#"{"giveway":1,"lessons":{"../x":{"step":0}}}"#,
        r#"{"giveway":1,"lessons":{"x":{"step":99}}}"#,
        r#"{"giveway":1,"lessons":{"x":{"step":-1}}}"#,
        r#"{"giveway":1,"lessons":{"x":{"step":1,"tasks":99}}}"#,
        r#"{"giveway":1,"lessons":{"x":{"step":1,"solved":[99]}}}"#,
        r#"{"giveway":1,"lessons":{},"more":1}"#,
    ] {
        assert!(Progress::read(bad).is_err(), "{bad}");
    }
    let (learner, _) = reduce(learner, Action::Reset);
    assert!(learner.progress.is_empty());
}

/// Progress of one lesson, as a browser keeps it.
fn kept(lesson: &str, reached: &str) -> Progress {
    let text = format!(r#"{{"giveway":1,"lessons":{{"{lesson}":{reached}}}}}"#);
    Progress::read(&text).unwrap()
}

#[test]
fn what_two_tabs_keep_comes_together() {
    let (one, two) = ("room-to-pass", "two-robots-one-cell");
    let join = |learner: Learner, progress: &Progress| {
        let (learner, effects) = reduce(learner, Action::Kept(progress.clone()));
        assert!(effects.is_empty());
        learner
    };
    let stage = |learner: &Learner, lesson| learner.progress.stage(&id(lesson));
    let first = opened(one, 1).0;
    let second = opened(two, 2).0;
    let both = join(first.clone(), &second.progress);
    assert_eq!(stage(&both, one), Stage::Begun(1));
    assert_eq!(stage(&both, two), Stage::Begun(2));
    // Whoever comes first.
    assert_eq!(join(second, &first.progress).progress, both.progress);

    // What was solved in either counts, and the furthest step.
    let begun = kept(one, r#"{"step":3,"solved":[1],"tasks":3}"#);
    let other = kept(one, r#"{"step":2,"solved":[2],"tasks":3}"#);
    let joined = join(join(Learner::default(), &begun), &other);
    let whole = kept(one, r#"{"step":3,"solved":[1,2],"tasks":3}"#);
    assert_eq!(joined.progress, whole);
    // What was read to its end tells where to go on.
    let read = kept(one, r#"{"step":1,"seen":true,"solved":[2],"tasks":3}"#);
    let (solved, tasks) = (2, 3);
    let seen = Stage::Seen {
        step: 1,
        solved,
        tasks,
    };
    assert_eq!(stage(&join(joined.clone(), &read), one), seen);

    // What is forgotten does not come back from a tab that has not heard of it.
    let (forgotten, _) = reduce(joined.clone(), Action::Reset);
    assert!(
        join(forgotten.clone(), &joined.progress)
            .progress
            .is_empty()
    );
    assert!(join(joined, &forgotten.progress).progress.is_empty());
    let again = Progress::read(&forgotten.progress.write()).unwrap();
    assert_eq!(again, forgotten.progress);

    // There are never more lessons than can be read.
    let many = |name: &str| -> Progress {
        let lessons: Vec<String> = (0..200)
            .map(|at| format!(r#""{name}-{at}":{{"step":0}}"#))
            .collect();
        let text = format!(r#"{{"giveway":1,"lessons":{{{}}}}}"#, lessons.join(","));
        Progress::read(&text).unwrap()
    };
    let full = join(join(Learner::default(), &many("a")), &many("b"));
    assert_eq!(Progress::read(&full.progress.write()), Ok(full.progress));
}

#[test]
fn a_lesson_in_which_all_is_forgotten_goes_on_being_kept() {
    let (learner, effects) = opened("room-to-pass", 3);
    let (learner, _) = reduce(learner, Action::Reset);
    assert!(learner.progress.is_empty());
    let edit = painted(&learner, 3, 1);
    let (learner, effects) = reduce(learner, said(board(&effects), edit));
    let (learner, _) = answered(learner, effects);
    let name = id("room-to-pass");
    assert_eq!(learner.progress.stage(&name), Stage::Begun(3));
    let (learner, _) = reduce(learner, Action::Reset);
    let (learner, effects) = reduce(learner, Action::Next);
    let seen = Stage::Seen {
        step: 1,
        solved: 0,
        tasks: 3,
    };
    assert_eq!(learner.progress.stage(&name), seen);
    assert!(effects.contains(&Effect::Keep(learner.progress)));
}

#[test]
fn an_answer_counts_though_the_step_is_left_before_it_is_judged() {
    let name = id("room-to-pass");
    let solved = |learner: &Learner| learner.progress.write().contains(r#""solved":[3]"#);
    for leave in [
        Action::Next,
        Action::Back,
        Action::Close,
        Action::Page(FromPage {
            number: BoardNumber(1),
            what: Happened::Closed,
        }),
    ] {
        let (learner, effects) = opened("room-to-pass", 3);
        let number = board(&effects);
        let edit = painted(&learner, 3, 1);
        let (learner, asking) = reduce(learner, said(number, edit));
        let (learner, effects) = reduce(learner, leave.clone());
        assert!(!effects.contains(&Effect::Forget), "{leave:?}");
        let judge = learner.open.as_ref().map(|open| open.judge().clone());
        assert!(matches!(judge, None | Some(Judge::Waiting)), "{leave:?}");
        // Nothing else happens to the step that is open now.
        let (later, effects) = answered(learner.clone(), asking.clone());
        assert_eq!(effects, [Effect::Keep(later.progress.clone())], "{leave:?}");
        assert_eq!(later.open, learner.open, "{leave:?}");
        assert!(solved(&later) && !solved(&learner), "{leave:?}");

        // What is forgotten stays so.
        let (reset, _) = reduce(learner, Action::Reset);
        let (reset, effects) = answered(reset, asking);
        assert!(reset.progress.is_empty() && effects.is_empty(), "{leave:?}");
    }

    // What is asked next takes the solver away from it.
    let (learner, effects) = opened("room-to-pass", 3);
    let edit = painted(&learner, 3, 1);
    let (learner, asking) = reduce(learner, said(board(&effects), edit));
    let (learner, _) = reduce(learner, Action::Go(1));
    let (learner, guess) = reduce(learner, Action::Guess(Value::Number(9)));
    let (learner, effects) = answered(learner, asking);
    assert!(effects.is_empty() && !solved(&learner));
    let (learner, _) = answered(learner, guess);
    assert!(learner.open.as_ref().unwrap().is_solved());
    assert_ne!(learner.progress.stage(&name), Stage::New);
}
