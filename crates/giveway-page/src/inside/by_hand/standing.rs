//! How far a search by hand is, in a sentence.

use giveway_model::tr;
use giveway_model::words::{name, values};
use giveway_solve::plan::{NodeFate, TreeNode};

use super::HandRun;
use crate::State;
use crate::words::{Badge, Standing as Status};

/// How far it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    /// No branch is a plan yet; the least cost of an open one.
    NotYet { least_open: u32 },
    /// A branch is a plan, and an open one costs less.
    Found { cost: u32, least_open: u32 },
    /// No open branch costs less than the plan.
    Proved { cost: u32 },
    /// No open branch costs less than the plan; but the claim is not made, since the scene has
    /// assumptions.
    Assumed { cost: u32 },
    /// All branches are dead ends.
    Exhausted,
}

/// How far it is; `None` while nothing is known.
pub(crate) fn standing(state: &State) -> Option<Standing> {
    state.hand_run().map(of)
}

pub(super) fn of(run: &HandRun) -> Standing {
    let nodes = &run.tree.nodes;
    let least =
        |nodes: &mut dyn Iterator<Item = &TreeNode>| nodes.filter_map(|node| node.cost).min();
    let open = least(&mut nodes.iter().filter(|node| is_open(node)));
    let plan = least(&mut nodes.iter().filter(|node| is_plan(node)));
    match (plan, open) {
        (Some(cost), Some(least_open)) if least_open < cost => Standing::Found { cost, least_open },
        (Some(cost), _) if run.proved.is_some() => Standing::Proved { cost },
        (Some(cost), _) => Standing::Assumed { cost },
        (None, Some(least_open)) => Standing::NotYet { least_open },
        (None, None) => Standing::Exhausted,
    }
}

/// Whether a node can be split.
pub(super) fn is_open(node: &TreeNode) -> bool {
    node.conflicts > 0 && matches!(node.fate, NodeFate::Open) && node.cost.is_some()
}

/// Whether a node is a plan.
pub(super) fn is_plan(node: &TreeNode) -> bool {
    let is_left = matches!(node.fate, NodeFate::Open | NodeFate::Best { .. });
    node.conflicts == 0 && is_left && node.cost.is_some()
}

/// The badge and the sentence of the page.
#[inline(never)]
pub fn status(state: &State) -> Option<Status> {
    let run = state.hand_run()?;
    let told = |badge, sentence| Some(Status::new(badge, sentence));
    let by_hand = |sentence| told(Badge::ByHand, sentence);
    match of(run) {
        Standing::NotYet { least_open } => by_hand(tr!(
            "No plan yet. The cheapest open branch costs {least_open}, so no plan costs less.",
            least_open
        )),
        Standing::Found { cost, least_open } => by_hand(tr!(
            "A plan of {cost} is found. A branch of {least_open} is still open, so it may not be the best.",
            cost,
            least_open
        )),
        Standing::Assumed { cost } => by_hand(tr!(
            "A plan of {cost} is found, and no open branch costs less. What was assumed of the scene keeps that from being a proof.",
            cost
        )),
        Standing::Exhausted => by_hand(match run.exhausted {
            Some(within) => tr!(
                "Every branch is a dead end: there is no plan of makespan at most {within}.",
                within
            ),
            None => tr!("Every branch is a dead end.").to_owned(),
        }),
        Standing::Proved { cost } => {
            let sentence = tr!(
                "Optimal: {costs}. Found and proved by hand.",
                costs = counted(state, run, cost)
            );
            told(Badge::Proved, sentence + &within(run))
        }
    }
}

/// `sum of costs 18`
pub(super) fn counted(state: &State, run: &HandRun, cost: u32) -> String {
    let objective = &state.document.draft.scene().objective;
    let costs = objective.costs().get(..1);
    match (costs, run.costs) {
        (Some(costs), Some(known)) => values(costs, &known),
        _ => match objective.costs().first() {
            Some(&first) => format!("{} {cost}", name(first)),
            None => cost.to_string(),
        },
    }
}

/// How far the claim reaches, where it does not reach for ever.
fn within(run: &HandRun) -> String {
    match run.proved.and_then(giveway_solve::Reach::within) {
        Some(within) => tr!(
            " That holds for plans of makespan at most {within}.",
            within
        ),
        None => String::new(),
    }
}

/// Whether a plan is proved by hand.
pub fn is_done(state: &State) -> bool {
    matches!(standing(state), Some(Standing::Proved { .. }))
}

/// Whether there is something to take back.
pub fn has_splits(state: &State) -> bool {
    !state.inside.by_hand.splits.is_empty()
}

/// What the dock says: how many nodes, and how many splits.
#[inline(never)]
pub fn dock(state: &State) -> Option<(String, String)> {
    let run = state.hand_run()?;
    let nodes = run.tree.nodes.len();
    let splits = run.splits.len();
    let of = tr!("behind the number of nodes" => "node" | "nodes" % nodes);
    let splits = tr!("{n} split" | "{n} splits" % splits);
    Some((nodes.to_string(), format!("{of}, {splits}")))
}
