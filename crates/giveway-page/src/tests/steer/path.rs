//! The path of an agent that is led: which steps it takes, and where it may be led.

use giveway_model::{AtGoal, Cell, Scene};

use super::{
    BACK, BEGIN, DOWN, LEFT, RIGHT, UP, WAIT, agent, cells, leading, path, rows, told, warehouse,
};
use crate::reduce::tests::{after, stroke};
use crate::steering::Lead;
use crate::tests::{answered, saying, seek, select};
use crate::{Action, BoardAction, Draft, FileAction, Phase, SolveAction, State, Tool, inspect};

#[test]
fn an_agent_is_led_only_where_there_is_a_plan_of_it() {
    let refused = after(&State::new(Draft::default()), [BEGIN]);
    assert!(refused.document.mode.steering().is_none() && refused.view.notice.is_some());
    let state = rows(AtGoal::Stay);
    assert_eq!(state.can_steer(), None, "nobody is selected");
    assert!(after(&state, [BEGIN]).view.notice.is_some());
    let stale = after(&state, stroke(Tool::Charger, &[(1, 1)]));
    let stale = after(&stale, [select(0)]);
    assert_eq!(stale.can_steer(), None);
    let course = after(&crate::tests::adopted(), [select(0), BEGIN]);
    assert!(course.document.mode.steering().is_none() && course.view.notice.is_some());
    let state = leading(0, 1);
    assert_eq!(state.phase(), Phase::Steering);
    assert!(!state.can_change());
    assert!(
        saying(&state).starts_with("A1 is at (1, 0) at time 1. Lead it"),
        "{}",
        saying(&state)
    );
}

#[test]
fn each_step_is_added_to_the_path_and_time_goes_on() {
    let state = after(&leading(0, 1), [DOWN, WAIT, RIGHT]);
    assert_eq!(
        path(&state, "A1"),
        cells(&[(0, 0), (1, 0), (1, 1), (1, 1), (2, 1)])
    );
    assert_eq!(path(&state, "A2"), path(&rows(AtGoal::Stay), "A2"));
    assert_eq!(state.view.playback.time, 4);
    assert_eq!(state.view.cursor, Cell::new(2, 1));
    assert_eq!(state.agent_at(Cell::new(2, 1)), Some(0));
    let facts = told(&state);
    assert_eq!(facts.place, "A1 is at (2, 1) at time 4");
    assert_eq!(
        facts.to_do,
        ["A1 ends at (2, 1) at time 4, but its goal is (3, 0)."]
    );
    let costs: Vec<_> = facts.rows.iter().map(|row| (row.this, row.other)).collect();
    assert_eq!(costs, [(3, 4), (6, 7), (0, 0), (6, 6), (0, 1)]);
    let lane = inspect::planned(&state, 0).unwrap();
    assert!(!lane.arrives && !lane.stays);
    let before = after(&state, [seek(1), RIGHT]);
    assert_eq!(before.view.playback.time, 5, "a step is added to the end");
    assert_eq!(path(&before, "A1").last(), Some(&Some(Cell::new(3, 1))));
}

#[test]
fn a_move_in_the_slow_zone_takes_two_steps() {
    let state = after(&warehouse(2), [RIGHT]);
    let slow = [Some(Cell::new(2, 0)), None, Some(Cell::new(3, 0))];
    assert_eq!(path(&state, "A1")[2..], slow);
    assert_eq!(state.view.playback.time, 4);
    assert_eq!(
        told(&state).place,
        "A1 is at (3, 0) at time 4, battery 6 of 10"
    );
    let state = after(&state, [BACK]);
    assert_eq!(state.view.playback.time, 2);
    // Led from within the move, it is made first.
    let within = warehouse(3);
    assert_eq!(
        (within.view.playback.time, path(&within, "A1").len()),
        (4, 5)
    );
    assert!(!told(&within).can_go_back);
}

#[test]
fn what_no_agent_can_do_is_refused_and_said() {
    let state = leading(0, 0);
    for (step, why) in [
        (UP, "A1 stays: the map ends there."),
        (LEFT, "A1 stays: the map ends there."),
        (BACK, "There is no step to take back."),
        (Action::Steer(Lead::Charge), "A1 cannot charge at (0, 0)."),
        (
            Action::Board(BoardAction::Press(Cell::new(2, 0))),
            "A1 stays: (2, 0) is not beside it.",
        ),
    ] {
        let refused = after(&state, [step]);
        assert_eq!(path(&refused, "A1"), path(&state, "A1"));
        assert!(saying(&refused).ends_with(why), "{}", saying(&refused));
        assert_eq!(refused.history, state.history);
    }
    let state = after(&state, [DOWN, DOWN]);
    let why = "A1 stays: at (0, 2) there is an obstacle.";
    assert!(saying(&state).ends_with(why), "{}", saying(&state));
}

#[test]
fn other_agents_are_led_in_the_same_plan() {
    let state = after(&leading(0, 1), [DOWN]);
    let other = after(&state, [select(1), seek(1)]);
    assert_eq!(other.can_steer(), Some(1));
    let state = after(&other, [BEGIN, UP]);
    assert_eq!(path(&state, "A1"), cells(&[(0, 0), (1, 0), (1, 1)]));
    assert_eq!(path(&state, "A2"), cells(&[(3, 1), (2, 1), (2, 0)]));
    assert_eq!(told(&state).to_do.len(), 2);
    // The first one again: it goes on where it was led to.
    let again = after(&state, [select(0), BEGIN]);
    assert_eq!(path(&again, "A1"), path(&state, "A1"));
    assert!(told(&again).can_go_back);
    let anew = after(&again, [seek(0), BEGIN]);
    assert_eq!(path(&anew, "A1"), cells(&[(0, 0)]));
    let undone = after(&anew, [Action::Undo]);
    assert_eq!(path(&undone, "A1"), path(&state, "A1"));
}

#[test]
fn one_that_has_arrived_waits_at_its_goal_until_it_is_led() {
    let state = after(&leading(0, 1), [RIGHT, RIGHT, WAIT, WAIT]);
    assert_eq!(state.view.playback.time, 5);
    assert_eq!(path(&state, "A1").len(), 4, "the wait after all is none");
    assert_eq!(told(&state).to_do, [""; 0]);
    assert!(saying(&state).ends_with("All robots do their tasks. Check your plan."));
    let state = after(&state, [LEFT]);
    assert_eq!(path(&state, "A1").len(), 7);
    assert_eq!(path(&state, "A1")[3..6], cells(&[(3, 0), (3, 0), (3, 0)]));
    let gone = after(&rows(AtGoal::Vanish), [select(0), seek(3)]);
    assert_eq!(gone.can_steer(), Some(0), "it is there at its arrival");
    let longer = Scene {
        agents: vec![agent("A1", (0, 0), (1, 0)), agent("A2", (3, 1), (0, 1))],
        ..gone.document.draft.scene().clone()
    };
    let state = after(
        &gone,
        [
            Action::File(FileAction::Open(Box::new(longer))),
            Action::Solve(SolveAction::Solve),
        ],
    );
    let look = [select(0), seek(3)];
    let state = after(&answered(&state), look);
    assert_eq!(state.can_steer(), None, "it has left the map");
}
