//! What closing each free cell costs, by the oracle.

use giveway_model::{Instance, Objective, constraint::ConstraintKind};
use giveway_solve::freedom::{Closed, FreedomAnswer};
use serde_json::Value;

use super::{MOST_STATES, number};
use crate::rules_oracle::{Answer, RuleScene, best};

/// What closing each free cell costs, where the oracle can say.
pub(super) fn critical(
    json: &Value,
    instance: &Instance,
    (within, objective, before): (Option<u32>, &Objective, &[u32]),
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    for it in answer.critical.iter().flatten() {
        let cell = it.cell;
        let mut agents = instance.agents().iter();
        let of_agent =
            agents.any(|a| a.start == cell || a.goal == Some(cell) || a.waypoints.contains(&cell));
        let mut rules = instance.constraints_in_force();
        let of_rule = rules.any(|rule| match &rule.constraint.kind {
            ConstraintKind::Sequence { cells, .. } => cells.contains(&cell),
            ConstraintKind::Visit { cell: at, .. } => *at == cell,
            _ => false,
        });
        let mut json = json.clone();
        let mut row = json["map"][cell.y as usize].as_str().unwrap().to_owned();
        row.replace_range(cell.x as usize..=cell.x as usize, "#");
        json["map"][cell.y as usize] = row.into();
        let expected = if of_agent {
            Answer::Impossible
        } else {
            let scene = RuleScene::read(&json.to_string(), &[]);
            best(&scene, within.map(i64::from), MOST_STATES)
        };
        let right = match (&it.closed, expected) {
            (_, Answer::Capped) => true,
            (Closed::Impossible { needed, .. }, Answer::Impossible) => {
                needed.is_some() == (of_agent || of_rule)
            }
            (Closed::Optimal { costs, deltas, .. }, Answer::Best(vector)) => {
                let vector: Vec<u32> = vector.into_iter().map(number).collect();
                let each = objective.costs().iter().zip(before).zip(&vector);
                let by =
                    each.map(|((&cost, &one), &other)| (cost, i64::from(other) - i64::from(one)));
                costs.vector(objective) == vector && *deltas == by.collect()
            }
            _ => false,
        };
        if !right {
            faults.push(format!("without {cell}: {:?}", it.closed));
        }
    }
    faults
}
