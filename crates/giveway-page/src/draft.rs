//! A scene as it stands on the page.

use giveway_model::format::link;
use giveway_model::{Agent, Cell, Fault, Grid, Instance, Scene, tr};

use crate::problems::{self, Problem};

/// The largest map side that the page takes, in cells.
pub const MAX_SIDE: u32 = link::MAX_SIDE;
/// The largest number of agents that the page takes.
pub const MAX_AGENTS: usize = link::MAX_AGENTS;

/// A scene with what validation says of it; never changed, only replaced.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    scene: Scene,
    grid: Grid,
    instance: Result<Instance, Vec<Fault>>,
    problems: Vec<Problem>,
    is_only_shown: bool,
}

impl Default for Draft {
    /// One free cell and nobody on it.
    fn default() -> Self {
        let grid = Grid::default();
        let scene = Scene {
            map: grid.rows(),
            ..Scene::default()
        };
        Self {
            instance: Instance::new(scene.clone()),
            scene,
            grid,
            problems: Vec::new(),
            is_only_shown: false,
        }
    }
}

impl Draft {
    /// Checks a scene. Faults of agents are kept and told by
    /// [`Draft::instance`], since a person may be in the middle of an edit.
    ///
    /// # Errors
    /// The faults of a scene that cannot be drawn: its map is no rectangle, or
    /// it is beyond the limits of the page.
    pub fn new(scene: Scene) -> Result<Self, Vec<Fault>> {
        let instance = Instance::new(scene.clone());
        let Ok(grid) = Grid::from_rows(&scene.map) else {
            return Err(instance.err().unwrap_or_default());
        };
        let mut faults = Vec::new();
        if grid.width().max(grid.height()) > MAX_SIDE {
            faults.push(Fault::at(
                "map",
                tr!(
                    "a map of {width} x {height} cells",
                    width = grid.width(),
                    height = grid.height()
                ),
                tr!("at most {most} x {most} on the page", most = MAX_SIDE),
            ));
        }
        if scene.agents.len() > MAX_AGENTS {
            faults.push(Fault::at(
                "agents",
                tr!("{n} robot" | "{n} robots" % scene.agents.len()),
                tr!("at most {most} on the page", most = MAX_AGENTS),
            ));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let faults = instance.as_ref().err().map_or(&[][..], Vec::as_slice);
        Ok(Self {
            problems: problems::problems(&scene, &grid, faults),
            scene,
            grid,
            instance,
            is_only_shown: false,
        })
    }

    /// A scene that is only shown: it is part of a world that changes, in which
    /// agents may begin where others began before. Nothing is said against it,
    /// and nothing is solved of it.
    pub(crate) fn shown(scene: Scene, grid: Grid) -> Self {
        Self {
            scene,
            grid,
            instance: Err(Vec::new()),
            problems: Vec::new(),
            is_only_shown: true,
        }
    }

    /// Whether it is part of a world that changes, or of an edit that is not
    /// finished.
    pub(crate) const fn is_only_shown(&self) -> bool {
        self.is_only_shown
    }

    /// The scene as plain data.
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The map.
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The agents, in the order of the scene. Before validation: a cell of
    /// theirs may be off the map.
    pub fn agents(&self) -> &[Agent] {
        &self.scene.agents
    }

    /// The checked instance, or every fault of the scene.
    ///
    /// # Errors
    /// The faults, in the order of the scene.
    pub fn instance(&self) -> Result<&Instance, &[Fault]> {
        self.instance.as_ref().map_err(Vec::as_slice)
    }

    /// What is wrong with the scene, in sentences: faults of it, and what an agent
    /// alone cannot do.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// The nearest cell of the map.
    pub fn clamp(&self, cell: Cell) -> Cell {
        let last = |side: u32| side.saturating_sub(1);
        Cell::new(
            cell.x.min(last(self.grid.width())),
            cell.y.min(last(self.grid.height())),
        )
    }
}
