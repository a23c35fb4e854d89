//! Questions: what they contrast a plan with, whether they fit, their words.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod fits;
mod holds;
mod words;

use giveway_model::format::native;
use giveway_model::question::from_words;
use giveway_model::{Instance, Plan, Question};

/// A question as it is typed.
#[track_caller]
fn question(words: &str) -> Question {
    let words: Vec<&str> = words.split(' ').collect();
    from_words(&words).unwrap()
}

/// A slow corridor with a charger at each end, and a lane below it.
fn instance() -> Instance {
    native::read_instance(
        r#"{ "giveway": 1, "map": ["+~~+", "...."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [3, 0], "waypoints": [[1, 0], [2, 0]],
              "battery": { "capacity": 9, "initial": 9 } },
            { "name": "A2", "start": [3, 1], "goal": [0, 1] } ] }"#,
    )
    .unwrap()
}

/// A1 waits two steps, then goes through the corridor; A2 goes along the lane,
/// with a wait.
fn plan() -> Plan {
    native::read_plan(
        r#"{ "giveway": 1, "charges": { "A1": [1] }, "paths": {
            "A1": [[0, 0], [0, 0], [0, 0], [1, 0], null, [2, 0], [3, 0]],
            "A2": [[3, 1], [2, 1], [2, 1], [1, 1], [0, 1]] } }"#,
    )
    .unwrap()
}
