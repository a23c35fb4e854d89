//! Where the file of a plan writes what is wrong with the scene that is made of it.

use std::collections::BTreeSet;

use crate::format::foreign::{WrittenAt, WrittenPlan};
use crate::format::locate::{Segment, segments};

/// The at of a place of the scene, such as `agents[1].waypoints[0]`: where the cell
/// is told, else where the agent's walk is.
pub(super) fn of_place(plan: &WrittenPlan, place: &str) -> WrittenAt {
    let way = segments(place);
    let agent = match way.get(1) {
        Some(&Segment::Index(agent)) => plan.agents.get(agent),
        _ => None,
    };
    let Some(agent) = agent else {
        return WrittenAt::Whole;
    };
    let told = match (way.get(2), way.get(3)) {
        (Some(Segment::Key(key)), _) if key == "start" => agent.start,
        (Some(Segment::Key(key)), _) if key == "goal" => agent.goal,
        (Some(Segment::Key(_)), Some(&Segment::Index(waypoint))) => {
            // A cell that is told again is one waypoint.
            let mut seen = BTreeSet::new();
            let told = agent.waypoints.iter();
            told.filter(|told| seen.insert(told.pair))
                .nth(waypoint)
                .copied()
        }
        _ => None,
    };
    told.map_or(agent.at, |told| told.at)
}
