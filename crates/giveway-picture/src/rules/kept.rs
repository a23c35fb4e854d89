//! What a rule between robots keeps free at a time: the cells behind each robot, or those around
//! it.

use std::collections::BTreeSet;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, AtGoal, Cell, Constraint, Grid, Plan};

use crate::outline::around;

/// How far an outline stays inside of its cells, in units.
const INSET: i64 = 7;
/// At most so many cells are looked at.
const MOST: usize = 20_000;

/// The cells that are kept free for a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeptShape {
    /// The robot, by its index.
    pub agent: usize,
    /// The outline of the cells.
    pub path: String,
}

/// Where an agent is at a time: its cell, or both ends of the edge on which it is in transit.
/// Nothing where it is gone, or not there yet.
fn places(plan: &Plan, agent: &Agent, at_goal: AtGoal, time: u32) -> Vec<Cell> {
    let path = plan.path(&agent.name);
    let begins = plan.from.get(&agent.name).copied().unwrap_or(0);
    let is_gone = plan
        .until
        .get(&agent.name)
        .is_some_and(|&until| until <= time);
    let Some(place) = time.checked_sub(begins).filter(|_| !is_gone) else {
        return Vec::new();
    };
    let place = place as usize;
    match path.get(place) {
        Some(Some(cell)) => vec![*cell],
        Some(None) => {
            let before = path.get(..place).unwrap_or_default().iter().rev();
            let after = path.get(place..).unwrap_or_default().iter();
            let ends = [before.flatten().next(), after.flatten().next()];
            ends.into_iter().flatten().copied().collect()
        }
        None if at_goal == AtGoal::Stay => path.last().copied().flatten().into_iter().collect(),
        None => Vec::new(),
    }
}

/// What a rule keeps free at a time of a plan; nothing for kinds that keep no cells free.
pub fn kept(
    rule: &Constraint,
    (grid, agents): (&Grid, &[Agent]),
    at_end: impl Fn(&Agent) -> AtGoal,
    (plan, time): (&Plan, u32),
) -> Vec<KeptShape> {
    let mut looked_at = 0;
    let mut shapes = Vec::new();
    for (index, agent) in agents.iter().enumerate() {
        let is_bound = rule.agents.as_ref();
        if !is_bound.is_none_or(|names| names.contains(&agent.name)) || looked_at > MOST {
            continue;
        }
        let at = |time| places(plan, agent, at_end(agent), time);
        let cells: BTreeSet<Cell> = match &rule.kind {
            ConstraintKind::Gap { steps } => {
                let now = at(time);
                let before = (1..=(*steps).min(time)).take(MOST - looked_at.min(MOST));
                // In transit it is at no cell.
                let left = before.map(|by| at(time - by)).filter(|at| at.len() == 1);
                left.flatten().filter(|cell| !now.contains(cell)).collect()
            }
            ConstraintKind::Apart { distance, times } if times.contains(time) => {
                let near = at(time).into_iter();
                near.flat_map(|middle| diamond(grid, middle, *distance))
                    .collect()
            }
            ConstraintKind::Apart { .. }
            | ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => return Vec::new(),
        };
        looked_at += cells.len();
        if !cells.is_empty() {
            let path = around(&cells, INSET);
            shapes.push(KeptShape { agent: index, path });
        }
    }
    shapes
}

/// The cells of a map that are nearer to one than a distance, itself among them.
fn diamond(grid: &Grid, middle: Cell, distance: u32) -> Vec<Cell> {
    let reach = distance.saturating_sub(1);
    let span = |at: u32, reach: u32, size: u32| {
        at.saturating_sub(reach)..=at.saturating_add(reach).min(size.saturating_sub(1))
    };
    let rows = span(middle.y, reach, grid.height());
    let cells = rows.flat_map(|y| {
        let left = reach - y.abs_diff(middle.y);
        span(middle.x, left, grid.width()).map(move |x| Cell::new(x, y))
    });
    cells.take(MOST).collect()
}
