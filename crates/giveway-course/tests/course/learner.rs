//! A learner on the way through lessons: what is asked, told and kept; random actions.

use std::rc::Rc;

use fastrand::Rng;
use giveway_course::judge::{Did, Why};
use giveway_course::learner::{
    Action, AskNumber, Effect, Judge, Learner, Onward, Progress, Proof, Stage, reduce,
};
use giveway_course::lesson::{Id, Lesson, Tool, Value};
use giveway_course::port::{BoardNumber, BoardPlan, FromPage, Hand, Happened, Lit, Pick, ToPage};
use giveway_model::Cell;
use giveway_model::format::native;
use giveway_solve::change::Method;
use giveway_solve::{Request, Response, SilentHost, serve};

use super::shipped;

fn id(name: &str) -> Id {
    name.parse().unwrap()
}

fn opened(name: &str, at: usize) -> (Learner, Vec<Effect>) {
    let action = Action::Open {
        id: id(name),
        lesson: Rc::new(shipped::lesson(name)),
        at: Some(at),
    };
    reduce(Learner::default(), action)
}

fn board(effects: &[Effect]) -> BoardNumber {
    let mut numbers = effects.iter().filter_map(|effect| match effect {
        Effect::Page(ToPage::Open(board)) => Some(board.number),
        Effect::Page(ToPage::StartAfresh(number)) => Some(*number),
        _ => None,
    });
    numbers.next_back().unwrap()
}

fn asked(effects: &[Effect]) -> Option<(AskNumber, Request)> {
    effects.iter().find_map(|effect| match effect {
        Effect::Ask { number, request } => Some((*number, (**request).clone())),
        _ => None,
    })
}

/// Answers all that the solver is asked, and gives the effects of the last answer.
fn answered(mut learner: Learner, mut effects: Vec<Effect>) -> (Learner, Vec<Effect>) {
    while let Some((number, request)) = asked(&effects) {
        let response = Box::new(serve(&request, &SilentHost));
        (learner, effects) = reduce(learner, Action::Answered { number, response });
    }
    (learner, effects)
}

fn said(number: BoardNumber, what: Happened) -> Action {
    Action::Page(FromPage { number, what })
}

fn painted(learner: &Learner, x: usize, y: usize) -> Happened {
    let mut scene = learner.open.as_ref().unwrap().scene().clone();
    scene.map[y].replace_range(x..=x, "#");
    Happened::Board(Box::new(scene))
}

#[test]
fn a_painted_cell_is_judged_and_sealed() {
    let (learner, effects) = opened("room-to-pass", 3);
    let number = board(&effects);
    let edit = painted(&learner, 3, 1);
    let (learner, effects) = reduce(learner, said(number, edit));
    assert!(matches!(
        learner.open.as_ref().unwrap().judge(),
        Judge::Looking(_)
    ));
    let (learner, effects) = answered(learner, effects);
    let open = learner.open.unwrap();
    assert!(open.is_solved());
    assert_eq!(open.attempts(), 1);
    assert!(effects.contains(&Effect::Page(ToPage::Seal(vec![Cell::new(3, 1)]))));
    assert!(effects.contains(&Effect::FocusNext));
}

#[test]
fn late_answers_and_messages_of_an_earlier_board_are_dropped() {
    let (learner, effects) = opened("room-to-pass", 3);
    let first = board(&effects);
    let other = painted(&learner, 5, 0);
    let edit = painted(&learner, 4, 0);
    let (learner, effects) = reduce(learner, said(first, edit));
    let (late, request) = asked(&effects).unwrap();
    let (learner, effects) = reduce(learner, said(first, other));
    assert!(effects.contains(&Effect::Forget));
    assert_ne!(asked(&effects).unwrap().0, late);
    let response = Box::new(serve(&request, &SilentHost));
    let before = learner.clone();
    let (learner, effects) = reduce(
        learner,
        Action::Answered {
            number: late,
            response,
        },
    );
    assert_eq!((learner.clone(), effects), (before, Vec::new()));
    let (learner, effects) = reduce(learner, Action::Afresh);
    assert_ne!(board(&effects), first);
    let before = learner.clone();
    let edit = painted(&before, 3, 1);
    let (learner, effects) = reduce(learner, said(first, edit));
    assert_eq!((learner, effects), (before, Vec::new()));
}

#[test]
fn a_guess_reveals_the_plan_right_or_not() {
    for (guess, right) in [(9, true), (7, false)] {
        let (learner, effects) = opened("room-to-pass", 1);
        let hidden = effects.iter().any(|effect| {
            matches!(effect, Effect::Page(ToPage::Open(board)) if board.plan == BoardPlan::Hidden)
        });
        assert!(hidden);
        let (learner, effects) = reduce(learner, Action::Guess(Value::Number(guess)));
        let (learner, effects) = answered(learner, effects);
        assert_eq!(learner.open.unwrap().is_solved(), right);
        let shown = effects.iter().any(|effect| {
            matches!(effect, Effect::Page(ToPage::Show(evidence)) if evidence.proved && evidence.plan.is_some())
        });
        assert!(shown && effects.contains(&Effect::Page(ToPage::Play)));
    }
}

#[test]
fn who_says_nothing_is_shown_the_answer() {
    let (learner, _) = opened("room-to-pass", 1);
    let (learner, effects) = reduce(learner, Action::Reveal);
    let (learner, effects) = answered(learner, effects);
    let open = learner.open.as_ref().unwrap();
    assert!(!open.is_solved());
    let verdict = open.judge().verdict().unwrap();
    assert_eq!(verdict.why, Why::Revealed(Value::Number(9)));
    assert!(effects.contains(&Effect::Page(ToPage::Play)));
    assert!(!effects.contains(&Effect::FocusNext));
    // Where nothing is predicted, there is nothing to reveal.
    let (learner, _) = opened("room-to-pass", 3);
    let before = learner.clone();
    assert_eq!(reduce(learner, Action::Reveal), (before, Vec::new()));
}

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
fn one_of_the_robots_of_a_task_is_led() {
    let (learner, effects) = opened("all-move-on-at-once", 1);
    let number = board(&effects);
    let leads = |learner: &Learner| learner.open.as_ref().unwrap().leads().map(str::to_owned);
    assert_eq!(leads(&learner).as_deref(), Some("A1"));
    let (learner, effects) = reduce(learner, Action::Lead("A3".to_owned()));
    assert_eq!(effects, [Effect::Page(ToPage::Lead("A3".to_owned()))]);
    let (learner, _) = reduce(learner, said(number, Happened::Leads("A3".to_owned())));
    assert_eq!(leads(&learner).as_deref(), Some("A3"));
    assert!(!learner.open.as_ref().unwrap().has_done());
    let led = r#"{ "giveway": 1, "paths": { "A1": [[0, 0]], "A3": [[1, 1], [0, 1]] } }"#;
    let led = Happened::Led(Box::new(native::read_plan(led).unwrap()));
    let (learner, _) = reduce(learner, said(number, led));
    assert!(learner.open.as_ref().unwrap().has_done());
    let back = r#"{ "giveway": 1, "paths": { "A1": [[0, 0]], "A3": [[1, 1]] } }"#;
    let back = Happened::Led(Box::new(native::read_plan(back).unwrap()));
    let (learner, _) = reduce(learner, said(number, back));
    assert!(!learner.open.as_ref().unwrap().has_done());
    let (learner, _) = reduce(learner, Action::Afresh);
    assert_eq!(leads(&learner).as_deref(), Some("A1"));
    let (learner, _) = reduce(learner, Action::Go(2));
    assert_eq!(leads(&learner), None, "nobody is led there");
}

#[test]
fn a_proof_is_accepted_as_it_is_and_refused_with_another_byte() {
    let (learner, _) = opened("no-plan-is-better", 3);
    let proof = |learner: &Learner| learner.open.as_ref().unwrap().proof().unwrap().clone();
    assert_eq!(proof(&learner), Proof::Unasked);
    let (asking, effects) = reduce(learner, Action::CheckProof);
    let (number, request) = asked(&effects).unwrap();
    assert_eq!(proof(&asking), Proof::Asked(number));
    let response = Box::new(serve(&request, &SilentHost));
    let answer = Action::Answered { number, response };
    let (learner, _) = reduce(asking.clone(), answer.clone());
    let held = |learner: &Learner| match proof(learner) {
        Proof::Held(held) => *held,
        other => panic!("{other:?}"),
    };
    let first = held(&learner);
    assert!(first.is_accepted() && first.changed().is_none() && first.bytes() > 1000);
    let (learner, _) = reduce(learner, Action::ChangeByte);
    let changed = held(&learner);
    assert!(!changed.is_accepted());
    let byte = changed.changed().unwrap();
    assert!(byte.file.contains(".drat"));
    assert_ne!(byte.figures.0, byte.figures.1);
    let (learner, _) = reduce(learner, Action::ChangeByte);
    assert_eq!(held(&learner), first);

    // Who answers the task meanwhile asks again.
    let (answered, effects) = reduce(asking.clone(), Action::Choose(0));
    assert_eq!(proof(&answered), Proof::Unasked);
    assert!(effects.contains(&Effect::Forget));
    let (late, _) = reduce(answered, answer);
    assert_eq!(proof(&late), Proof::Unasked);
    let sentence = "It broke.".to_owned();
    let (failed, _) = reduce(asking, Action::Failed { number, sentence });
    assert_eq!(proof(&failed), Proof::Missing);
    let (none, effects) = reduce(opened("room-to-pass", 0).0, Action::CheckProof);
    assert!(none.open.unwrap().proof().is_none());
    assert!(asked(&effects).is_none());
}

#[test]
fn two_clicks_make_a_mark() {
    let (learner, effects) = opened("two-robots-one-cell", 2);
    let number = board(&effects);
    assert!(effects.iter().any(|effect| {
        matches!(effect, Effect::Page(ToPage::Open(board)) if board.hand == Hand::Points)
    }));
    let pick = |x, time, robots: &[&str]| {
        let robots = robots.iter().map(|name| (*name).to_owned()).collect();
        let cell = Cell::new(x, 0);
        Happened::Picked(Pick { cell, time, robots })
    };
    let (learner, _) = reduce(learner, said(number, pick(1, 1, &["A1"])));
    assert!(learner.open.as_ref().unwrap().pointed().is_some());
    let (learner, _) = reduce(learner, said(number, pick(2, 1, &["A2"])));
    assert!(matches!(learner.open.as_ref().unwrap().did(), Did::Marked(marks) if marks.len() == 1));
    // A wrong mark does not stay beside the next one.
    let (learner, _) = reduce(learner, said(number, pick(3, 3, &["A1", "A3"])));
    assert!(!learner.open.as_ref().unwrap().is_solved());
    let (learner, _) = reduce(learner, said(number, pick(2, 2, &["A1", "A3"])));
    assert!(
        learner.open.as_ref().unwrap().is_solved(),
        "{:?}",
        learner.open.unwrap().did()
    );
}

#[test]
fn of_two_robots_in_a_cell_the_one_that_swaps_is_meant() {
    let (learner, effects) = opened("trust-but-check", 0);
    let number = board(&effects);
    let pick = |x, robots: &[&str]| {
        let robots = robots.iter().map(|name| (*name).to_owned()).collect();
        let cell = Cell::new(x, 3);
        let pick = Pick {
            cell,
            time: 2,
            robots,
        };
        Happened::Picked(pick)
    };
    let (learner, _) = reduce(learner, said(number, pick(2, &["A1", "A3"])));
    let (learner, _) = reduce(learner, said(number, pick(3, &["A4"])));
    let (learner, _) = reduce(learner, said(number, pick(2, &["A1", "A3"])));
    let open = learner.open.unwrap();
    assert!(open.is_solved(), "{:?}", open.did());
    let Did::Marked(marks) = open.did() else {
        panic!("{:?}", open.did());
    };
    assert_eq!(marks[1].robots, ["A4", "A1"]);
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

#[test]
fn a_step_without_a_scene_goes_on_with_the_board_as_it_is() {
    let mut lesson = shipped::lesson("room-to-pass");
    lesson.steps[2].tools = vec![Tool::Obstacle, Tool::Erase];
    lesson.steps[3].scene = None;
    let open = Action::Open {
        id: id("room-to-pass"),
        lesson: Rc::new(lesson),
        at: Some(2),
    };
    let (learner, effects) = reduce(Learner::default(), open);
    let edit = painted(&learner, 4, 0);
    let Happened::Board(scene) = edit.clone() else {
        panic!("{edit:?}");
    };
    let (learner, _) = reduce(learner, said(board(&effects), edit));
    let (next, _) = reduce(learner.clone(), Action::Next);
    assert_eq!(next.open.unwrap().scene(), &*scene);
    // A robot that was erased is back: the step may be about it.
    let mut fewer = (*scene).clone();
    fewer.agents.remove(0);
    let erased = Happened::Board(Box::new(fewer));
    let (fewer, _) = reduce(learner.clone(), said(board(&effects), erased));
    let (next, _) = reduce(fewer, Action::Next);
    assert_eq!(next.open.unwrap().scene().agents, scene.agents);
    // Whoever comes from elsewhere gets the lesson's own.
    let (jumped, _) = reduce(learner, Action::Go(3));
    assert_ne!(jumped.open.unwrap().scene(), &*scene);
}

#[test]
fn a_solver_that_breaks_down_is_no_solution() {
    let (learner, effects) = opened("room-to-pass", 3);
    let edit = painted(&learner, 3, 1);
    let (learner, effects) = reduce(learner, said(board(&effects), edit));
    let (number, _) = asked(&effects).unwrap();
    let sentence = "The solver broke down.".to_owned();
    let (learner, _) = reduce(learner, Action::Failed { number, sentence });
    let open = learner.open.unwrap();
    assert!(open.judge().verdict().is_some() && !open.is_solved());
}

/// What is left of an effect in the outer world of a random test.
struct World {
    board: BoardNumber,
    asked: Vec<(AskNumber, Request)>,
}

fn random(rng: &mut Rng, learner: &Learner, world: &World, lessons: &[(Id, Rc<Lesson>)]) -> Action {
    let number = match rng.u8(0..5) {
        0 => BoardNumber(rng.u32(0..20)),
        _ => world.board,
    };
    let cell = Cell::new(rng.u32(0..7), rng.u32(0..4));
    match if learner.open.is_none() {
        0
    } else {
        rng.u8(0..40)
    } {
        0 => {
            let (id, lesson) = rng.choice(lessons).unwrap();
            Action::Open {
                id: id.clone(),
                lesson: lesson.clone(),
                at: rng.bool().then(|| rng.usize(0..9)),
            }
        }
        1 | 2 => Action::Next,
        3..6 | 14 | 15 => Action::Choose(rng.usize(0..4)),
        6 => Action::Back,
        7 => Action::Go(rng.usize(0..9)),
        8..12 => {
            let what = match (rng.u8(0..7), &learner.open) {
                (0, _) => Happened::Time(rng.u32(0..20)),
                (1, Some(open)) => {
                    let mut scene = open.scene().clone();
                    let (x, y) = (cell.x as usize, cell.y as usize);
                    if let Some(row) = scene.map.get_mut(y)
                        && x < row.len()
                    {
                        row.replace_range(x..=x, rng.choice(["#", ".", "+", "~"]).unwrap());
                    }
                    Happened::Board(Box::new(scene))
                }
                (2, _) => Happened::Led(Box::default()),
                (3, _) => Happened::Changed("revise".parse().unwrap()),
                (6, _) => Happened::Leads("A2".to_owned()),
                (4, _) if rng.u8(0..9) == 0 => Happened::Closed,
                _ => Happened::Picked(Pick {
                    cell,
                    time: rng.u32(0..5),
                    robots: ["A1", "A2"]
                        .iter()
                        .filter(|_| rng.bool())
                        .map(|n| (*n).to_owned())
                        .collect(),
                }),
            };
            said(number, what)
        }
        12 => Action::Guess(Value::Number(rng.u32(4..10))),
        13 => Action::Guess(Value::Cell(cell)),
        16 => Action::Order(vec!["A1".into(), "A2".into()]),
        17 => Action::NoOrder,
        19 if rng.bool() => Action::CheckProof,
        20 if rng.bool() => Action::ChangeByte,
        18 if rng.bool() => Action::Lead("A2".to_owned()),
        18 => Action::Hint,
        19 => Action::ShowEvidence,
        20 => Action::TakeBack,
        21 => Action::Afresh,
        22 => Action::Light(rng.bool().then_some(Lit::Cell(cell))),
        23 => Action::Failed {
            number: AskNumber(rng.u32(0..50)),
            sentence: "It broke.".into(),
        },
        _ => match world
            .asked
            .last()
            .filter(|_| rng.u8(0..4) > 0)
            .or_else(|| rng.choice(&world.asked))
        {
            // Answers come late, twice, or to another question.
            Some((number, request)) => Action::Answered {
                number: *number,
                response: Box::new(match (rng.u8(0..4), request) {
                    (0, _) => {
                        Response::Refused(giveway_solve::Refusal::Scene { faults: Vec::new() })
                    }
                    (_, Request::Solve(request)) if request.scene.agents.len() < 5 => {
                        serve(&Request::Solve(request.clone()), &SilentHost)
                    }
                    (_, Request::Plan(_) | Request::Change(_)) => serve(request, &SilentHost),
                    _ => Response::Refused(giveway_solve::Refusal::Scene { faults: Vec::new() }),
                }),
            },
            None => Action::Time(3),
        },
    }
}

#[test]
fn random_actions_keep_the_invariants() {
    let names = [
        "two-robots-one-cell",
        "room-to-pass",
        "one-after-the-other",
        "when-the-world-changes",
    ];
    let lessons: Vec<(Id, Rc<Lesson>)> = names
        .iter()
        .map(|name| (id(name), Rc::new(shipped::lesson(name))))
        .collect();
    let mut solved = 0;
    for seed in 0..120 {
        let mut rng = Rng::with_seed(seed);
        let mut learner = Learner::default();
        let mut world = World {
            board: BoardNumber(0),
            asked: Vec::new(),
        };
        for _ in 0..300 {
            let action = random(&mut rng, &learner, &world, &lessons);
            let told = format!("seed {seed}: {action:?}");
            let (next, effects) = reduce(learner.clone(), action.clone());
            assert_eq!(
                reduce(learner, action),
                (next.clone(), effects.clone()),
                "{told}"
            );
            learner = next;
            for effect in &effects {
                match effect {
                    Effect::Page(page) => {
                        assert_eq!(ToPage::from_bytes(&page.to_bytes()).as_ref(), Ok(page));
                        if let ToPage::Open(board) = page {
                            assert!(board.number > world.board, "{told}");
                            world.board = board.number;
                        }
                        if let ToPage::StartAfresh(number) = page {
                            assert!(*number > world.board, "{told}");
                            world.board = *number;
                        }
                    }
                    Effect::Ask { number, request } => {
                        let latest = world.asked.last().map(|(number, _)| *number);
                        assert!(latest.is_none_or(|latest| latest < *number), "{told}");
                        world.asked.push((*number, (**request).clone()));
                        // About the step that is open, or else one that was left.
                        let judge = learner.open.as_ref().map(|open| open.judge().clone());
                        let is_more = told.contains(": Answered");
                        assert!(
                            matches!(judge, Some(Judge::Looking(_))) || is_more,
                            "{told}"
                        );
                    }
                    Effect::Keep(progress) => assert_eq!(*progress, learner.progress, "{told}"),
                    Effect::Forget | Effect::FocusNext => {}
                }
            }
            if let Some(open) = &learner.open {
                assert!(open.index() < open.lesson.steps.len(), "{told}");
                let step = open.step().unwrap();
                assert!(open.hints().len() <= step.hints.len(), "{told}");
                let is_waiting = matches!(open.judge(), Judge::Waiting);
                assert!(step.task.is_some() || is_waiting, "{told}");
                assert_ne!(learner.progress.stage(&open.id), Stage::New, "{told}");
                solved += usize::from(open.is_solved());
            }
        }
    }
    assert!(solved > 50, "{solved}");
}

/// What the page is to say.
fn says(effects: &[Effect]) -> Vec<&str> {
    let says = effects.iter().filter_map(|effect| match effect {
        Effect::Page(ToPage::Say(sentence)) => Some(sentence.as_str()),
        _ => None,
    });
    says.collect()
}

#[test]
fn a_conflict_is_marked_once_and_a_click_that_does_nothing_says_why() {
    let (mut learner, effects) = opened("two-robots-one-cell", 2);
    let number = board(&effects);
    let mut click = |time, x, robots: &[&str]| {
        let robots = robots.iter().map(|&name| name.to_owned()).collect();
        let cell = Cell::new(x, 0);
        let pick = Happened::Picked(Pick { cell, time, robots });
        let (next, effects) = reduce(std::mem::take(&mut learner), said(number, pick));
        learner = next;
        let open = learner.open.as_ref().unwrap();
        let marks = match open.did() {
            Did::Marked(marks) => marks.len(),
            _ => 0,
        };
        let says = says(&effects)
            .into_iter()
            .map(str::to_owned)
            .collect::<Vec<_>>();
        (marks, says)
    };
    assert_eq!(click(0, 2, &[]).1, ["No robot is at (2, 0) at time 0."]);
    assert_eq!(click(2, 1, &["A2"]), (0, Vec::new()));
    let again = "Now click the robot that A2 gets into conflict with.";
    assert_eq!(click(2, 1, &["A2"]), (0, vec![again.to_owned()]));
    assert_eq!(click(2, 2, &["A1", "A3"]), (1, Vec::new()));
    // The same swap, before its step and from the other robot.
    assert_eq!(click(1, 1, &["A1"]), (1, Vec::new()));
    let known = "You have marked this conflict already.";
    assert_eq!(click(1, 2, &["A2"]), (1, vec![known.to_owned()]));
    assert_eq!(click(2, 2, &["A1", "A3"]), (2, Vec::new()));
    assert!(learner.open.unwrap().is_solved());
}

#[test]
fn a_step_about_a_change_has_it_on_its_board() {
    let (learner, effects) = opened("when-the-world-changes", 3);
    let opens = effects.iter().find_map(|effect| match effect {
        Effect::Page(ToPage::Open(board)) => Some(board),
        _ => None,
    });
    let changes = opens.unwrap().changes.clone().unwrap();
    assert_eq!(changes.changes.len(), 1);
    let robots = learner.open.as_ref().unwrap().robots();
    let names: Vec<&str> = robots.iter().map(|robot| robot.name.as_str()).collect();
    assert_eq!(names, ["A1", "A2", "A3"]);
    let (learner, effects) = reduce(learner, Action::Went(Method::Tunnel(1)));
    let (learner, _) = answered(learner, effects);
    let (_, effects) = reduce(learner, Action::ShowEvidence);
    let shows = effects.iter().find_map(|effect| match effect {
        Effect::Page(ToPage::Show(evidence)) => Some(evidence),
        _ => None,
    });
    assert_eq!(shows.unwrap().changes.as_ref(), Some(&changes));
}
