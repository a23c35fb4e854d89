//! What is laid over the plan, for the legend: only what is there.

use giveway_solve::freedom::Hold;

use super::{lines, numbers};
use crate::State;
use crate::board::Kind;

/// The signs that are there.
pub(crate) fn signs(state: &State) -> Vec<Kind> {
    let lines = lines(state);
    let told = state.freedom().and_then(|freedom| freedom.told.as_deref());
    let slacks = told.and_then(|told| told.slack.as_ref());
    let mut slacks = slacks.into_iter().flat_map(|slacks| slacks.values());
    let signs = [
        (Kind::Must, lines.iter().any(|line| !line.must.is_empty())),
        (Kind::Only, lines.iter().any(|line| !line.only.is_empty())),
        (Kind::May, lines.iter().any(|line| !line.may.is_empty())),
        (Kind::Unsure, lines.iter().any(|line| !line.open.is_empty())),
        (Kind::Price, !numbers(state).is_empty()),
        (
            Kind::Late,
            slacks.any(|slack| !matches!(slack.late(), None | Some(Hold::Steps(0)))),
        ),
    ];
    let signs = signs.into_iter().filter(|sign| sign.1);
    signs.map(|sign| sign.0).collect()
}
