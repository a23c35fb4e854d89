//! Edits of the scene that are made beside the board, as plain data.

use giveway_model::{Battery, Cell, Grid, Ground, Scene};

use crate::MAX_SIDE;

/// The longest name that can be given, in characters.
const LONGEST_NAME: usize = 60;
/// The densest that obstacles are strewn, in percent of the cells.
pub const DENSEST: u32 = 60;

/// An edit of the scene; agents are told by their index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edit {
    /// What the scene is called.
    Name(String),
    /// What an agent is called; an empty name leaves it as it is.
    Rename(usize, String),
    /// The battery of an agent; `None` is unlimited. It begins at most full.
    Battery(usize, Option<Battery>),
    /// Takes a waypoint away.
    RemoveWaypoint(usize, Cell),
    /// Takes an agent away.
    RemoveAgent(usize),
    /// Columns and rows; what no longer is on the map is taken away.
    Resize(u32, u32),
    /// A free map of the same size, and nobody on it.
    Clear,
    /// Obstacles and agents by chance.
    Fill(Fill),
}

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

impl Edit {
    /// Makes the edit.
    pub(crate) fn make(self, scene: &mut Scene) {
        match self {
            Self::Name(name) => scene.name = short(&name),
            Self::Rename(agent, name) => {
                let name = short(&name);
                if let Some(agent) = scene.agents.get_mut(agent)
                    && !name.is_empty()
                {
                    agent.name = name;
                }
            }
            Self::Battery(agent, battery) => {
                if let Some(agent) = scene.agents.get_mut(agent) {
                    agent.battery = battery.map(|battery| Battery {
                        initial: battery.initial.min(battery.capacity),
                        ..battery
                    });
                }
            }
            Self::RemoveWaypoint(agent, cell) => {
                if let Some(agent) = scene.agents.get_mut(agent) {
                    agent.waypoints.retain(|&waypoint| waypoint != cell);
                }
            }
            Self::RemoveAgent(agent) => {
                if agent < scene.agents.len() {
                    scene.agents.remove(agent);
                }
            }
            Self::Resize(width, height) => resize(scene, width, height),
            Self::Clear => {
                for row in &mut scene.map {
                    *row = ".".repeat(row.chars().count());
                }
                scene.agents.clear();
            }
            Self::Fill(fill) => fill.strew(scene),
        }
    }
}

/// A name without blanks around it, and not too long.
fn short(name: &str) -> String {
    name.trim().chars().take(LONGEST_NAME).collect()
}

fn resize(scene: &mut Scene, width: u32, height: u32) {
    let (width, height) = (width.clamp(1, MAX_SIDE), height.clamp(1, MAX_SIDE));
    scene.map.resize(height as usize, String::new());
    for row in &mut scene.map {
        let free = std::iter::repeat('.');
        *row = row.chars().chain(free).take(width as usize).collect();
    }
    let is_on = |cell: &Cell| cell.x < width && cell.y < height;
    scene
        .agents
        .retain(|agent| is_on(&agent.start) && is_on(&agent.goal));
    for agent in &mut scene.agents {
        agent.waypoints.retain(is_on);
    }
}

impl Fill {
    /// Strews obstacles anew, keeping chargers and slow zones, and places agents
    /// anew in the largest part of the map that hangs together.
    fn strew(self, scene: &mut Scene) {
        let mut rng = fastrand::Rng::with_seed(self.seed.into());
        for row in &mut scene.map {
            let strewn = row.chars().map(|letter| {
                let is_hit = rng.u32(0..100) < self.obstacles.min(DENSEST);
                match Ground::from_char(letter) {
                    Some(Ground::Free | Ground::Obstacle) if is_hit => '#',
                    Some(Ground::Obstacle) => '.',
                    _ => letter,
                }
            });
            *row = strewn.collect();
        }
        scene.agents.clear();
        let Ok(grid) = Grid::from_rows(&scene.map) else {
            return;
        };
        let parts = crate::problems::Parts::of(&grid);
        let mut starts = parts.largest(&grid);
        let mut goals = starts.clone();
        rng.shuffle(&mut starts);
        rng.shuffle(&mut goals);
        let pairs = starts.into_iter().zip(goals).take(self.agents as usize);
        for (start, goal) in pairs {
            scene.agents.push(giveway_model::Agent {
                name: crate::things::fresh_name(scene),
                start,
                goal,
                waypoints: Vec::new(),
                battery: None,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Draft, MAX_AGENTS, sample};

    fn after(edit: Edit) -> Scene {
        let mut scene = sample::draft().scene().clone();
        edit.make(&mut scene);
        scene
    }

    #[test]
    fn names_are_trimmed_cut_and_never_empty() {
        assert_eq!(after(Edit::Name("  a b ".into())).name, "a b");
        assert_eq!(after(Edit::Name("x".repeat(99))).name.len(), LONGEST_NAME);
        let renamed = |name: &str| after(Edit::Rename(1, name.into())).agents[1].name.clone();
        assert_eq!(renamed(" Robbie "), "Robbie");
        assert_eq!(renamed("  "), "A2");
        assert_eq!(after(Edit::Rename(7, "x".into())), *sample::draft().scene());
    }

    #[test]
    fn a_battery_begins_at_most_full() {
        let battery = |capacity, initial| Battery { capacity, initial };
        let scene = after(Edit::Battery(0, Some(battery(4, 9))));
        assert_eq!(scene.agents[0].battery, Some(battery(4, 4)));
        assert_eq!(after(Edit::Battery(1, None)).agents[1].battery, None);
    }

    #[test]
    fn a_smaller_map_loses_what_was_outside() {
        let scene = after(Edit::Resize(8, 4));
        assert_eq!(scene.map, ["..~~~~~~", ".##.##.#", "...+..+.", "........"]);
        assert!(scene.agents.is_empty(), "both start or end in column 9");
        let scene = after(Edit::Resize(12, 0));
        assert_eq!(scene.map, ["..~~~~~~...."]);
        let wide = after(Edit::Resize(9999, 9999));
        assert!(Draft::new(wide).is_ok(), "as large as the page takes");
    }

    #[test]
    fn clearing_leaves_the_rules() {
        let scene = after(Edit::Clear);
        assert_eq!(scene.map, ["..........", "..........", ".........."]);
        assert!(scene.agents.is_empty());
        assert_eq!(scene.name, "warehouse");
    }

    #[test]
    fn a_seed_always_gives_the_same_solvable_scene() {
        let fill = Fill {
            obstacles: 30,
            agents: 5,
            seed: 7,
        };
        let scene = after(Edit::Fill(fill));
        assert_eq!(scene, after(Edit::Fill(fill)));
        assert_ne!(scene, after(Edit::Fill(Fill { seed: 8, ..fill })));
        assert_eq!(scene.agents.len(), 5);
        assert!(scene.map[2].contains('+'), "chargers stay");
        let draft = Draft::new(scene).unwrap();
        assert!(draft.instance().is_ok());
        assert_eq!(draft.problems(), []);
    }

    #[test]
    fn there_is_no_room_for_more_agents_than_cells() {
        let fill = Fill {
            obstacles: 0,
            agents: MAX_AGENTS as u32,
            seed: 1,
        };
        assert_eq!(after(Edit::Fill(fill)).agents.len(), 30);
        let dense = after(Edit::Fill(Fill {
            obstacles: 100,
            ..fill
        }));
        assert!(!dense.agents.is_empty(), "some cells are always left");
    }
}
