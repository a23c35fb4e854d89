//! Rules of a scene when one of its cells becomes an obstacle.

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Scene, Zone};

/// Whether a rule wants an agent at this very cell.
pub(super) fn must_be_at(rule: &Constraint, cell: Cell) -> bool {
    match &rule.kind {
        ConstraintKind::Sequence { cells, .. } => cells.contains(&cell),
        ConstraintKind::Visit { cell: at, .. } => *at == cell,
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => false,
    }
}

/// Makes the rules of a scene say nothing at a cell that is an obstacle now: the same plans
/// keep them. (Where one wants an agent there, no plan does, and it is left out.)
pub(super) fn without_rules_at(scene: &mut Scene, cell: Cell) {
    let rules = std::mem::take(&mut scene.constraints);
    for rule in rules {
        match &rule.kind {
            ConstraintKind::OneWay { lane } if lane.contains(&cell) => {
                let parts = lane.split(|&at| at == cell).filter(|part| part.len() > 1);
                scene.constraints.extend(parts.map(|part| Constraint {
                    kind: ConstraintKind::OneWay {
                        lane: part.to_vec(),
                    },
                    agents: rule.agents.clone(),
                    name: None,
                    off: rule.off,
                }));
            }
            ConstraintKind::Before { second, .. } if second.cell == cell => {}
            // The first is never there, so the second must not be.
            ConstraintKind::Before { first, second } if first.cell == cell => {
                let zone = unused(scene);
                scene.zones.push(Zone::of(&*zone, vec![second.cell]));
                scene.constraints.push(Constraint {
                    kind: ConstraintKind::Closed {
                        zone,
                        times: Times::default(),
                    },
                    agents: Some(vec![second.agent.clone()]),
                    name: None,
                    off: rule.off,
                });
            }
            ConstraintKind::Sequence { .. } | ConstraintKind::Visit { .. }
                if must_be_at(&rule, cell) => {}
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => scene.constraints.push(rule),
        }
    }
}

/// A name that no zone has.
fn unused(scene: &Scene) -> String {
    let is_free = |name: &String| scene.zones.iter().all(|zone| zone.name != *name);
    let mut names = (0..=scene.zones.len()).map(|number| format!("closed {number}"));
    names.find(is_free).unwrap_or_default()
}
