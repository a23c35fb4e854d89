//! What is at a point of the board.

use giveway_model::Cell;

use super::Cast;
use crate::Point;

/// How near to the middle of an agent counts as on it, in cells.
const REACH: f64 = 0.42;

impl Cast {
    /// The agent under a point at a time, which need not be whole: what is
    /// pressed is what is seen there.
    pub fn agent_at(&self, point: Point, time: f64) -> Option<usize> {
        let far = |agent: usize| {
            let pose = self.tracks[agent].pose(time).filter(|pose| !pose.is_gone)?;
            let far = (pose.at.x - point.x).hypot(pose.at.y - point.y);
            (far <= REACH).then_some((far, agent))
        };
        let near = (0..self.tracks.len()).filter_map(far);
        near.min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, agent)| agent)
    }

    /// Whether some agent's goal is on the cell at a point.
    pub fn has_goal_at(&self, point: Point) -> bool {
        let is_at = |side: u32, at: f64| (f64::from(side) - at).abs() < 0.5;
        let is_there = |cell: Cell| is_at(cell.x, point.x) && is_at(cell.y, point.y);
        let there = self.agents.iter().zip(&self.is_there);
        let mut there = there.filter(|(_, is_there)| **is_there);
        there.any(|(agent, _)| agent.goal.is_some_and(is_there))
    }
}
