//! A learner on the way through lessons: what is asked, told and kept; random actions.

mod pointing;
mod progress;
mod random;

use std::rc::Rc;

use giveway_course::judge::Why;
use giveway_course::learner::{Action, AskNumber, Effect, Judge, Learner, Proof, reduce};
use giveway_course::lesson::{Id, Tool, Value};
use giveway_course::port::{BoardNumber, BoardPlan, FromPage, Happened, ToPage};
use giveway_model::Cell;
use giveway_model::format::native;
use giveway_solve::change::Method;
use giveway_solve::{Request, SilentHost, serve};

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
