//! The report with the solver's own answers: delays against ways alone, questions asked before.

use giveway_model::{Cell, Question};
use giveway_solve::Status;

use super::ledger::corridor;
use super::{answered, saying};
use crate::ledger::{LedgerAction, column};
use crate::reduce::tests::after;
use crate::report::{Imprint, is_coming, report};
use crate::{Action, AskAction, Edit, Phase, SolveAction, State};

const ADD_UP: Action = Action::Ledger(LedgerAction::AddUp);

fn told(state: &State) -> giveway_picture::report::Report {
    report(state, Imprint::default()).unwrap()
}

/// A question is asked, answered and closed.
fn asked(state: &State, question: Question) -> State {
    let asked = answered(&after(state, [Action::Ask(AskAction::Ask(question))]));
    after(&asked, [Action::Ask(AskAction::Close)])
}

#[test]
fn delays_are_added_up_for_a_report() {
    let state = corridor();
    assert!(told(&state).robots.iter().all(|row| row.alone.is_none()));
    let begun = after(&state, [ADD_UP]);
    assert!(is_coming(&begun) && begun.phase() == Phase::Counting);
    assert_eq!(saying(&begun), "Adding up who costs whom.");
    let state = answered(&begun);
    assert!(
        !is_coming(&state) && column(&state).is_none(),
        "it is not shown"
    );
    let report = told(&state);
    for row in &report.robots {
        // Alone each robot drives five cells.
        let lone = row.alone.as_ref().unwrap();
        let (alone, delay) = (lone.alone, lone.delay);
        assert_eq!(lone.passes.is_empty(), delay == 0, "{}", row.name);
        assert_eq!((alone, row.arrives), (5, Some(5 + delay)), "{}", row.name);
    }
    assert!(
        report
            .last
            .iter()
            .any(|it| it.ends_with("would arrive at 5.")),
        "{:?}",
        report.last
    );
    // What is known is neither asked again, nor where something else is being done.
    assert!(after(&state, [ADD_UP]).work.is_idle());
    let solving = after(&corridor(), [Action::Solve(SolveAction::Solve), ADD_UP]);
    assert!(!is_coming(&solving));
}

#[test]
fn what_is_not_proved_is_asked_in_full_by_the_ledger() {
    let mut state = corridor();
    let mut answer = (**state.document.answer.as_ref().unwrap()).clone();
    answer.solved.status = Status::Feasible;
    answer.solved.bounds.clear();
    state.document.answer = Some(answer.into());
    let state = answered(&after(&state, [ADD_UP]));
    assert!(told(&state).robots.iter().all(|row| row.alone.is_some()));
    let opened = after(&state, [Action::Ledger(LedgerAction::Show(true))]);
    assert!(opened.is_adding_up(), "its proof is still to come");
}

#[test]
fn delays_are_added_up_beside_an_open_question() {
    let asked = Action::Ask(AskAction::Ask(Question::Makespan));
    let state = answered(&after(&corridor(), [asked]));
    let state = answered(&after(&state, [ADD_UP]));
    assert!(state.document.mode.asking().is_some());
    assert!(told(&state).robots.iter().all(|row| row.alone.is_some()));
}

#[test]
fn questions_asked_before_are_told() {
    let first = Question::Makespan;
    let second = Question::SumOfCosts;
    let state = asked(&asked(&corridor(), first.clone()), second.clone());
    // The same question again has one answer.
    let state = asked(&state, first.clone());
    let report = told(&state);
    let questions: Vec<&str> = report
        .known
        .questions
        .iter()
        .map(|it| it.asked.as_str())
        .collect();
    let words = |question: &Question| crate::words::question(question);
    assert_eq!(questions, [words(&first), words(&second)]);
    for question in &report.known.questions {
        assert!(!question.verdict.is_empty() && question.about.is_none());
    }
    // After an edit the plan is another one: it is said which one was asked about.
    let edit = Edit::SetGoal(2, Cell::new(4, 2));
    let state = answered(&after(
        &after(&state, [Action::Edit(edit)]),
        [Action::Solve(SolveAction::Solve)],
    ));
    let state = after(&state, [Action::Ask(AskAction::Ask(second.clone()))]);
    let report = told(&answered(&state));
    let about: Vec<_> = report
        .known
        .questions
        .iter()
        .map(|it| it.about.as_deref())
        .collect();
    let before = about[0].unwrap();
    assert!(
        before.starts_with("Asked about a plan of the scene before it was edited: "),
        "{before}"
    );
    assert_eq!(
        (about.len(), about[2]),
        (3, None),
        "the open one is of this plan"
    );
}

#[test]
fn what_a_report_tells_is_there_after_a_reload() {
    let state = asked(
        &asked(&corridor(), Question::Makespan),
        Question::SumOfCosts,
    );
    let state = answered(&after(
        &state,
        [
            Action::Ask(AskAction::Close),
            Action::Ledger(LedgerAction::AddUp),
        ],
    ));
    let kept = crate::link::keep(&state);
    let again = crate::link::kept(&kept).unwrap();
    assert_eq!(told(&again), told(&state));
    assert_eq!(told(&again).known.questions.len(), 2);
    assert!(again.document.ledger().is_some());
    assert_eq!(crate::link::keep(&again), kept);
    assert!(!corridor().is_kept_alike(&state));
}
