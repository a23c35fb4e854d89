//! Plans of elsewhere: dropped, judged, compared, kept.

mod brought;
mod conflicts;
mod flow;
mod intake;
mod kept;
mod left_out;

use std::rc::Rc;

use crate::action::IntakeAction;
use crate::audit::Audit;
use crate::files::Opened;
use crate::intake::work;
use crate::{Action, Draft, State, reduce};

/// A hall in which two robots change places.
pub(super) const SCENE: &str = r#"{"giveway": 1, "name": "hall", "map": ["...", "..."],
    "objective": ["sum-of-costs", "makespan"], "agents": [
    {"name": "A1", "start": [0, 0], "goal": [2, 0]},
    {"name": "A2", "start": [2, 0], "goal": [0, 0]}]}"#;

/// Both go straight ahead, and meet.
pub(super) const MEETING: &str = r#"{"giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [2, 0]], "A2": [[2, 0], [1, 0], [0, 0]]}}"#;

/// One makes way, and waits a step more than it need.
pub(super) const LEGAL: &str = r#"{"giveway": 1, "paths": {
    "A1": [[0, 0], [0, 0], [1, 0], [2, 0]],
    "A2": [[2, 0], [2, 1], [1, 1], [0, 1], [0, 0]]}}"#;

/// The best: the other one makes way at once.
pub(super) const BEST: &str = r#"{"giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [2, 0]],
    "A2": [[2, 0], [2, 1], [1, 1], [0, 1], [0, 0]]}}"#;

/// The same two, as another planner writes them: rows first.
pub(super) const LEGAL_PATHS: &str = "Agent 0: (0,0)->(0,0)->(0,1)->(0,2)->\n\
    Agent 1: (0,2)->(1,2)->(1,1)->(1,0)->(0,0)->\n";
pub(super) const BEST_PATHS: &str = "Agent 0: (0,0)->(0,1)->(0,2)->\n\
    Agent 1: (0,2)->(1,2)->(1,1)->(1,0)->(0,0)->\n";

pub(super) fn file(name: &str, text: &str) -> Opened {
    Opened {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    }
}

/// Does all that the reader is to do; none of the page's own files is there.
pub(super) fn read_out(mut state: State) -> State {
    for _ in 0..9 {
        let Some(job) = state.intake.job().cloned() else {
            return state;
        };
        let action = match state.intake.ask() {
            None => IntakeAction::Fetched {
                job: job.id,
                files: Vec::new(),
            },
            Some((_, bytes)) => {
                // What goes over the wire comes out as it was.
                let ask: crate::intake::protocol::Ask = borsh::from_slice(&bytes).unwrap();
                let reply = borsh::to_vec(&work(ask.task)).unwrap();
                IntakeAction::Reply {
                    job: ask.id,
                    reply: Rc::new(borsh::from_slice(&reply).unwrap()),
                }
            }
        };
        state = reduce(&state, Action::Intake(action));
    }
    panic!("the reader never ends");
}

/// The page after files were dropped.
pub(super) fn dropped(state: &State, files: &[(&str, &str)]) -> State {
    let files = files.iter().map(|(name, text)| file(name, text)).collect();
    read_out(reduce(state, Action::Intake(IntakeAction::Read(files))))
}

pub(super) fn fresh() -> State {
    State::new(Draft::default())
}

pub(super) fn audit(state: &State) -> Rc<Audit> {
    Rc::clone(state.audit().expect("a plan of elsewhere"))
}
