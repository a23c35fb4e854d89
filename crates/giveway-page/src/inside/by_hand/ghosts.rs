//! The tree by hand: what its nodes say, and the branches that a split would make.

use giveway_model::tr;
use giveway_solve::plan::{NodeFate, ToldBranch, ToldConstraint, TreeNode, words};

use super::HandRun;
use super::column::left;
use super::standing::{is_done, is_plan};
use crate::State;
use crate::inside::index;

/// The two lines of a node that was not split; `None` where it says what it says in any tree.
pub(crate) fn lines(node: &TreeNode, is_chosen: bool) -> Option<[String; 2]> {
    match node.fate {
        NodeFate::Open if is_plan(node) => {
            Some([tr!("No conflict:").to_owned(), tr!("a plan").to_owned()])
        }
        NodeFate::Open => {
            let count = tr!("{n} conflict" | "{n} conflicts" % node.conflicts);
            Some(if is_chosen {
                [tr!("a node" => "you choose").to_owned(), count]
            } else {
                [count, tr!("a node" => "open").to_owned()]
            })
        }
        NodeFate::Split { .. } | NodeFate::Dead | NodeFate::Best { .. } => None,
    }
}

/// The class of a node in the style sheet, where it is another one than in the planner's tree.
pub(crate) fn look(node: &TreeNode) -> Option<&'static str> {
    let is_found = matches!(node.fate, NodeFate::Open) && is_plan(node);
    is_found.then_some("found")
}

/// A branch that a split would make.
pub(crate) struct Ghost {
    /// Its cost; a dash where a robot has no way.
    pub(crate) cost: String,
    /// What it says.
    pub(crate) lines: [String; 2],
    /// Who gives way in it, by the index.
    pub(crate) agent: Option<usize>,
    /// Whether it is a dead end.
    pub(crate) is_dead: bool,
}

/// The branches that the split of the chosen node would make.
pub(crate) fn sprout(state: &State, node: u64) -> Vec<Ghost> {
    if is_done(state) {
        return Vec::new();
    }
    let hand = &state.inside.by_hand;
    let choice = state
        .hand_run()
        .filter(|run| run.asked.node == node)
        .and_then(|run| run.choice(hand.conflict));
    let Some(choice) = choice else {
        return Vec::new();
    };
    let parties = words::parties(&choice.conflict);
    let own = choice.branches.get(hand.robot).into_iter().flatten();
    let ghost = |branch: &ToldBranch| {
        let yields = yields(&branch.constraint, parties);
        Ghost {
            cost: branch
                .cost
                .map_or("\u{2013}".to_owned(), |cost| cost.to_string()),
            lines: [
                if keeps_others_away(&branch.constraint) {
                    tr!("others give way").to_owned()
                } else {
                    tr!("{agent} gives way", agent = yields)
                },
                left(branch.cost, branch.conflicts),
            ],
            agent: index(state, yields),
            is_dead: branch.cost.is_none(),
        }
    };
    own.map(ghost).collect()
}

/// The robot that stands on the left edge of a node: who gives way in it.
pub(crate) fn above(state: &State, run: &HandRun, node: &TreeNode) -> Option<usize> {
    let parent = run.tree.node(node.parent?)?;
    let NodeFate::Split { conflict, .. } = &parent.fate else {
        return None;
    };
    let yields = yields(node.constraint.as_ref()?, words::parties(conflict));
    index(state, yields)
}

/// Which of two robots gives way by a constraint.
fn yields<'a>(constraint: &'a ToldConstraint, parties: &'a [String; 2]) -> &'a str {
    let own = words::subject(constraint);
    if !keeps_others_away(constraint) {
        return own;
    }
    let mut others = parties.iter().filter(|party| *party != own);
    others.next().map_or(own, String::as_str)
}

const fn keeps_others_away(constraint: &ToldConstraint) -> bool {
    match constraint {
        ToldConstraint::At { .. }
        | ToldConstraint::Along { .. }
        | ToldConstraint::ArriveBy { .. } => true,
        ToldConstraint::NotAt { .. }
        | ToldConstraint::NotAlong { .. }
        | ToldConstraint::ArriveAfter { .. } => false,
    }
}
