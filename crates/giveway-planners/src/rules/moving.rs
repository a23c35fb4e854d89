//! Obstacles that move, as things that an agent's task forbids: to be where one is, and to
//! exchange cells with one.

use giveway_model::{Assumption, Cell, condition::Times};

use super::{
    OwnRules,
    alone::{arc, forbid, keep_off},
};
use crate::{
    AgentId,
    single::{Act, Area, Task},
    terrain::{Arc, Terrain},
};

impl OwnRules<'_> {
    /// Makes an agent's task heed the obstacles that move.
    pub(super) fn heed_moving(&self, agent: AgentId, task: &mut Task, terrain: &Terrain) {
        for (path, closed) in self.moving() {
            if !closed {
                for (cell, times) in stays(path) {
                    if let Some(v) = terrain.vertex(cell) {
                        let when = (times, self.rests(agent));
                        keep_off(task, terrain, &Area::One(v), when);
                    }
                }
            }
            for (step, pair) in (0..).zip(path.windows(2)) {
                let [from, to] = *pair else { continue };
                // The agent goes the other way.
                if let Some(Arc { id, slow, .. }) = arc(terrain, to, from) {
                    let times = Times {
                        from: Some(u32::saturating_sub(step, u32::from(slow))),
                        to: Some(step),
                    };
                    forbid(task, Act::Cross(vec![id]), times);
                }
            }
        }
    }

    /// The paths of the obstacles that move, and whether rules close their cells.
    fn moving(&self) -> impl Iterator<Item = (&[Cell], bool)> {
        let all = self.instance.assumptions().iter();
        all.filter_map(|one| match one {
            Assumption::MovingObstacle { path, closed, .. } => Some((path.as_slice(), *closed)),
            Assumption::GoalsChosen
            | Assumption::RuleLeftOut { .. }
            | Assumption::UnknownKey { .. } => None,
        })
    }

    /// The last time at which an obstacle moves.
    pub(super) fn last_time_moving(&self) -> u32 {
        let lengths = self.moving().map(|(path, _)| path.len() as u32);
        lengths.max().unwrap_or(0).saturating_sub(1)
    }
}

/// The cells of a path, each with the times of a stay there; the last stay has no end.
fn stays(path: &[Cell]) -> Vec<(Cell, Times)> {
    let mut stays: Vec<(Cell, Times)> = Vec::new();
    for (time, &cell) in (0..).zip(path) {
        match stays.last_mut() {
            Some((last, _)) if *last == cell => {}
            last => {
                if let Some((_, times)) = last {
                    times.to = u32::checked_sub(time, 1);
                }
                let from = (time > 0).then_some(time);
                stays.push((cell, Times { from, to: None }));
            }
        }
    }
    stays
}
