//! A plan that went on is adopted: its history, later changes, questions.

use giveway_model::{Agent, Cell};

use giveway_solve::plan::Planner;

use super::{changing, running};
use crate::changing::{columns, history};
use crate::inside::{self, InsideAction};
use crate::planners::{self, By};
use crate::reduce::tests::{after, stroke};
use crate::table::lanes;
use crate::tests::{adopted, answered, saying, seek};
use crate::{Action, AskAction, ChangeAction, Edit, Phase, SolveAction, State, Tool};

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
        Some("“New times”, “Near the old paths” and “Everything new”: makespan 4, sum of costs 12")
    );
    let names: Vec<String> = lanes(answer, &answer.draft)
        .into_iter()
        .map(|lane| lane.name)
        .collect();
    assert_eq!(names, ["A1", "A2", "A3"]);
    assert!(lanes(answer, &answer.draft)[2].begins == 1);
    assert!(saying(&state).contains("and “Everything new”: makespan 4"));
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
fn all_methods_that_found_the_adopted_plan_are_named() {
    // A robot breaks down where nobody comes: all go on as they were.
    let state = after(&running(), [Action::Change(ChangeAction::BreakDown(1))]);
    let compared = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let columns = columns(&compared).unwrap();
    let shared = columns.iter().find(|column| column.titles.len() > 1);
    let shared = shared.expect("several methods find one plan");
    let adopted = after(
        &compared,
        [Action::Change(ChangeAction::Adopt(shared.index))],
    );
    let told = history(adopted.document.fresh_answer().unwrap());
    let detail = told[1].detail.clone().unwrap();
    for title in &shared.titles {
        assert!(saying(&adopted).contains(title), "{}", saying(&adopted));
        assert!(detail.contains(title), "{detail}");
    }
    // The browser keeps it.
    let kept = crate::link::kept(&crate::link::keep(&adopted)).unwrap();
    assert_eq!(saying(&kept), saying(&adopted));
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
        goal: Some(Cell::new(0, 0)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    });
    let state = answered(&after(
        &later,
        [Action::Edit(joins), Action::Change(ChangeAction::Adapt)],
    ));
    let columns = columns(&state).unwrap();
    let free = columns.last().unwrap();
    assert!(free.costs[0].after <= columns[0].costs[0].after);
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
}

#[test]
fn no_plan_from_time_0_takes_the_place_of_one_that_went_on() {
    let state = adopted();
    let all = [
        SolveAction::Plan(Planner::Cbs),
        SolveAction::Plan(Planner::Lacam),
        SolveAction::ShowPlan(By::Search),
        SolveAction::ShowPoint(0),
    ];
    for action in all {
        let after = after(&state, [Action::Solve(action.clone())]);
        assert!(after.work.is_idle(), "{action:?}");
        assert_eq!(after.document, state.document, "{action:?}");
        if matches!(action, SolveAction::Plan(_)) {
            let notice = after.view.notice.unwrap().sentence();
            assert!(notice.contains("change at time 1"), "{notice}");
        }
    }
}

#[test]
fn nothing_of_the_plan_before_is_told_of_the_adopted_one() {
    // The search, a planner and what must be so have told of the plan before.
    let solve = |state: &State, action| answered(&after(state, [Action::Solve(action)]));
    let solved = solve(&running(), SolveAction::Solve);
    let known = solve(
        &solve(&solved, SolveAction::Plan(Planner::Cbs)),
        SolveAction::Solve,
    );
    assert!(planners::table(&known).is_some());
    let open = |state: &State| after(state, [Action::Inside(InsideAction::Show(true))]);
    assert!(inside::record(&open(&known)).is_some());
    let changing = after(&known, [seek(1), Action::Change(ChangeAction::Begin)]);
    let joined = after(&changing, stroke(Tool::Agent, &[(2, 2), (1, 0)]));
    let compared = answered(&after(&joined, [Action::Change(ChangeAction::Adapt)]));
    let state = after(&compared, [Action::Change(ChangeAction::Adopt(2))]);
    assert!(planners::table(&state).is_none());
    assert!(state.document.front().is_none() && state.document.report().is_none());
    assert!(state.document.freedom().is_none());
    let inside = open(&state);
    assert!(inside.is_inside());
    assert_eq!(inside::record(&inside), None);
    assert_eq!(inside::nothing(&inside).title, "No record of this plan");
    for method in [inside::Method::Tree, inside::Method::Orders] {
        let other = after(&inside, [Action::Inside(InsideAction::By(method))]);
        assert!(other.work.is_idle(), "the scene before is not asked about");
        assert_eq!(inside::nothing(&other).title, "Nothing to look into");
    }
    let back = after(&state, [Action::Undo]);
    assert!(planners::table(&after(&back, [Action::Undo, Action::Undo, Action::Undo])).is_some());
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
