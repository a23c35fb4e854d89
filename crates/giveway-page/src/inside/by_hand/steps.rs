//! The splits so far, each with what it gave and what the planner would have split there.

use giveway_model::tr;
use giveway_solve::plan::{NodeFate, SplitMade, ToldConflict, words};

use super::HandRun;
use crate::State;

/// A split that was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepRow {
    /// The cost of the node.
    pub cost: String,
    /// What was split: `A1 and A3 swap, on A1`.
    pub text: String,
    /// What it gave.
    pub gave: String,
    /// What the planner would have split there.
    pub planner: String,
}

/// The splits, the first of them first.
pub(super) fn rows(run: &HandRun) -> Vec<StepRow> {
    run.splits
        .iter()
        .filter_map(|made| row(run, made))
        .collect()
}

fn row(run: &HandRun, made: &SplitMade) -> Option<StepRow> {
    let node = run.tree.node(made.node)?;
    let NodeFate::Split { conflict, .. } = &node.fate else {
        return None;
    };
    let [one, other] = gives(run, made)?;
    let [rule_one, rule_other] = made
        .rule
        .branches
        .each_ref()
        .map(|branch| branch_cost(branch.cost, branch.conflicts));
    Some(StepRow {
        cost: node.cost?.to_string(),
        text: split(conflict, &made.agent),
        gave: tr!("a split" => "gave {one} and {other}", one, other),
        planner: if made.is_rule {
            tr!("The planner splits the same here.").to_owned()
        } else {
            tr!(
                "Planner: {split}, gives {one} and {other}",
                split = split(&made.rule.conflict, &made.rule.agent),
                one = rule_one,
                other = rule_other
            )
        },
    })
}

/// `A1 and A3 swap, on A1`
fn split(conflict: &ToldConflict, agent: &str) -> String {
    let [met, _] = words::conflict_lines(conflict);
    tr!("{met}, on {agent}", met, agent)
}

/// What both branches came to.
fn gives(run: &HandRun, made: &SplitMade) -> Option<[String; 2]> {
    let [one, other] = made.branches.map(|branch| {
        let node = run.tree.node(branch)?;
        Some(branch_cost(node.cost, node.conflicts))
    });
    Some([one?, other?])
}

/// `14`, `18 without a conflict`, `a dead end`.
fn branch_cost(cost: Option<u32>, conflicts: u64) -> String {
    match (cost, conflicts) {
        (None, _) => tr!("a dead end").to_owned(),
        (Some(cost), 0) => tr!("{cost} without a conflict", cost),
        (Some(cost), _) => cost.to_string(),
    }
}

/// The last split, for those who listen: `A1 and A2 meet, on A2, gives 18 and 16.`
pub(crate) fn said(state: &State) -> Option<String> {
    let run = state.hand_run()?;
    let made = run.splits.last()?;
    let NodeFate::Split { conflict, .. } = &run.tree.node(made.node)?.fate else {
        return None;
    };
    let [one, other] = gives(run, made)?;
    let split = split(conflict, &made.agent);
    let number = run.splits.len();
    Some(tr!(
        "Split {number}: {split}, gives {one} and {other}.",
        number,
        split,
        one,
        other
    ))
}
