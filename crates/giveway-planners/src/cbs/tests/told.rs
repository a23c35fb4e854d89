//! A constraint tree as lines that can be written by hand.

use crate::{
    cbs::{Conflict, ConflictKind, Constraint, Fate, Rule, Tree},
    problem::Problem,
    terrain::Vertex,
};

/// A line a node: `number < parent: constraint: cost, conflicts; fate`.
pub(super) fn told(problem: &Problem, tree: &Tree) -> Vec<String> {
    assert_eq!(tree.left_out, 0);
    let nodes = tree.nodes.iter().map(|node| {
        let parent = node
            .parent
            .map_or(String::new(), |parent| format!(" < {parent}"));
        let constraint = node.constraint;
        let constraint = constraint.map_or("root".to_owned(), |c| asks(problem, c));
        let cost = node.cost.map_or("no walks".to_owned(), |cost| {
            format!("cost {cost}, {} conflicts", node.conflicts)
        });
        let fate = fate(problem, &node.fate);
        format!("{}{parent}: {constraint}: {cost}; {fate}", node.id)
    });
    nodes.collect()
}

fn name(agent: usize) -> char {
    (b'a' + agent as u8) as char
}

fn at(problem: &Problem, v: Vertex) -> String {
    let cell = problem.terrain.cell(v);
    format!("({}, {})", cell.x, cell.y)
}

fn along(problem: &Problem, arc: u32) -> String {
    let (from, to) = problem.terrain.ends(arc);
    format!("{}-{}", at(problem, from), at(problem, to))
}

fn asks(problem: &Problem, Constraint { agent, rule }: Constraint) -> String {
    let agent = name(agent);
    match rule {
        Rule::NotAt { v, time } => format!("{agent} not at {} at {time}", at(problem, v)),
        Rule::At { v, time } => format!("{agent} at {} at {time}", at(problem, v)),
        Rule::NotCross { arc, time } => {
            format!("{agent} not along {} from {time}", along(problem, arc))
        }
        Rule::Cross { arc, time } => format!("{agent} along {} from {time}", along(problem, arc)),
        Rule::ArriveAfter(time) => format!("{agent} arrives after {time}"),
        Rule::ArriveBy(time) => format!("{agent} arrives by {time}"),
    }
}

fn meets(problem: &Problem, conflict: &Conflict) -> String {
    let (a, b) = (name(conflict.first), name(conflict.second));
    match conflict.kind {
        ConflictKind::Vertex { v, time } => format!("{a} and {b} at {} at {time}", at(problem, v)),
        ConflictKind::Swap { arc, time } => {
            format!("{a} and {b} swap {} from {time}", along(problem, arc))
        }
        ConflictKind::Target { v, time } => {
            format!("{b} comes to resting {a} at {} at {time}", at(problem, v))
        }
    }
}

fn fate(problem: &Problem, fate: &Fate) -> String {
    match fate {
        Fate::Open => "open".to_owned(),
        Fate::Dead => "dead".to_owned(),
        Fate::Best { turn, bypassed } => format!("best in turn {turn}, bypassed {bypassed}"),
        Fate::Split {
            turn,
            conflict,
            cardinality,
            bypassed,
        } => {
            let meets = meets(problem, conflict);
            format!("turn {turn}: {cardinality:?} {meets}, bypassed {bypassed}")
        }
    }
}
