//! Lays edits on a scene again.

use giveway_model::{Cell, Grid, Scene, tr};

use super::Edits;

/// Why edits do not fit a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFit {
    /// The scene has no such cell, or it is edited twice.
    Cell(Cell),
    /// The scene has no such robot to be taken away.
    Robot(String),
    /// The scene itself has no map.
    Map,
}

impl NoFit {
    /// It as a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::Cell(cell) => tr!(
                "The file edits {cell}, which this lesson does not have, or which is so already.",
                cell
            ),
            Self::Robot(name) => tr!(
                "The file takes {robot} away, which is not there.",
                robot = name
            ),
            Self::Map => tr!("The scene of this lesson has no map.").to_owned(),
        }
    }
}

impl Edits {
    /// The scene after these edits. Zones and rules lose what is gone, as on the page.
    ///
    /// # Errors
    /// Where they do not fit.
    pub fn of(&self, scene: &Scene) -> Result<Scene, NoFit> {
        if self.is_empty() {
            return Ok(scene.clone());
        }
        let mut edited = scene.clone();
        let mut grid = Grid::from_rows(&scene.map).map_err(|_| NoFit::Map)?;
        for edit in &self.cells {
            if grid.ground(edit.cell).is_none_or(|was| was == edit.ground) {
                return Err(NoFit::Cell(edit.cell));
            }
            grid.set_ground(edit.cell, edit.ground);
        }
        for name in &self.gone {
            let place = edited.agents.iter().position(|agent| agent.name == *name);
            let place = place.ok_or_else(|| NoFit::Robot(name.clone()))?;
            edited.agents.remove(place);
        }
        for robot in &self.robots {
            let mut agents = edited.agents.iter_mut();
            match agents.find(|agent| agent.name == robot.name) {
                Some(agent) => agent.clone_from(robot),
                None => edited.agents.push(robot.clone()),
            }
        }
        edited.map = grid.rows();
        edited.settle_rules(&grid);
        Ok(edited)
    }
}
