//! At which cell it is asked why a robot lets another go first.

use super::{answered, select};
use crate::ask::offers;
use crate::reduce::tests::after;
use crate::{Action, Draft, PlayAction, SolveAction, State};

/// A robot waits until another has come out of an aisle, drives in to a waypoint and out again.
const SCENE: &str = r#"{ "giveway": 1, "map": ["..........", ".......###"], "agents": [
    { "name": "A", "start": [6, 1], "goal": [5, 0], "waypoints": [[8, 0]] },
    { "name": "B", "start": [9, 0], "goal": [0, 0] }] }"#;

#[test]
fn it_is_where_it_turns_round() {
    let draft = Draft::new(serde_json::from_str(SCENE).unwrap()).unwrap();
    let solve = [Action::Solve(SolveAction::Solve)];
    let state = answered(&after(&State::new(draft), solve));
    let plan = state.document.fresh_answer().unwrap().plan().unwrap();
    let path = plan.path("A");
    let wait = path.windows(2).position(|pair| pair[0] == pair[1]).unwrap();
    let at = [Action::Play(PlayAction::Seek(wait as u32)), select(0)];
    let groups = offers(&after(&state, at));
    let texts: Vec<&str> = groups[0].offers.iter().map(|it| it.text.as_str()).collect();
    // On its way out it passes cells once more that B has left before.
    assert!(
        texts.contains(&"Why does A give way to B at (8, 0)?"),
        "{texts:?}"
    );
}
