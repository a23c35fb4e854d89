//! A scene by chance.

use giveway_model::parts::Parts;
use giveway_model::{Agent, Ground};

use super::{Sketch, fresh_name};

/// The densest that obstacles are strewn, in percent of the cells.
pub const DENSEST: u32 = 60;

/// What is strewn by chance: the same numbers always give the same scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fill {
    /// Obstacles in so many percent of the cells.
    pub obstacles: u32,
    /// Agents, as far as there is room for all in one part of the map.
    pub agents: u32,
    /// The seed.
    pub seed: u32,
}

impl Default for Fill {
    fn default() -> Self {
        Self {
            obstacles: 20,
            agents: 4,
            seed: 1,
        }
    }
}

impl Fill {
    /// Strews obstacles anew, keeping chargers and slow zones, and places agents
    /// anew in the largest part of the map that hangs together.
    pub(super) fn strew(self, sketch: &mut Sketch) {
        let mut rng = fastrand::Rng::with_seed(self.seed.into());
        let cells: Vec<_> = sketch.grid.cells().collect();
        for (cell, ground) in cells {
            let is_hit = rng.u32(0..100) < self.obstacles.min(DENSEST);
            let ground = match ground {
                Ground::Free | Ground::Obstacle if is_hit => Ground::Obstacle,
                Ground::Obstacle => Ground::Free,
                other => other,
            };
            sketch.grid.set_ground(cell, ground);
        }
        sketch.scene.agents.clear();
        let parts = Parts::of(&sketch.grid);
        let mut starts = parts.largest(&sketch.grid);
        let mut goals = starts.clone();
        rng.shuffle(&mut starts);
        rng.shuffle(&mut goals);
        let pairs = starts.into_iter().zip(goals).take(self.agents as usize);
        for (start, goal) in pairs {
            let name = fresh_name(&sketch.scene);
            sketch.scene.agents.push(Agent {
                name,
                start,
                goal: Some(goal),
                waypoints: Vec::new(),
                battery: None,
                heading: None,
            });
        }
    }
}
