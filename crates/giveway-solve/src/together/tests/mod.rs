//! Agents asked about by themselves: where they can be, where they collide, and whether
//! they can keep their limits.

mod limits;
mod meetings;

use giveway_model::{Cost, Scene, format::native};

use super::{TogetherAnswer, TogetherRequest};
use crate::{Limits, Request, Response, SilentHost, serve, trace::AgentLimit};

const CROSSING: &str = r##"{
    "giveway": 1,
    "map": ["#.#", "...", "#.#"],
    "objective": ["sum-of-costs", "makespan"],
    "agents": [
        { "name": "A", "start": [0, 1], "goal": [2, 1] },
        { "name": "B", "start": [1, 0], "goal": [1, 2] }
    ]
}"##;

/// A lane of two cells between two rooms, passed both ways at once.
const LANE: &str = r#"{
    "giveway": 1,
    "map": [".##.", "....", ".##."],
    "agents": [
        { "name": "A", "start": [0, 1], "goal": [3, 1] },
        { "name": "B", "start": [3, 1], "goal": [0, 1] }
    ]
}"#;

fn scene(text: &str) -> Scene {
    native::read_scene(text).unwrap()
}

fn limit(agent: &str, least: u32, at_most: u32) -> AgentLimit {
    AgentLimit {
        agent: agent.to_owned(),
        least,
        at_most,
    }
}

fn request(scene: &str, cost: Cost, agents: &[AgentLimit]) -> TogetherRequest {
    TogetherRequest {
        scene: self::scene(scene),
        cost,
        agents: agents.to_vec(),
        more: None,
        within: None,
        limits: Limits::default(),
    }
}

fn told(request: TogetherRequest) -> TogetherAnswer {
    match serve(&Request::Together(request), &SilentHost) {
        Response::Together(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn refuted(request: TogetherRequest) -> Option<bool> {
    told(request).alone.unwrap().refuted
}
