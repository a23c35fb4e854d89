//! Where the file of a plan writes what is wrong with the scene that is made of it.

use std::collections::BTreeSet;

use crate::{WrittenAt, WrittenPlan};
use giveway_model::format::locate::{Segment, segments};

/// Where the file writes a place of the scene, such as `agents[1].waypoints[0]`: at the cell, or
/// else at the walk of the agent.
pub(super) fn of_place(plan: &WrittenPlan, place: &str) -> WrittenAt {
    let way = segments(place);
    let agent = match way.get(1) {
        Some(&Segment::Index(agent)) => plan.agents.get(agent),
        _ => None,
    };
    let Some(agent) = agent else {
        return WrittenAt::Whole;
    };
    let cell = match (way.get(2), way.get(3)) {
        (Some(Segment::Key(key)), _) if key == "start" => agent.start,
        (Some(Segment::Key(key)), _) if key == "goal" => agent.goal,
        (Some(Segment::Key(_)), Some(&Segment::Index(waypoint))) => {
            // A cell that is written twice is one waypoint.
            let mut seen = BTreeSet::new();
            let cells = agent.waypoints.iter();
            cells
                .filter(|cell| seen.insert(cell.pair))
                .nth(waypoint)
                .copied()
        }
        _ => None,
    };
    cell.map_or(agent.at, |cell| cell.at)
}
