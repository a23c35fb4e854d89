//! Lanes, and the tags of deadlines, starts and stops.

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Cell, Constraint, tr};

use super::{LaneShape, RuleShapes, RuledMap, TagShape};

/// Puts the lane or the tags of a rule on the board.
pub(super) fn place(
    map: RuledMap<'_>,
    rule: &Constraint,
    [is_lit, is_broken]: [bool; 2],
    shapes: &mut RuleShapes,
) {
    let bound = || {
        let names = rule.agents.as_deref();
        let agents = map.agents.iter();
        agents.filter(move |agent| names.is_none_or(|names| names.contains(&agent.name)))
    };
    let tag = |cell, text: String, class, is_above| TagShape {
        cell,
        text,
        class,
        is_above,
        is_broken,
    };
    match &rule.kind {
        ConstraintKind::OneWay { lane } => shapes.lanes.push(LaneShape {
            borders: lane.windows(2).filter_map(border).collect(),
            is_lit,
            is_broken,
        }),
        ConstraintKind::Arrive { times } => {
            let Some((text, class)) = arrival(*times) else {
                return;
            };
            let goals = bound().filter_map(|agent| agent.goal);
            shapes
                .tags
                .extend(goals.map(|goal| tag(goal, text.clone(), class, false)));
        }
        ConstraintKind::Late { by, .. } => {
            let text = tr!("a tag on the board" => "by {time}", time = by);
            let goals = bound().filter_map(|agent| agent.goal);
            shapes
                .tags
                .extend(goals.map(|goal| tag(goal, text.clone(), "late", false)));
        }
        ConstraintKind::Depart { from } => {
            let text = tr!("a tag on the board" => "from {time}", time = from);
            let starts = bound().map(|agent| agent.start);
            shapes
                .tags
                .extend(starts.map(|start| tag(start, text.clone(), "early", false)));
        }
        ConstraintKind::Sequence { cells, .. } => {
            let numbered = cells.iter().zip(1_u32..);
            shapes
                .tags
                .extend(numbered.map(|(&cell, n)| tag(cell, n.to_string(), "order", true)));
        }
        ConstraintKind::Visit { cell, stay, .. } => {
            let text = tr!("a tag on the board" => "stay {steps}", steps = stay);
            shapes.tags.push(tag(*cell, text, "stay", true));
        }
        ConstraintKind::Before { first, second } if is_lit => {
            shapes.tags.extend([
                tag(first.cell, "1".to_owned(), "order", true),
                tag(second.cell, "2".to_owned(), "order", false),
            ]);
        }
        // Zones have signs; the others show nothing on the map.
        ConstraintKind::Before { .. }
        | ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => {}
    }
}

fn arrival(times: Times) -> Option<(String, &'static str)> {
    match (times.from, meant(times).to) {
        (Some(from), Some(by)) => Some((format!("{from}\u{2013}{by}"), "late")),
        (None, Some(by)) => Some((tr!("a tag on the board" => "by {time}", time = by), "late")),
        (Some(from), None) => Some((
            tr!("a tag on the board" => "from {time}", time = from),
            "early",
        )),
        (None, None) => None,
    }
}

/// The middle of the border between two cells, and the direction over it.
fn border(step: &[Cell]) -> Option<(u32, u32, u32)> {
    let [from, to] = step else { return None };
    let degrees = match (to.x.cmp(&from.x), to.y.cmp(&from.y)) {
        (std::cmp::Ordering::Greater, _) => 0,
        (_, std::cmp::Ordering::Greater) => 90,
        (std::cmp::Ordering::Less, _) => 180,
        (_, _) => 270,
    };
    let middle = |a: u32, b: u32| 50 * (a + b + 1);
    Some((middle(from.x, to.x), middle(from.y, to.y), degrees))
}
