//! What closing each free cell would cost, solved anew.

use std::collections::BTreeMap;

use giveway_model::{Cell, Instance};
use giveway_solve::freedom::{Closed, CriticalCell, FreedomAnswer, Need};

use super::CAP;
use crate::oracle::{Question, Verdict};

/// `None` where the oracle cannot say.
pub(super) fn critical(
    instance: &Instance,
    within: Option<u32>,
    best: &[u32],
    answer: &FreedomAnswer,
) -> Option<Vec<String>> {
    let mut faults = Vec::new();
    let cells = answer.critical.as_ref()?;
    let grid = instance.grid();
    let free = grid.cells().filter(|(_, ground)| ground.is_vertex());
    let free: Vec<Cell> = free.map(|(cell, _)| cell).collect();
    if cells.iter().map(|it| it.cell).collect::<Vec<Cell>>() != free {
        faults.push(format!("not the free cells: {cells:?}"));
    }
    for CriticalCell { cell, closed } in cells {
        let mut scene = instance.to_scene();
        let row = &mut scene.map[cell.y as usize];
        row.replace_range(cell.x as usize..=cell.x as usize, "#");
        let expected = match Instance::new(scene) {
            Err(_) => Verdict::Impossible,
            Ok(instance) => Question {
                instance: &instance,
                within,
                cap: CAP,
            }
            .best(),
        };
        let mut agents = instance.agents().iter();
        let is_needed =
            agents.any(|a| a.start == *cell || a.goal == Some(*cell) || a.waypoints.contains(cell));
        let right = match (closed, expected) {
            (_, Verdict::Capped) => return None,
            (Closed::Impossible { needed, .. }, Verdict::Impossible) => {
                let by: Option<&Need> = needed.as_ref();
                by.is_some() == is_needed
            }
            (Closed::Optimal { costs, deltas, .. }, Verdict::Best(point)) => {
                let objective = instance.objective();
                let each = objective.costs().iter().zip(best).zip(&point.vector);
                let expected =
                    each.map(|((&cost, &before), &now)| (cost, i64::from(now) - i64::from(before)));
                costs.vector(objective) == point.vector
                    && *deltas == expected.collect::<BTreeMap<_, _>>()
            }
            _ => false,
        };
        if !right {
            faults.push(format!("without {cell}: {closed:?}"));
        }
    }
    Some(faults)
}
