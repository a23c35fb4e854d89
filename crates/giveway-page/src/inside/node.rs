//! What the column says of a node of the tree.

use giveway_model::words::and;
use giveway_solve::plan::{NodeFate, ToldConstraint, TreeNode, words};

use super::column::{Button, Choice, Column, Fact, Tint, Verdict};
use super::{InsideAction, TreeRun, index};
use crate::State;

pub(super) fn column(state: &State) -> Option<Column> {
    let tree = match state.looked()?.tree.as_ref()? {
        Ok(tree) => tree,
        Err(why) => return Some(without(why)),
    };
    let node = tree.node(state.inside.node)?;
    let (title, verdict) = verdict(tree, node);
    let facts = constraints(state, tree, node);
    let mut told = Vec::new();
    if !facts.is_empty() {
        told.push(("What holds in this node".to_owned(), facts));
    }
    let choices = branches(state, tree, node);
    let mut remark = None;
    if tree.left_out > 0 {
        let count = giveway_model::words::grouped(tree.left_out);
        remark = Some(format!(
            "{count} more nodes were made; only the first are kept."
        ));
    }
    Some(Column {
        over: over(tree, node),
        title,
        verdict: Some(verdict),
        facts: told,
        choices: (!choices.is_empty()).then(|| ("Its two branches".to_owned(), choices)),
        note: best(tree, node),
        remark,
        foot: foot(tree, node),
        ..Column::default()
    })
}

/// Where there is no tree.
fn without(why: &str) -> Column {
    Column {
        over: "CBS".to_owned(),
        title: "No conflict tree".to_owned(),
        remark: Some(why.to_owned()),
        foot: vec![Button::new(
            "",
            "Try again",
            Some(InsideAction::Again),
            false,
        )],
        ..Column::default()
    }
}

/// `Opened third, of 11 nodes`.
fn over(tree: &TreeRun, node: &TreeNode) -> String {
    let all = tree.nodes.len() as u64 + tree.left_out;
    let all = giveway_model::words::grouped(all);
    match tree.opened.iter().position(|&id| id == node.id) {
        Some(0) => format!("The root, of {all} nodes"),
        Some(turn) => format!("Opened {}, of {all} nodes", nth(turn + 1)),
        None if node.cost.is_none() => format!("Closed at once, of {all} nodes"),
        None => format!("Never opened, of {all} nodes"),
    }
}

/// `third`, `11th`.
fn nth(n: usize) -> String {
    const WORDS: [&str; 10] = [
        "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth",
        "tenth",
    ];
    if let Some(word) = WORDS.get(n.wrapping_sub(1)) {
        return (*word).to_owned();
    }
    let end = match (n % 10, n % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{n}{end}")
}

/// The title, and what the node comes to.
fn verdict(tree: &TreeRun, node: &TreeNode) -> (String, Verdict) {
    let say = |tint: Tint, word: &str, text: String| Verdict {
        tint,
        word: word.to_owned(),
        beside: String::new(),
        text,
    };
    let cost = node.cost.unwrap_or_default();
    match &node.fate {
        NodeFate::Split { conflict, .. } => {
            let branches = tree.children(node.id).iter();
            let asked = branches.filter_map(|&child| tree.node(child)?.constraint.as_ref());
            let branches: Vec<String> = asked.map(words::branch).collect();
            let split = match branches.as_slice() {
                [one, other] => format!(" In one branch {one}; in the other {other}."),
                _ => String::new(),
            };
            let text = format!("{}.{split}", words::conflict(conflict));
            let title = format!("Cost {cost}, and still a conflict");
            (title, say(Tint::Info, "It splits in two", text))
        }
        NodeFate::Best { .. } => (
            format!("Cost {cost}, and no conflict"),
            say(
                Tint::Proved,
                "The best plan",
                format!("Every node that is left costs {cost} or more, so no plan costs less."),
            ),
        ),
        NodeFate::Open => {
            let count = match node.conflicts {
                1 => "1 conflict".to_owned(),
                n => format!("{n} conflicts"),
            };
            let text = "It waits in the list: others cost less, or came first.".to_owned();
            let title = format!("Cost {cost}, {count}");
            (title, say(Tint::Info, "Never opened", text))
        }
        NodeFate::Dead => (
            "No way".to_owned(),
            say(
                Tint::Stuck,
                "A dead end",
                "A robot has no way that keeps all of this.".to_owned(),
            ),
        ),
    }
}

/// What all plans below a node keep, the newest first.
fn constraints(state: &State, tree: &TreeRun, node: &TreeNode) -> Vec<Fact> {
    let line = tree.lineage(node.id);
    let asked = line
        .iter()
        .filter_map(|node| Some((node, node.constraint.as_ref()?)));
    let fact = |(node, constraint): (&&TreeNode, &ToldConstraint)| {
        let parent = node.parent.and_then(|parent| tree.node(parent));
        let who = words::subject(constraint);
        let met = match parent.map(|parent| &parent.fate) {
            Some(NodeFate::Split { conflict, .. }) => {
                let others = words::parties(conflict).iter();
                let others: Vec<&str> = others.map(String::as_str).filter(|o| *o != who).collect();
                and(&others)
            }
            _ => String::new(),
        };
        let keeps_others_away = matches!(
            constraint,
            ToldConstraint::At { .. }
                | ToldConstraint::Along { .. }
                | ToldConstraint::ArriveBy { .. }
        );
        Fact {
            agent: index(state, who),
            text: words::constraint(constraint),
            small: match (met.as_str(), keeps_others_away) {
                ("", _) => String::new(),
                (other, false) => format!("since it would meet {other} there"),
                (other, true) => format!("so that {other} gives way"),
            },
        }
    };
    asked.map(fact).collect()
}

fn branches(state: &State, tree: &TreeRun, node: &TreeNode) -> Vec<Choice> {
    let children = tree.children(node.id).iter();
    let children = children.filter_map(|&child| tree.node(child));
    let branch = |child: &TreeNode| {
        let constraint = child.constraint.as_ref()?;
        let fate = match child.fate {
            _ if tree.leads_to_best(child.id) => "leads to the best plan",
            NodeFate::Open => "never opened",
            NodeFate::Dead => "a dead end",
            NodeFate::Split { .. } | NodeFate::Best { .. } => "opened later",
        };
        let small = match child.cost {
            Some(cost) => format!("cost {cost}, {fate}"),
            None => fate.to_owned(),
        };
        Some(Choice {
            agent: index(state, words::subject(constraint)),
            text: words::branch(constraint),
            small,
            action: InsideAction::Node(child.id),
        })
    };
    children.filter_map(branch).collect()
}

/// How it ended, at the end.
fn best(tree: &TreeRun, node: &TreeNode) -> Option<String> {
    let is_last = matches!(node.fate, NodeFate::Best { .. });
    is_last.then(|| tree.ended.clone())
}

fn foot(tree: &TreeRun, node: &TreeNode) -> Vec<Button> {
    let turn = tree.lineage(node.id);
    let mut opened = turn
        .iter()
        .filter_map(|n| tree.opened.iter().position(|&id| id == n.id));
    let next = opened.next().and_then(|turn| tree.opened.get(turn + 1));
    vec![
        Button::new("back", "Parent", node.parent.map(InsideAction::Node), false),
        Button::new(
            "",
            "Next node opened",
            next.map(|&id| InsideAction::Node(id)),
            true,
        ),
    ]
}
