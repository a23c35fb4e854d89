//! Whether each link of a text has what it names.

use giveway_model::{Cell, Grid, Scene};

use super::Flaw;
use super::bounds::{Faults, MAX_TIME};
use crate::lesson::{Glossary, Target, Text};

/// What links can name in a step.
pub(super) struct Targets<'a> {
    /// The terms.
    pub(super) glossary: &'a Glossary,
    /// The scene on the board, where there is one.
    pub(super) scene: Option<&'a Scene>,
    /// Names of robots that join later.
    pub(super) joining: Vec<&'a str>,
}

impl Targets<'_> {
    /// Whether there is such a robot.
    pub(super) fn has_robot(&self, name: &str) -> bool {
        let mut agents = self.scene.iter().flat_map(|scene| &scene.agents);
        agents.any(|agent| agent.name == name) || self.joining.contains(&name)
    }

    /// Whether there is such a cell.
    pub(super) fn has_cell(&self, cell: Cell) -> bool {
        self.scene.is_some_and(|scene| is_on(scene, cell))
    }

    /// A paragraph that is not empty, each link with what it names.
    pub(super) fn check(&self, place: &str, text: &Text, faults: &mut Faults) {
        if text.is_empty() {
            faults.add(place, Flaw::NoWords);
        }
        for target in text.targets() {
            match target {
                Target::Robot(name) if !self.has_robot(name) => {
                    faults.add(place, Flaw::LinkedRobot(name.clone()));
                }
                Target::Cell(cell) if !self.has_cell(*cell) => {
                    faults.add(place, Flaw::LinkedCell(*cell));
                }
                Target::Term(term) if self.glossary.get(term).is_none() => {
                    faults.add(place, Flaw::LinkedTerm(term.clone()));
                }
                Target::Time(time) if *time > MAX_TIME => {
                    faults.add(place, Flaw::LinkedTime(*time));
                }
                Target::Robot(_) | Target::Cell(_) | Target::Term(_) | Target::Time(_) => {}
            }
        }
    }
}

/// Whether a cell is on the map of a scene.
pub(super) fn is_on(scene: &Scene, cell: Cell) -> bool {
    Grid::from_rows(&scene.map).is_ok_and(|grid| grid.ground(cell).is_some())
}
