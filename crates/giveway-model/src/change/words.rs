//! A change in words.

use super::{ConstraintRef, What};
use crate::{Cell, tr};

impl What {
    /// It as a sentence without its stop, and what else there is to know.
    ///
    /// ```
    /// use giveway_model::change::What;
    /// let delay = What::DelayAgent { agent: "A1".into(), steps: 3 };
    /// assert_eq!(delay.sentence().0, "A1 breaks down for 3 steps");
    /// ```
    pub fn sentence(&self) -> (String, Option<String>) {
        let told = match self {
            Self::AddAgent { agent } => {
                let goal = agent.goal;
                let detail = match (goal, agent.waypoints.as_slice()) {
                    (None, []) => tr!("rests anywhere").to_owned(),
                    (None, waypoints) => tr!(
                        "rests anywhere, by way of {cells}",
                        cells = named(waypoints)
                    ),
                    (Some(goal), []) => tr!("goal {goal}", goal),
                    (Some(goal), waypoints) => tr!(
                        "goal {goal}, by way of {cells}",
                        goal,
                        cells = named(waypoints)
                    ),
                };
                let text = tr!(
                    "{agent} joins at {cell}",
                    agent = agent.name,
                    cell = agent.start
                );
                return (text, Some(detail));
            }
            Self::SetSlow { cells } if cells.len() > 1 => {
                let text = tr!("{n} cell becomes slow" | "{n} cells become slow" % cells.len());
                return (text, Some(named(cells)));
            }
            Self::SetNormal { cells } if cells.len() > 1 => {
                let text = tr!(
                    "{n} cell is no longer slow" | "{n} cells are no longer slow" % cells.len()
                );
                return (text, Some(named(cells)));
            }
            Self::SetSlow { cells } => tr!("{cell} becomes slow", cell = named(cells)),
            Self::SetNormal { cells } => tr!("{cell} is no longer slow", cell = named(cells)),
            Self::RemoveAgent { agent } => tr!("{agent} is removed", agent),
            Self::AddObstacle { cell } => tr!("New obstacle at {cell}", cell = *cell),
            Self::RemoveObstacle { cell } => tr!("Obstacle at {cell} removed", cell = *cell),
            Self::MoveObstacle { from, to } => {
                tr!("Obstacle at {from} moves to {to}", from = *from, to = *to)
            }
            Self::AddCharger { cell } => tr!("New charger at {cell}", cell = *cell),
            Self::RemoveCharger { cell } => tr!("Charger at {cell} removed", cell = *cell),
            Self::SetGoal { agent, cell } => {
                tr!("The goal of {agent} is now {cell}", agent, cell = *cell)
            }
            Self::AddWaypoint { agent, cell } => {
                tr!("{agent} also has to visit {cell}", agent, cell = *cell)
            }
            Self::DropWaypoint { agent, cell } => {
                tr!("{agent} no longer has to visit {cell}", agent, cell = *cell)
            }
            Self::SetBattery { agent, level } => {
                tr!("The battery of {agent} is at {level}", agent, level)
            }
            Self::DelayAgent { agent, steps } => {
                tr!(
                    "{agent} breaks down for {n} step"
                        | "{agent} breaks down for {n} steps" % *steps,
                    agent
                )
            }
            Self::StopAgent { agent } => tr!("{agent} breaks down for good", agent),
            Self::AddConstraint { constraint } => {
                let sentence = constraint.sentence();
                return match &constraint.name {
                    Some(name) => (tr!("New rule '{name}'", name), Some(sentence)),
                    None => (tr!("New rule: {sentence}", sentence), None),
                };
            }
            Self::RemoveConstraint { constraint } => match constraint {
                ConstraintRef::Name(name) => tr!("Rule '{name}' removed", name),
                ConstraintRef::Index(index) => tr!("Rule number {n} removed", n = index),
            },
        };
        (told, None)
    }
}

/// The most cells that are named one by one.
const NAMED: usize = 6;

fn named(cells: &[Cell]) -> String {
    let named: Vec<String> = cells.iter().take(NAMED).map(Cell::to_string).collect();
    match cells.len().saturating_sub(NAMED) {
        0 => named.join(", "),
        more => tr!("{cells} and {more} more", cells = named.join(", "), more),
    }
}
