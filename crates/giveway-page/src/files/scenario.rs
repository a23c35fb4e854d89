//! A MovingAI map with a scenario: some hundred agents to choose from.

use giveway_formats::movingai::{self, Scenario};
use giveway_model::{Fault, Grid, Scene, tr};

use super::{Opened, Reading, faulty, stem};
use crate::{MAX_AGENTS, Notice};

/// The number of agents that is proposed, where there are so many.
const PROPOSED: usize = 20;

/// A map and a scenario, and the question how many of its agents are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    file: String,
    grid: Grid,
    scenario: Scenario,
}

pub(super) fn read(map: (&Opened, &str), scenario: (&Opened, &str)) -> Result<Reading, Notice> {
    let grid = movingai::read_map(map.1).map_err(|fault| faulty(&map.0.name, &[fault]))?;
    on(grid, scenario)
}

/// A scenario on a map that is there already.
pub(super) fn on(grid: Grid, scenario: (&Opened, &str)) -> Result<Reading, Notice> {
    let file = scenario.0.name.clone();
    let scenario = movingai::read_scenario(scenario.1).map_err(|fault| faulty(&file, &[fault]))?;
    if scenario.routes.is_empty() {
        let fault = Fault::at(
            "",
            tr!("a scenario without robots"),
            tr!("a line for each robot"),
        );
        return Err(faulty(&file, &[fault]));
    }
    let choice = Choice {
        file,
        grid,
        scenario,
    };
    // A map of another size is told now, not after the question.
    choice.scene(1)?;
    Ok(Reading::Scenario(Box::new(choice)))
}

impl Choice {
    /// The scenario's file name.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The most agents that can be asked for, at least 1.
    pub fn most(&self) -> usize {
        self.scenario.routes.len().min(MAX_AGENTS)
    }

    /// The number that is proposed.
    pub fn proposed(&self) -> usize {
        self.most().min(PROPOSED)
    }

    /// The scene of the first agents.
    ///
    /// # Errors
    /// When there are not so many, or they do not fit the map or each other.
    pub fn scene(&self, agents: usize) -> Result<Scene, Notice> {
        movingai::to_scene(stem(&self.file), &self.grid, &self.scenario, Some(agents))
            .map_err(|fault| faulty(&self.file, &[fault]))
    }
}
