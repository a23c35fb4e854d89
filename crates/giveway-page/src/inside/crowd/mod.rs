//! Planners of crowds, looked into: PIBT step by step, and the configurations of `LaCAM`.

mod board;
mod lacam;
mod pibt;

use std::rc::Rc;

use giveway_model::{Cell, Plan};

pub(super) use board::{in_lacam, in_pibt};
pub(crate) use lacam::LacamRun;
pub(super) use lacam::column as lacam_column;
pub(crate) use pibt::PibtRun;
pub(super) use pibt::column as pibt_column;

use crate::State;

/// The run of PIBT on the scene on the board.
pub(super) fn pibt(state: &State) -> Option<&PibtRun> {
    told(state.looked()?.pibt.as_ref())
}

/// The run of `LaCAM` on the scene on the board.
pub(super) fn lacam(state: &State) -> Option<&LacamRun> {
    told(state.looked()?.lacam.as_ref())
}

fn told<T>(run: Option<&Result<Rc<T>, String>>) -> Option<&T> {
    run?.as_deref().ok()
}

/// Why nothing is known of a planner, as a sentence.
pub(super) fn failed<T>(run: Option<&Result<T, String>>) -> Option<&String> {
    run?.as_ref().err()
}

/// Where an agent of a plan is at a time; its last cell from its end on.
fn at(plan: &Plan, name: &str, time: u32) -> Option<Cell> {
    let path = plan.path(name);
    path.get(time as usize).or(path.last()).copied().flatten()
}
