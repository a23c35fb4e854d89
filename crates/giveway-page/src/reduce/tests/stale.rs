//! A plan of another scene is never shown as if it were this one's.

use giveway_model::Cell;

use super::{after, stroke};
use crate::board::Cast;
use crate::sample::solved;
use crate::{Action, Edit, Point, State, Tool, inspect, table};

fn lanes(state: &State) -> Vec<String> {
    let answer = state.playing();
    let lanes = answer.map_or_else(Vec::new, |answer| {
        table::lanes(answer, &state.document.draft)
    });
    lanes.into_iter().map(|lane| lane.name).collect()
}

#[test]
fn a_wall_on_a_way_takes_the_lane_of_who_went_there() {
    // A1 goes over (8, 0), where A2 never comes.
    let state = after(&solved(), stroke(Tool::Obstacle, &[(8, 0)]));
    assert!(state.document.is_stale());
    assert_eq!(lanes(&state), ["A2"]);
    let cast = Cast::of(&state);
    let ends = |agent: usize| cast.pose(agent, 99.0).map(|pose| pose.at);
    let start = state.document.draft.agents()[0].start;
    assert_eq!(ends(0).map(Point::nearest_cell), Some(start));
    assert_ne!(ends(1).map(Point::nearest_cell), Some(Cell::new(9, 2)));
    let undone = after(&state, [Action::Undo]);
    assert_eq!(lanes(&undone), ["A1", "A2"]);
}

#[test]
fn another_task_or_another_speed_is_another_plan() {
    let goal = after(&solved(), [Action::Edit(Edit::SetGoal(0, Cell::new(8, 2)))]);
    assert_eq!(lanes(&goal), ["A2"]);
    // Both go over (3, 0), which was slow.
    let faster = after(&solved(), stroke(Tool::SlowZone, &[(3, 0)]));
    assert_eq!(lanes(&faster), [""; 0]);
    let elsewhere = after(&solved(), stroke(Tool::Obstacle, &[(8, 2)]));
    assert_eq!(lanes(&elsewhere).len(), 1);
}

#[test]
fn fewer_robots_have_fewer_lanes_and_keep_their_own() {
    let state = after(&solved(), [Action::Edit(Edit::RemoveAgent(0))]);
    assert_eq!(lanes(&state), ["A2"]);
    let answer = state.playing().unwrap();
    let lane = &table::lanes(answer, &state.document.draft)[0];
    assert_eq!(lane.agent, 0, "by its place in the scene that there is now");
}

#[test]
fn nothing_is_proved_of_a_scene_that_changed() {
    let state = after(&solved(), stroke(Tool::Charger, &[(1, 0)]));
    let whole = inspect::whole(&state);
    assert!(!whole.costs.is_empty());
    assert!(whole.costs.iter().all(|cost| !cost.is_proved()));
}

#[test]
fn a_map_that_was_cleared_has_no_plan() {
    for edit in [Edit::Clear, Edit::Fill(crate::Fill::default())] {
        let state = after(&solved(), [Action::Edit(edit)]);
        assert_eq!((lanes(&state), state.plan()), (Vec::new(), None));
        // A robot of the same name has nothing of the one before.
        let placed = after(&state, stroke(Tool::Agent, &[(0, 0), (9, 2)]));
        assert_eq!(inspect::whole(&placed).costs, []);
        assert!(after(&state, [Action::Undo]).plan().is_some());
    }
}
