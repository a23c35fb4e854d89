//! What a node of the conflict tree says.

use giveway_model::tr;
use giveway_solve::plan::{NodeFate, TreeNode, words};

use super::{Drawn, NodeBox};
use crate::inside::{by_hand, index};

impl Drawn<'_> {
    pub(super) fn node_box(
        &self,
        node: &TreeNode,
        place: (usize, usize),
        has_children: bool,
    ) -> NodeBox {
        let is_chosen = node.id == self.chosen;
        let own = self
            .by_hand
            .and_then(|_| by_hand::lines(node, is_chosen && !by_hand::is_done(self.state)));
        let lines = own.unwrap_or_else(|| lines(node));
        let look = self.by_hand.and_then(|_| by_hand::look(node));
        let class = look.unwrap_or(match node.fate {
            NodeFate::Open => "open",
            NodeFate::Dead => "open dead",
            NodeFate::Split { .. } => "split",
            NodeFate::Best { .. } => "sol",
        });
        let yields = self
            .by_hand
            .and_then(|run| by_hand::above(self.state, run, node));
        let constraint = node.constraint.as_ref();
        let asks = constraint.map(|constraint| format!(", {}", words::constraint(constraint)));
        let cost = node
            .cost
            .map_or("\u{2013}".to_owned(), |cost| cost.to_string());
        // What is seen is what is said, and a little more.
        let said = match lines[0].strip_suffix(':') {
            Some(first) => format!("{first}: {}", lines[1]),
            None => lines.join(", "),
        };
        let what = node
            .cost
            .map_or_else(String::new, |cost| tr!("Cost {cost}: ", cost));
        NodeBox {
            id: node.id,
            at: (0.0, 0.0),
            cost,
            lines,
            agent: yields
                .or_else(|| constraint.and_then(|asked| index(self.state, words::subject(asked)))),
            class,
            is_chosen,
            name: format!("{what}{said}{}", asks.unwrap_or_default()),
            level: 1,
            place,
            is_expanded: (!self.tree.children(node.id).is_empty()).then_some(has_children),
        }
    }
}

/// What a node says, in two lines.
fn lines(node: &TreeNode) -> [String; 2] {
    match &node.fate {
        NodeFate::Split { conflict, .. } => words::conflict_lines(conflict),
        NodeFate::Best { .. } => [
            tr!("No conflict:").to_owned(),
            tr!("the best plan").to_owned(),
        ],
        NodeFate::Dead => [
            tr!("No way:").to_owned(),
            tr!("it cannot be kept").to_owned(),
        ],
        NodeFate::Open => {
            let count = match node.conflicts {
                0 => tr!("No conflict").to_owned(),
                more => tr!("{n} conflict" | "{n} conflicts" % more),
            };
            [count, tr!("never opened").to_owned()]
        }
    }
}
