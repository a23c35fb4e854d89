//! A scene while it is edited: changed in place, not validated yet.

use giveway_model::{Cell, Grid, Ground, Scene, tr};

use crate::Draft;

/// A scene while it is edited: its map as a grid, the rest as in a scene without
/// rows. A
/// stroke over a large map changes a cell at a time, so nothing here looks at the
/// whole map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sketch {
    pub(super) scene: Scene,
    pub(super) grid: Grid,
}

impl Sketch {
    /// The scene of a draft, to be edited.
    pub(crate) fn of(draft: &Draft) -> Self {
        let mut scene = draft.scene().clone();
        // The grid has them; a stroke copies the sketch with every cell.
        scene.map = Vec::new();
        Self {
            scene,
            grid: draft.grid().clone(),
        }
    }

    /// The scene as it stands.
    pub(crate) fn into_scene(self) -> Scene {
        let mut scene = Scene {
            map: self.grid.rows(),
            ..self.scene
        };
        scene.settle_rules(&self.grid);
        scene
    }

    /// The scene to be looked at while the edit is not finished: nothing is said
    /// against it.
    pub(crate) fn shown(&self) -> Draft {
        Draft::shown(self.clone().into_scene(), self.grid.clone())
    }

    pub(super) fn ground(&self, cell: Cell) -> Option<Ground> {
        self.grid.ground(cell)
    }

    /// The name of the agent that needs a cell free: as its start, its goal or a
    /// waypoint; with which of these it is.
    pub(super) fn needed_by(&self, cell: Cell) -> Option<(&str, &'static str)> {
        self.scene.agents.iter().find_map(|agent| {
            let why = if agent.start == cell {
                tr!("a robot" => "starts")
            } else if agent.goal == Some(cell) {
                tr!("a robot" => "has its goal")
            } else if agent.waypoints.contains(&cell) {
                tr!("a robot" => "has a waypoint")
            } else {
                return None;
            };
            Some((agent.name.as_str(), why))
        })
    }
}
