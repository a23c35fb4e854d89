//! What the column says of a node of the tree.

use giveway_model::words::Later;
use giveway_model::words::and;
use giveway_model::{tr, tr_later};
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
        told.push((tr!("What holds in this node").to_owned(), facts));
    }
    let choices = branches(state, tree, node);
    let mut remark = None;
    if tree.left_out > 0 {
        let count = giveway_model::words::grouped(tree.left_out);
        remark = Some(tr!(
            "{count} more nodes were made; only the first are kept.",
            count
        ));
    }
    Some(Column {
        over: over(tree, node),
        title,
        verdict: Some(verdict),
        facts: told,
        choices: (!choices.is_empty()).then(|| (tr!("Its two branches").to_owned(), choices)),
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
        title: tr!("No conflict tree").to_owned(),
        remark: Some(why.to_owned()),
        foot: vec![Button::new(
            "",
            tr!("Try again"),
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
        Some(0) => tr!("The root, of {all} nodes", all),
        Some(turn) => tr!("Opened {turn}, of {all} nodes", turn = nth(turn + 1), all),
        None if node.cost.is_none() => tr!("Closed at once, of {all} nodes", all),
        None => tr!("Never opened, of {all} nodes", all),
    }
}

/// `third`, `11th`.
fn nth(n: usize) -> String {
    const WORDS: [Later; 10] = [
        tr_later!("opened" => "first"),
        tr_later!("opened" => "second"),
        tr_later!("opened" => "third"),
        tr_later!("opened" => "fourth"),
        tr_later!("opened" => "fifth"),
        tr_later!("opened" => "sixth"),
        tr_later!("opened" => "seventh"),
        tr_later!("opened" => "eighth"),
        tr_later!("opened" => "ninth"),
        tr_later!("opened" => "tenth"),
    ];
    if let Some(word) = WORDS.get(n.wrapping_sub(1)) {
        return word.text().to_owned();
    }
    let end = match (n % 10, n % 100) {
        (_, 11..=13) => tr!("opened, such as 11th" => "th"),
        (1, _) => tr!("opened, such as 21st" => "st"),
        (2, _) => tr!("opened, such as 22nd" => "nd"),
        (3, _) => tr!("opened, such as 23rd" => "rd"),
        _ => tr!("opened, such as 24th" => "th"),
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
                [one, other] => tr!(" In one branch {one}; in the other {other}.", one, other),
                _ => String::new(),
            };
            let text = format!("{}.{split}", words::conflict(conflict));
            let title = tr!("Cost {cost}, and still a conflict", cost);
            (title, say(Tint::Info, tr!("It splits in two"), text))
        }
        NodeFate::Best { .. } => (
            tr!("Cost {cost}, and no conflict", cost),
            say(
                Tint::Proved,
                tr!("The best plan"),
                tr!(
                    "Every node that is left costs {cost} or more, so no plan costs less.",
                    cost
                ),
            ),
        ),
        NodeFate::Open => {
            let count = tr!("{n} conflict" | "{n} conflicts" % node.conflicts);
            let text = tr!("It waits in the list: others cost less, or came first.").to_owned();
            let title = tr!("Cost {cost}, {count}", cost, count);
            (title, say(Tint::Info, tr!("Never opened"), text))
        }
        NodeFate::Dead => (
            tr!("No way").to_owned(),
            say(
                Tint::Stuck,
                tr!("A dead end"),
                tr!("A robot has no way that keeps all of this.").to_owned(),
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
                (other, false) => tr!("since it would meet {other} there", other),
                (other, true) => tr!("so that {other} gives way", other),
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
            _ if tree.leads_to_best(child.id) => tr!("leads to the best plan"),
            NodeFate::Open => tr!("never opened"),
            NodeFate::Dead => tr!("a dead end"),
            NodeFate::Split { .. } | NodeFate::Best { .. } => tr!("opened later"),
        };
        let small = match child.cost {
            Some(cost) => tr!("cost {cost}, {fate}", cost, fate),
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
        Button::new(
            "back",
            tr!("Parent"),
            node.parent.map(InsideAction::Node),
            false,
        ),
        Button::new(
            "",
            tr!("Next node opened"),
            next.map(|&id| InsideAction::Node(id)),
            true,
        ),
    ]
}
