//! The order as a graph in the language DOT of Graphviz.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use giveway_model::sorting::set;

use crate::Order;

/// The order in DOT: a box a visit, in a frame for each agent; solid arrows along its way, dashed
/// ones from a move to the one that may begin no earlier, with their slack. Links without slack
/// are bold, those of a rotation go both ways.
pub fn dot(order: &Order) -> String {
    let mut text = "digraph order {\n  rankdir=LR;\n  node [shape=box];\n".to_owned();
    for (number, agent) in order.agents.iter().enumerate() {
        let _ = writeln!(text, "  subgraph cluster_{number} {{");
        let _ = writeln!(text, "    label={};", quoted(&agent.agent));
        for (visit, it) in agent.visits.iter().enumerate() {
            let (x, y) = it.cell.signed();
            let stay = match it.leaves {
                Some(leaves) if leaves > it.arrives => format!("{}-{leaves}", it.arrives),
                Some(_) => it.arrives.to_string(),
                None => format!("{}-", it.arrives),
            };
            let _ = writeln!(
                text,
                "    {} [label=\"({x}, {y})\\n{stay}\"];",
                node(&agent.agent, visit)
            );
        }
        let is_gone = agent.visits.last().is_some_and(|it| it.leaves.is_some());
        let nodes = agent.visits.len() + usize::from(is_gone);
        if is_gone {
            let gone = node(&agent.agent, agent.visits.len());
            let _ = writeln!(text, "    {gone} [label=\"\", shape=point];");
        }
        for visit in 1..nodes {
            let from = node(&agent.agent, visit - 1);
            let to = node(&agent.agent, visit);
            let _ = writeln!(text, "    {from} -> {to};");
        }
        text.push_str("  }\n");
    }
    let rotating: BTreeSet<(&str, u32)> = set(order
        .rotations
        .iter()
        .flat_map(|it| &it.moves)
        .map(|it| (it.agent.as_str(), it.visit)));
    for link in &order.links {
        let leaves = (link.first.agent.as_str(), link.first.visit + 1);
        let comes = (link.second.agent.as_str(), link.second.visit);
        let style = if link.slack == 0 { "bold" } else { "dashed" };
        let both = if rotating.contains(&leaves) && rotating.contains(&comes) {
            ", dir=both"
        } else {
            ""
        };
        let _ = writeln!(
            text,
            "  {} -> {} [style={style}, label=\"{}\"{both}];",
            node(leaves.0, leaves.1 as usize),
            node(comes.0, comes.1 as usize),
            link.slack
        );
    }
    text.push_str("}\n");
    text
}

/// The name of a visit's box.
fn node(agent: &str, visit: usize) -> String {
    quoted(&format!("{agent}/{visit}"))
}

fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{text}\"")
}
