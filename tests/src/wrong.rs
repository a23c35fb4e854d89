//! The cases of `data/wrong`: answers that were wrong once.

use std::path::PathBuf;

use giveway_model::question::from_words;
use giveway_model::{Instance, Plan, format::native};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest};
use giveway_solve::{Limits, Request, Response, SilentHost, serve};

/// The place of a case.
pub fn path(name: &str) -> PathBuf {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    root.join("data/wrong").join(name)
}

/// The text of a file of a case.
pub fn text(name: &str) -> String {
    let path = path(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The instance of a file.
pub fn instance(name: &str) -> Instance {
    native::read_instance(&text(name)).unwrap_or_else(|faults| panic!("{name}: {faults:?}"))
}

/// The plan of a file.
pub fn plan(name: &str) -> Plan {
    native::read_plan(&text(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

/// The answer to a question, in words as they are typed.
pub fn explain(
    instance: &Instance,
    plan: Option<Plan>,
    question: &str,
    within: Option<u32>,
    limits: Limits,
) -> ExplainAnswer {
    let words: Vec<&str> = question.split(' ').collect();
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan,
        question: from_words(&words).unwrap_or_else(|error| panic!("{question}: {error}")),
        objective: None,
        within,
        changes: None,
        at: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits,
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{question}: {other:?}"),
    }
}
