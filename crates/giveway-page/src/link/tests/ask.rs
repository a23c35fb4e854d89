//! Links with a question.

use giveway_model::{Cell, Question};

use super::{bare, why};
use crate::link::{ask, keep, kept, open, write};
use crate::{Action, AskAction, Draft, Phase, SolveAction, State, WorkerAction, reduce, sample};

#[test]
fn a_question_is_asked_again() {
    let question = Question::Charge {
        agent: "A1".to_owned(),
        at: Some(Cell::new(6, 2)),
        time: None,
    };
    let state = reduce(
        &sample::solved(),
        Action::Ask(AskAction::Ask(question.clone())),
    );
    let text = write(&state);
    assert!(text.contains("&ask="), "{text}");
    let resumed = kept(&keep(&state)).unwrap();
    assert_eq!(
        resumed.document.mode.asking().unwrap().question(),
        &question
    );
    assert!(resumed.work.is_idle(), "a reload asks nothing by itself");
    let opened = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(opened.phase(), Phase::Asking);
    assert_eq!(opened.document.mode.asking().unwrap().question(), &question);
    assert_eq!(opened.document.answer.unwrap().plan(), state.plan());
    let closed = reduce(&state, Action::Ask(AskAction::Close));
    assert!(!write(&closed).contains("&ask="));
}

#[test]
fn a_question_without_a_plan_waits_for_the_answer() {
    let (text, _) = {
        let text = bare(&sample::solved());
        let at = text.find("&plan=").unwrap();
        (format!("{}&ask=makespan", &text[..at]), at)
    };
    let opened = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(opened.phase(), Phase::Solving);
    let run = opened.work.id().unwrap();
    let solved = sample::solved().document.answer.unwrap().solved.clone();
    let response = Box::new(giveway_solve::Response::Solved(solved));
    let answered = reduce(
        &opened,
        Action::Worker(WorkerAction::Respond { job: run, response }),
    );
    assert_eq!(answered.phase(), Phase::Asking);
    assert_eq!(
        answered.document.mode.asking().unwrap().question(),
        &Question::Makespan
    );
    let cancelled = reduce(&opened, Action::Solve(SolveAction::Cancel));
    assert_eq!(cancelled.phase(), Phase::Editing);
}

#[test]
fn every_question_comes_back() {
    for text in [
        "wait;A2!at.3.1!from.0!to.2!at-least.2",
        "wait;A2",
        "charge;A1!at.6.2!time.5",
        "no-charge;A1!at.6.2",
        "visit;%2D%2Dx%21!at.3.1!time.5",
        "no-visit;A1!at.3.1",
        "no-visit;any!at.3.1",
        "move;A1!from-cell.0.0!to-cell.1.0!time.5",
        "no-move;A1!from-cell.0.0!to-cell.1.0",
        "slow;A1!from-cell.0.0!to-cell.1.0",
        "slow;A1",
        "order;A1!first.0.0!second.1.0",
        "arrival;A1",
        "length;A1!fewer-than.9",
        "makespan",
        "sum-of-costs",
        "penalty",
        "charges;A1",
        "moves",
        "waits",
        "yield;A1;%3Cb%3E%20x!at.3.1",
        "unsolvable",
        "plan",
    ] {
        let question = ask::read(text).unwrap_or_else(|| panic!("{text}"));
        let written = ask::write(&question);
        assert_eq!(ask::read(&written), Some(question), "{written}");
        assert_eq!(written.replace("--x", "%2D%2Dx"), text);
    }
}

#[test]
fn hostile_questions_are_refused() {
    let good = bare(&sample::solved());
    for question in [
        "",
        "why",
        "wait",
        "wait;%FF",
        "wait;A1!",
        "wait;A1!at",
        "wait;A1!at.1",
        "wait;A1!at.x.y",
        "wait;A1!from.-1",
        "wait;A1!time.1",
        "wait;A1;A2",
        "makespan!at.1.1",
        "yield;A1!at.1.1",
        "wait;A1!__proto__.1",
        "charge;A1!time.99999999999",
    ] {
        let told = why(&format!("{good}&ask={question}"));
        assert!(
            told.contains("\u{201c}ask\u{201d} is broken"),
            "{question}: {told}"
        );
    }
    // It can be read, and does not fit: the plan is shown all the same.
    let text = format!("{good}&ask=wait;nobody");
    let state = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(
        (state.phase(), state.document.mode.asking()),
        (Phase::Found, None)
    );
    assert!(state.view.notice.unwrap().sentence().contains("nobody"));
}
