//! Plans through the door: how they end, what is claimed, what is told.

mod by_hand;
mod ends;
mod traces;

use giveway_model::format::native;
use serde_json::Value;

use super::{PlanAnswer, PlanRequest, Planner, words};
use crate::{Host, Request, Response, SilentHost, serve};

const CROSSING: &str = r##"{
    "giveway": 1,
    "map": ["#.#", "...", "#.#"],
    "objective": ["sum-of-costs", "makespan"],
    "agents": [
        { "name": "A", "start": [0, 1], "goal": [2, 1] },
        { "name": "B", "start": [1, 0], "goal": [1, 2] }
    ]
}"##;

const SWAP: &str = r#"{
    "giveway": 1,
    "map": ["..."],
    "agents": [
        { "name": "A", "start": [0, 0], "goal": [2, 0] },
        { "name": "B", "start": [2, 0], "goal": [0, 0] }
    ]
}"#;

fn request(scene: &str, planner: Planner) -> PlanRequest {
    PlanRequest::new(native::read_scene(scene).unwrap(), planner)
}

fn planned_by(request: PlanRequest, host: &dyn Host) -> PlanAnswer {
    match serve(&Request::Plan(request), host) {
        Response::Planned(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn planned(request: PlanRequest) -> PlanAnswer {
    planned_by(request, &SilentHost)
}

fn said(answer: &PlanAnswer) -> String {
    let notes = words::notes(answer).join(" ");
    format!("{} {notes}", words::headline(answer))
        .trim()
        .to_owned()
}

fn trace(scene: &str, planner: Planner) -> Value {
    let answer = planned(PlanRequest {
        trace: true,
        ..request(scene, planner)
    });
    serde_json::to_value(answer.trace).unwrap()
}
