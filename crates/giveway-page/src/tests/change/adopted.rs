//! A plan that went on is adopted: its history, later changes, questions.

use giveway_model::{Agent, Cell};

use super::changing;
use crate::changing::{columns, history};
use crate::reduce::tests::{after, stroke};
use crate::table::lanes;
use crate::tests::{adopted, answered, saying, seek};
use crate::{Action, AskAction, ChangeAction, Edit, Phase, SolveAction, Tool};

#[test]
fn the_adopted_plan_has_its_history_and_undo_takes_it_back() {
    let state = adopted();
    assert_eq!(state.phase(), Phase::Planned);
    assert_eq!((state.view.playback.time, state.last_time()), (1, 4));
    let answer = state.document.fresh_answer().unwrap();
    let past = history(answer);
    assert_eq!(past[1].text, "A3 joins at (2, 2)");
    assert_eq!(
        past[1].detail.as_deref(),
        Some("replan: makespan 4, sum of costs 12")
    );
    let names: Vec<String> = lanes(answer, &answer.draft)
        .into_iter()
        .map(|lane| lane.name)
        .collect();
    assert_eq!(names, ["A1", "A2", "A3"]);
    assert!(lanes(answer, &answer.draft)[2].begins == 1);
    assert!(saying(&state).contains("went on by replan: makespan 4"));
    // Before it joins it is not there.
    assert!(state.is_there(2));
    let before = after(&state, [seek(0)]);
    assert!(!before.is_there(2));
    assert_eq!(before.agent_at(Cell::new(2, 2)), None);
    assert_eq!(state.agent_at(Cell::new(2, 2)), Some(2));
    assert!(!crate::ask::offers(&state).is_empty());
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.phase(), Phase::Comparing);
    let redone = after(&undone, [Action::Redo]);
    assert_eq!(redone.document.answer, state.document.answer);
}

#[test]
fn the_world_changes_again_later_and_not_before() {
    let state = adopted();
    assert!(!state.can_change());
    let refused = after(&state, [Action::Change(ChangeAction::Begin)]);
    assert!(refused.document.mode.changing().is_none() && refused.view.notice.is_some());
    let later = after(&state, [seek(2), Action::Change(ChangeAction::Begin)]);
    let joins = Edit::AddAgent(Agent {
        name: "A4".to_owned(),
        start: Cell::new(0, 2),
        goal: Cell::new(0, 0),
        waypoints: Vec::new(),
        battery: None,
    });
    let state = answered(&after(
        &later,
        [Action::Edit(joins), Action::Change(ChangeAction::Adapt)],
    ));
    let columns = columns(&state).unwrap();
    assert!(columns[2].costs[0].after <= columns[0].costs[0].after);
    let state = after(&state, [Action::Change(ChangeAction::Adopt(2))]);
    let course = state
        .document
        .fresh_answer()
        .unwrap()
        .course
        .clone()
        .unwrap();
    assert_eq!(course.times(), [1, 2]);
    assert_eq!(course.changes.changes.len(), 2);
    let solved = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    assert!(solved.document.fresh_answer().unwrap().course.is_none());
    assert_eq!(
        after(&solved, [Action::Undo]).document.answer,
        state.document.answer
    );
}

#[test]
fn an_edit_of_the_scene_makes_the_course_stale() {
    let state = after(&adopted(), stroke(Tool::Obstacle, &[(0, 1)]));
    assert!(state.document.is_stale());
    assert_eq!(state.world(), &state.document.draft);
    assert!(!after(&state, [Action::Undo]).document.is_stale());
}

#[test]
fn a_removed_agent_is_gone_and_its_lane_ends() {
    let state = after(&changing(), stroke(Tool::Erase, &[(2, 1)]));
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let state = after(&state, [Action::Change(ChangeAction::Adopt(0))]);
    let answer = state.document.fresh_answer().unwrap();
    let lane = &lanes(answer, &answer.draft)[1];
    assert_eq!((lane.removed, lane.stays), (Some(1), false));
    assert!(
        lane.sentence().ends_with("is removed at 1"),
        "{}",
        lane.sentence()
    );
    assert!(!state.is_there(1));
    assert!(after(&state, [seek(0)]).is_there(1));
}

#[test]
fn questions_are_answered_of_a_plan_that_went_on() {
    let state = adopted();
    let later = after(&state, [seek(2)]);
    let offers = crate::ask::offers(&later);
    assert!(!offers.is_empty());
    let first = offers[0].offers[0].question.clone();
    let asked = after(&later, [Action::Ask(AskAction::Ask(first))]);
    assert_eq!(asked.phase(), Phase::Asking);
    let told = answered(&asked);
    let asking = told.document.mode.asking().unwrap();
    assert!(asking.told.is_some(), "{:?}", told.view.notice);
    if let Some(other) = &asking.other {
        assert!(other.course.is_some(), "in the same world");
    }
    let past = after(&state, [seek(0)]);
    assert!(crate::ask::offers(&past).is_empty());
    assert!(crate::ask::no_offers(&past).is_some_and(|why| why.contains("before time 1")));
}
