//! The world changes while the plan of the literature's example runs.

use crate::Task;
use giveway_model::change::What;
use giveway_model::format::native;
use giveway_model::{Agent, Cell, Costs};
use giveway_solve::{Response, SilentHost, serve};

use crate::changing::{Choice, columns, facts, fate, history};
use crate::reduce::tests::{after, stroke};
use crate::sample::proved;
use crate::table::lanes;
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Draft, Edit, Mode, Phase, PlayAction, Selection,
    SolveAction, State, Tool, reduce, words,
};

/// The scene of the example with the paper's plan, at time 1.
fn running() -> State {
    let scene = include_str!("../../../../tests/data/seed/dynamic-3x3.json");
    let plan = include_str!("../../../../tests/data/seed/dynamic-3x3.plan.json");
    let draft = Draft::new(native::read_scene(scene).unwrap()).unwrap();
    let state = reduce(&State::new(draft), Action::Solve(SolveAction::Solve));
    let costs = Costs {
        makespan: 4,
        sum_of_costs: 8,
        charges: 0,
        moves: 8,
        waits: 0,
    };
    let objective = state.document.draft.scene().objective.clone();
    let solved = proved(&objective, costs, native::read_plan(plan).unwrap());
    let response = Box::new(Response::Solved(solved));
    after(
        &state,
        [
            Action::Solve(SolveAction::Respond { job: 1, response }),
            Action::Play(PlayAction::Seek(1)),
        ],
    )
}

/// The same with the world changing.
fn changing() -> State {
    after(&running(), [Action::Change(ChangeAction::Begin)])
}

/// A3 joins as in the paper, by the tool.
fn joined() -> State {
    after(&changing(), stroke(Tool::Agent, &[(2, 2), (1, 0)]))
}

/// The state after the solver answered what it is to do.
fn answered(state: &State) -> State {
    let (run, request) = state.work.request().expect("it works");
    let response = Box::new(serve(&request, &SilentHost));
    after(
        state,
        [Action::Solve(SolveAction::Respond { job: run, response })],
    )
}

pub(crate) fn compared() -> State {
    answered(&after(&joined(), [Action::Change(ChangeAction::Adapt)]))
}

pub(crate) fn adopted() -> State {
    after(&compared(), [Action::Change(ChangeAction::Adopt(2))])
}

fn list(state: &State) -> Vec<String> {
    let list = facts(state).unwrap().list;
    list.into_iter().map(|listed| listed.text).collect()
}

fn saying(state: &State) -> String {
    words::standing(state).sentence
}

#[test]
fn the_world_can_change_only_while_a_plan_runs() {
    let fresh = State::new(Draft::default());
    let refused = after(&fresh, [Action::Change(ChangeAction::Begin)]);
    assert!(refused.document.mode.changing().is_none() && refused.view.notice.is_some());
    let state = changing();
    assert_eq!(state.phase(), Phase::Changing);
    assert!(!state.view.playback.playing);
    assert!(saying(&state).starts_with("The world changes at time 1"));
    assert_eq!(state.last_time(), 1, "what comes later is not known");
    let past = after(
        &state,
        [
            Action::Play(PlayAction::Seek(4)),
            Action::Play(PlayAction::StepBack),
        ],
    );
    assert_eq!(past.view.playback.time, 0);
    let edited = after(&past, stroke(Tool::Obstacle, &[(0, 2)]));
    assert_eq!(edited.view.playback.time, 1, "what changes does so then");
}

#[test]
fn every_tool_lists_a_change() {
    let state = after(&changing(), stroke(Tool::Obstacle, &[(0, 2), (1, 2)]));
    let appear = ["New obstacle at (0, 2)", "New obstacle at (1, 2)"];
    assert_eq!(list(&state), appear);
    let state = after(&state, stroke(Tool::Select, &[(1, 2), (0, 0)]));
    let moved = ["New obstacle at (0, 2)", "New obstacle at (0, 0)"];
    assert_eq!(list(&state), moved);
    let state = after(&state, stroke(Tool::Erase, &[(0, 0)]));
    assert_eq!(list(&state), appear[..1]);
    let state = after(&state, stroke(Tool::Charger, &[(1, 1)]));
    let state = after(&state, stroke(Tool::SlowZone, &[(0, 1), (1, 1)]));
    let slow = facts(&state).unwrap().list.pop().unwrap();
    assert_eq!(slow.text, "2 cells become slow");
    assert_eq!(slow.detail.as_deref(), Some("(0, 1), (1, 1)"));
    let select = [
        Action::Board(BoardAction::PickTool(Tool::Select)),
        Action::Board(BoardAction::Select(Selection::Agent(0))),
    ];
    let state = after(&state, select);
    let state = after(&state, stroke(Tool::Goal, &[(2, 0)]));
    let state = after(&state, stroke(Tool::Waypoint, &[(1, 1)]));
    assert_eq!(
        list(&state)[3..],
        [
            "The goal of A1 is now (2, 0)",
            "A1 also has to visit (1, 1)"
        ]
    );
    let state = after(&state, stroke(Tool::Waypoint, &[(1, 1)]));
    assert_eq!(list(&state).len(), 4, "that one is taken back");
    // A2 is at (2, 1) at time 1.
    let state = after(&state, stroke(Tool::Erase, &[(2, 1)]));
    assert_eq!(list(&state)[4], "A2 is removed");
    assert!(!state.is_there(1));
    assert_eq!(
        state.document.draft,
        running().document.draft,
        "the scene itself is as it was"
    );
    assert!(!state.document.is_stale());
}

#[test]
fn beside_the_board_agents_break_down_and_batteries_go_down() {
    let (delay, longer) = (Edit::Delay(0, 2), Edit::Delay(0, 3));
    let state = after(&changing(), [Action::Edit(delay), Action::Edit(longer)]);
    assert_eq!(list(&state), ["A1 breaks down for 3 steps"]);
    let level = Edit::SetLevel(0, 2);
    let refused = after(&state, [Action::Edit(level)]);
    assert_eq!(list(&refused), list(&state));
    let notice = refused.view.notice.unwrap().sentence;
    assert!(notice.contains("A1, which has no battery"), "{notice}");
}

#[test]
fn what_contradicts_the_world_is_refused_and_nothing_changes() {
    // A1 is at (1, 0) at time 1.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(1, 0)]));
    assert_eq!(list(&state), Vec::<String>::new());
    assert_eq!(
        state.view.notice.unwrap().sentence,
        "This contradicts the world: found an obstacle at (1, 0), where A1 is at time 1, \
         expected a cell that is free then."
    );
    // A stroke over it paints what can be.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(0, 0), (1, 0)]));
    assert_eq!(list(&state), ["New obstacle at (0, 0)"]);
    assert!(state.view.notice.is_some());
}

#[test]
fn the_scene_cannot_be_edited_while_the_world_changes() {
    let state = after(&changing(), [Action::Edit(Edit::BatteryFloor(2))]);
    assert!(state.view.notice.is_some() && !state.document.is_stale());
    assert_eq!(state.document.draft, running().document.draft);
}

#[test]
fn each_change_is_one_step_of_undo_and_can_be_taken_back() {
    let state = joined();
    assert_eq!(list(&state), ["A3 joins at (2, 2)"]);
    assert_eq!(state.view.selection, Selection::Agent(2));
    let state = after(&state, stroke(Tool::Obstacle, &[(0, 2)]));
    let undone = after(&state, [Action::Undo]);
    assert_eq!(list(&undone), ["A3 joins at (2, 2)"]);
    let redone = after(&undone, [Action::Redo]);
    assert_eq!(list(&redone).len(), 2);
    let back = after(&redone, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(list(&back), ["New obstacle at (0, 2)"]);
    assert_eq!(back.view.selection, Selection::Nothing, "A3 is gone");
    let left = after(&back, [Action::Change(ChangeAction::Discard)]);
    assert_eq!(left.phase(), Phase::Planned);
    assert_eq!(list(&after(&left, [Action::Undo])).len(), 1);
    let all = [Action::Undo, Action::Undo, Action::Undo];
    assert!(after(&undone, all).document.mode.changing().is_none());
}

#[test]
fn an_agent_that_has_its_cell_taken_back_loses_what_is_its_own() {
    let state = after(&joined(), stroke(Tool::Waypoint, &[(0, 1)]));
    let Some(What::AddAgent { agent }) = state
        .document
        .mode
        .changing()
        .as_ref()
        .unwrap()
        .list
        .first()
    else {
        panic!("it joins");
    };
    assert_eq!(agent.waypoints, [Cell::new(0, 1)]);
    let state = after(&state, stroke(Tool::Erase, &[(2, 2)]));
    assert_eq!(list(&state), Vec::<String>::new());
}

#[test]
fn a_change_that_another_needs_takes_it_along() {
    let state = after(&changing(), stroke(Tool::Erase, &[(1, 0)]));
    let state = after(&state, stroke(Tool::Obstacle, &[(1, 0)]));
    assert_eq!(list(&state), ["A1 is removed", "New obstacle at (1, 0)"]);
    let state = after(&state, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(list(&state), Vec::<String>::new());
    assert!(state.view.notice.is_some());
}

#[test]
fn the_methods_answer_side_by_side() {
    let state = after(&joined(), [Action::Change(ChangeAction::Adapt)]);
    assert_eq!(state.phase(), Phase::Adapting);
    let Some(Task::Change(run)) = state.work.task() else {
        panic!("{:?}", state.work);
    };
    assert_eq!(run.request.since, Some(1));
    let state = answered(&state);
    assert_eq!(state.phase(), Phase::Comparing);
    let columns = columns(&state).unwrap();
    let titles: Vec<&str> = columns.iter().map(|column| column.title.as_str()).collect();
    assert_eq!(titles, ["Revise", "Tunnel 1", "Replan"]);
    let replan = &columns[2];
    assert_eq!(
        (replan.costs[0].before, replan.costs[0].after),
        (Some(4), 4)
    );
    assert_eq!(replan.costs[0].difference().as_deref(), Some("same"));
    assert!(replan.is_least);
    assert_eq!(replan.groups[3].agents, [(2, "A3".to_owned())]);
    let chosen = columns.iter().position(|column| column.is_chosen);
    assert_eq!(chosen, Some(0), "the closest of the best");
    let said = saying(&state);
    assert!(said.starts_with("At time 1: "), "{said}");
    assert_eq!(state.last_time(), 4);
    let other = after(
        &state,
        [
            Action::Change(ChangeAction::Preview(2)),
            Action::Play(PlayAction::Seek(4)),
        ],
    );
    assert_eq!(other.view.playback.time, 4);
    assert_eq!(fate(&other, "A3").as_deref(), Some("joins at 1"));
    assert_eq!(fate(&other, "A1").as_deref(), Some("kept"));
    // A further change makes the answers old.
    let more = after(&state, stroke(Tool::Charger, &[(0, 2)]));
    assert_eq!(more.phase(), Phase::Changing);
    assert_eq!(list(&more).len(), 2);
}

#[test]
fn only_the_methods_chosen_are_asked_and_one_at_least() {
    let choice = Choice {
        revise: false,
        tunnel: false,
        ..Choice::default()
    };
    let state = after(
        &joined(),
        [
            Action::Change(ChangeAction::ChooseMethods(choice)),
            Action::Change(ChangeAction::Adapt),
        ],
    );
    let state = answered(&state);
    assert_eq!(columns(&state).unwrap().len(), 1);
    let none = Choice {
        replan: false,
        ..choice
    };
    let state = after(&state, [Action::Change(ChangeAction::ChooseMethods(none))]);
    assert_eq!(state.settings.methods, choice);
}

#[test]
fn it_is_cancelled_at_once_and_a_late_answer_is_ignored() {
    let state = after(&joined(), [Action::Change(ChangeAction::Adapt)]);
    let (run, request) = state.work.request().unwrap();
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(state.phase(), Phase::Changing);
    assert_eq!(list(&state).len(), 1);
    let response = Box::new(serve(&request, &SilentHost));
    let late = after(
        &state,
        [Action::Solve(SolveAction::Respond { job: run, response })],
    );
    assert_eq!(late, state);
}

#[test]
fn nothing_is_asked_of_an_empty_list() {
    let state = after(&changing(), [Action::Change(ChangeAction::Adapt)]);
    assert!(state.work.is_idle());
    assert!(state.view.notice.is_some());
}

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
    let before = after(&state, [Action::Play(PlayAction::Seek(0))]);
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
    let later = after(
        &state,
        [
            Action::Play(PlayAction::Seek(2)),
            Action::Change(ChangeAction::Begin),
        ],
    );
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
    assert!(after(&state, [Action::Play(PlayAction::Seek(0))]).is_there(1));
}

#[test]
fn an_obstacle_on_a_path_frees_its_agent_and_says_why() {
    // A1 goes on over (2, 0).
    let state = after(&changing(), stroke(Tool::Obstacle, &[(2, 0)]));
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let columns = columns(&state).unwrap();
    let freed = columns[0]
        .groups
        .iter()
        .find(|group| group.title == "Freed");
    assert_eq!(freed.unwrap().agents, [(0, "A1".to_owned())]);
    assert!(
        columns[0].notes[0].contains("obstacle at (2, 0)"),
        "{:?}",
        columns[0].notes
    );
    let world = after(&state, [Action::Play(PlayAction::Seek(1))]);
    assert!(!world.world().grid().is_vertex(Cell::new(2, 0)));
    let before = after(&state, [Action::Play(PlayAction::Seek(0))]);
    assert!(before.world().grid().is_vertex(Cell::new(2, 0)));
}

#[test]
fn where_no_method_has_a_plan_nothing_can_be_adopted_and_the_cause_is_told() {
    // The goal of A1 is walled in, and no way of it leads there.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(2, 2)]));
    let asked = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    assert_eq!(asked.phase(), Phase::Asking, "why, and what would help");
    let state = answered(&asked);
    let columns = columns(&state).unwrap();
    assert!(
        columns
            .iter()
            .all(|column| !column.has_plan() && !column.is_least)
    );
    assert!(columns[2].notes[0].contains("(2, 2), where there is an obstacle now"));
    assert_eq!(state.last_time(), 1);
    assert!(
        saying(&state).ends_with("have no plan."),
        "{}",
        saying(&state)
    );
    assert_eq!(
        after(&state, [Action::Change(ChangeAction::Adopt(0))]),
        state
    );
}

#[test]
fn where_no_method_has_a_plan_a_repair_makes_one() {
    // The goal of A2 is walled in.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(1, 2)]));
    let state = after(&state, stroke(Tool::Obstacle, &[(0, 1)]));
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let state = answered(&state);
    assert!(
        matches!(state.document.mode, Mode::Stuck(..)),
        "{:?} {:?}",
        state.view.notice,
        state.phase()
    );
    let told = state.document.mode.asking().unwrap().told.clone().unwrap();
    assert!(!told.repairs.is_empty(), "{told:?}");
    let again = after(&state, [Action::Ask(AskAction::TakeRepair(0))]);
    assert_eq!(again.phase(), Phase::Adapting);
    let compared = answered(&again);
    assert_eq!(compared.phase(), Phase::Comparing);
    assert!(
        compared
            .document
            .mode
            .comparing()
            .unwrap()
            .preview()
            .is_some()
    );
    let undone = after(&again, [Action::Undo]);
    assert_eq!(
        undone.document.mode, state.document.mode,
        "the answer is still there"
    );
}

#[test]
fn questions_are_answered_of_a_plan_that_went_on() {
    let state = adopted();
    let later = after(&state, [Action::Play(PlayAction::Seek(2))]);
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
    let past = after(&state, [Action::Play(PlayAction::Seek(0))]);
    assert!(crate::ask::offers(&past).is_empty());
    assert!(crate::ask::no_offers(&past).is_some_and(|why| why.contains("before time 1")));
}
