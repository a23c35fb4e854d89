//! Begun, cut off, gone on with, and ended by whatever else is done.

use std::rc::Rc;

use giveway_solve::freedom::FreedomPart;
use giveway_solve::{Refusal, Request, Response};

use super::{SHOW, act, known, on_the_way, solved, told, told_of};
use crate::freedom::{Chip, FreedomAction, Section, chip, claim, part};
use crate::reduce::tests::{after, stroke};
use crate::tests::{answer, answered, saying, select};
use crate::{
    Action, AskAction, ChangeAction, Draft, Phase, Selection, SolveAction, State, Tool, ViewAction,
    WorkerAction, keys, link,
};

const CANCEL: Action = Action::Solve(SolveAction::Cancel);
const HIDE: Action = act(FreedomAction::Show(false));

fn press(state: &State, name: &str) -> State {
    let key = keys::Key {
        name,
        ..keys::Key::default()
    };
    match keys::command(key, state) {
        Some(keys::Command::Act(action)) => after(state, [action]),
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn it_is_asked_of_the_plan_on_the_board() {
    let state = after(&solved(), [select(1), SHOW]);
    assert_eq!(state.phase(), Phase::Counting);
    assert_eq!(state.view.selection, Selection::Nothing);
    let Some((_, Request::Freedom(request))) = state.work.request() else {
        panic!("{:?}", state.work);
    };
    let answer = state.document.answer.as_ref().unwrap();
    assert_eq!(request.plan.as_ref(), answer.plan());
    assert_eq!(request.parts, []);
    assert_eq!(
        request.limits.seconds,
        Some(f64::from(state.settings.seconds))
    );
    assert_eq!(
        state.history.past().len(),
        solved().history.past().len(),
        "no step"
    );
}

#[test]
fn the_key_lays_it_over_and_takes_it_away() {
    let on = answered(&press(&solved(), "m"));
    assert_eq!(chip(&on), Chip::On);
    let off = press(&on, "M");
    assert_eq!(chip(&off), Chip::Ready);
    assert!(!off.is_laid_over() && !saying(&off).contains("such plans"));
    // What is known need not be asked again.
    let again = press(&off, "m");
    assert_eq!(again.work.request(), None);
    assert!(again.is_laid_over());
    assert_eq!(press(&again, "Escape").document, off.document);
}

#[test]
fn cut_off_it_says_what_is_open_and_goes_on() {
    let begun = after(&solved(), [SHOW]);
    let mut parts = on_the_way(&begun, usize::MAX).into_iter();
    let some = after(&begun, parts.by_ref().take(2));
    assert!(some.is_laid_over());
    let stopped = after(&some, [CANCEL]);
    assert_eq!(stopped.phase(), Phase::Planned);
    let column = told_of(&stopped);
    assert_eq!(
        column.stopped.as_deref(),
        Some("You stopped it. Results may be incomplete.")
    );
    assert_eq!(column.cells, Section::Open);
    // What still comes is dropped.
    let late = parts.next().unwrap();
    assert_eq!(after(&stopped, [late]), stopped);

    let going = after(&stopped, [act(FreedomAction::GoOn)]);
    let Some((_, Request::Freedom(request))) = going.work.request() else {
        panic!("{:?}", going.work);
    };
    assert!(request.parts.contains(&FreedomPart::Critical));
    assert!(!request.parts.contains(&FreedomPart::Backbone), "known");
    assert!(going.is_laid_over(), "what is known stays");
    let done = answered(&going);
    let column = told_of(&done);
    assert_eq!(column.stopped, None);
    assert!(!known(column.cells).rows.is_empty());
    assert_eq!(
        column.lead,
        "11 of 19 steps are the same in every best plan."
    );
    assert_eq!(after(&done, [act(FreedomAction::GoOn)]), done);
}

#[test]
fn cancelled_at_once_it_can_be_gone_on_with() {
    let stopped = after(&solved(), [SHOW, CANCEL]);
    assert_eq!(chip(&stopped), Chip::On);
    assert!(told_of(&stopped).stopped.is_some());
    // What was asked of a robot has an answer, too.
    let robot = part(&after(&stopped, [select(0)])).unwrap();
    assert_eq!(
        robot.facts,
        ["Whether it could be later was not found out."]
    );
    let done = answered(&after(&stopped, [act(FreedomAction::GoOn)]));
    assert!(saying(&done).ends_with("15 such plans."));
}

#[test]
fn taken_away_while_it_runs_nothing_runs() {
    let hidden = after(&solved(), [SHOW, HIDE]);
    assert_eq!(hidden.work.request(), None);
    assert_eq!(chip(&hidden), Chip::Ready);
    assert!(answered(&after(&hidden, [SHOW])).is_laid_over());
}

#[test]
fn an_edit_ends_it_and_undo_brings_back_what_was_known() {
    let running = after(&solved(), [SHOW]);
    let late = answer(&running);
    let edited = after(&running, stroke(Tool::Obstacle, &[(2, 1)]));
    assert_eq!(edited.work.request(), None);
    assert!(!edited.is_laid_over());
    assert_eq!(after(&edited, [late]), edited, "too late");

    let edited = after(&told(), stroke(Tool::Obstacle, &[(2, 1)]));
    assert!(matches!(chip(&edited), Chip::Off(_)));
    let back = after(&edited, [Action::Undo]);
    assert!(back.is_laid_over());
    let again = after(&back, [Action::Redo]);
    assert!(!again.is_laid_over());
}

#[test]
fn a_question_and_changes_of_the_world_cover_it() {
    let asked = after(
        &told(),
        [Action::Ask(AskAction::Ask(
            giveway_model::Question::Makespan,
        ))],
    );
    assert!(!asked.is_laid_over());
    let back = after(&asked, [CANCEL, Action::Ask(AskAction::Close)]);
    assert!(back.is_laid_over());
    // Asked for during a question, that ends.
    let shown = after(&asked, [CANCEL, SHOW]);
    assert!(shown.document.mode.asking().is_none() && shown.is_laid_over());
    let changing = after(&told(), [Action::Change(ChangeAction::Begin)]);
    assert!(!changing.is_laid_over() && matches!(chip(&changing), Chip::Off(_)));
    let back = after(&changing, [Action::Change(ChangeAction::Discard)]);
    assert!(back.is_laid_over());
}

#[test]
fn the_plan_that_differs_most_stands_beside_or_in_place() {
    let state = after(&told(), [act(FreedomAction::ShowOther(true))]);
    let (this, other) = (state.shown().unwrap(), state.beside().unwrap());
    assert!(!Rc::ptr_eq(this, other));
    assert_eq!(this.solved.costs, other.solved.costs);
    assert_ne!(this.plan(), other.plan());
    assert_eq!(claim(&state), Some("as good"));
    let narrow = after(&state, [Action::View(ViewAction::SetWide(false))]);
    assert_eq!(narrow.shown().unwrap().plan(), other.plan());
    assert!(narrow.beside().is_none());
    let one = after(&narrow, [act(FreedomAction::ShowOther(false))]);
    assert_eq!(one.shown().unwrap().plan(), this.plan());
}

#[test]
fn refused_or_broken_off_nothing_is_half_there() {
    let running = after(&solved(), [SHOW]);
    let (job, _) = running.work.request().unwrap();
    let refusal = Refusal::Plan {
        violations: Vec::new(),
    };
    let response = Box::new(Response::Refused(refusal));
    let refused = after(
        &running,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    assert!(refused.view.notice.is_some());
    assert_eq!(chip(&refused), Chip::Ready);
    let crash = WorkerAction::Crash {
        job,
        sentence: "It broke off.".to_owned(),
        had_started: true,
    };
    let crashed = after(&running, [Action::Worker(crash)]);
    assert_eq!(crashed.work.request(), None);
    assert!(told_of(&crashed).stopped.is_some());
}

#[test]
fn what_the_browser_keeps_is_the_scene_with_its_plan() {
    let kept = link::kept(&link::keep(&told())).unwrap();
    assert_eq!(chip(&kept), Chip::Ready);
    let empty = State::new(Draft::default());
    assert!(matches!(chip(&empty), Chip::Off(_)));
}
