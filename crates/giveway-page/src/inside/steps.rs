//! The steps of what is looked at: which one is shown, of how many.

use giveway_model::tr;

use super::{Method, crowd, proof};
use crate::State;

/// Where one is among the steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steps {
    /// The step shown, as it stands in large: 3.
    pub at: String,
    /// What it is one of: `of 6 steps`.
    pub of: String,
    /// Whether there is one before it.
    pub has_before: bool,
    /// Whether there is one after it.
    pub has_after: bool,
    /// Whether they follow each other by themselves.
    pub is_playing: bool,
}

/// Where one is; nothing where there is nothing to step through.
pub fn steps(state: &State) -> Option<Steps> {
    let (at, last, of) = place(state)?;
    Some(Steps {
        at: at.to_string(),
        of,
        has_before: at > first(state),
        has_after: at < last,
        is_playing: state.inside.is_playing,
    })
}

const fn first(state: &State) -> usize {
    match state.inside.method {
        Method::Proof | Method::Pibt | Method::Lacam => 0,
        Method::Tree | Method::Orders => 1,
    }
}

/// The number of the step, that of the last one, and what they are.
pub(crate) fn place(state: &State) -> Option<(usize, usize, String)> {
    let inside = &state.inside;
    match inside.method {
        Method::Proof => {
            let (at, last) = proof::chosen(state)?;
            let last_one = u32::try_from(last).unwrap_or(u32::MAX);
            Some((
                at,
                last,
                tr!("behind the number of the step" => "of {n} step" | "of {n} steps" % last_one),
            ))
        }
        // A person goes from node to node by itself.
        Method::Tree if inside.by_hand.is_on => None,
        Method::Tree => {
            let tree = state.looked()?.tree.as_ref()?.as_ref().ok()?;
            let last = tree.opened.len();
            // A node that was never opened stands after the one that it was made by.
            let mut line = tree.lineage(inside.node).into_iter();
            let turn = |id: u64| tree.opened.iter().position(|&opened| opened == id);
            let at = line.find_map(|node| turn(node.id))?;
            Some((at + 1, last, tr!("of {last} opened", last)))
        }
        Method::Orders => {
            let run = state.looked()?.orders.get(inside.order)?;
            let last = run.told.planned.len() + usize::from(run.told.stuck.is_some());
            let at = inside.robots.unwrap_or(last).clamp(1, last.max(1));
            let all = run.told.order.len();
            Some((at, last, tr!("of {all} robots", all)))
        }
        Method::Pibt => {
            let last = crowd::pibt(state)?.steps();
            let n = u32::try_from(last).unwrap_or(u32::MAX);
            let of = tr!("behind the number of the step" => "of {n} step" | "of {n} steps" % n);
            Some((inside.moment.min(last), last, of))
        }
        Method::Lacam => {
            let last = crowd::lacam(state)?.events.len();
            let n = u32::try_from(last).unwrap_or(u32::MAX);
            let of = tr!("behind the number of the step" => "of {n} step" | "of {n} steps" % n);
            Some((inside.moment.min(last), last, of))
        }
    }
}
