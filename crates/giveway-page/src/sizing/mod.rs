//! How many robots does the floor bear? Robots of one draw, more and more of them, each number
//! solved by itself; charts of what that comes to, and a plan of them on the board.

mod card;
mod chart;
mod run;
mod said;

use std::rc::Rc;

use giveway_model::Cell;

use crate::{Document, Draft, State};

pub use card::{Card, FindingRow, Progress, card};
pub(crate) use card::{doing, looked};
pub use chart::{Chart, Dot, Tick, charts};
pub(crate) use run::SizingRun;
pub use run::table;
pub(crate) use said::Said;
pub use said::{Beside, MOST_ROBOTS, MOST_SECONDS};

/// What a person does with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizingAction {
    /// Opens it below the board, or leaves it.
    Show(bool),
    /// The first number of robots.
    From(u32),
    /// The last number of robots.
    To(u32),
    /// How many more each time.
    By(u32),
    /// Whether half of them go the other way.
    Back(bool),
    /// So many waypoints each, at random beside obstacles.
    Waypoints(u32),
    /// How much a battery holds; `None` is unlimited.
    Battery(Option<u32>),
    /// The level that a battery begins with.
    Level(u32),
    /// The time limit of each solve, in seconds.
    Seconds(u32),
    /// Robots are drawn again.
    DrawAgain,
    /// The floor that is compared; `None`: no other one.
    Beside(Option<Beside>),
    /// The next press on the board is the cell of a charger more, or less.
    Pick(bool),
    /// The cell that was pressed.
    Picked(Cell),
    /// All numbers are solved.
    Solve,
    /// What is being solved is stopped; what is there stays.
    Cancel,
    /// The plan of one of them comes onto the board, by its place; `None`: the own scene again.
    Look(Option<usize>),
    /// The robots that are looked at become those of the scene.
    Take,
}

/// How it is shown, what was said, and what was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SizingView {
    pub(crate) is_open: bool,
    /// The sentence; `None` until it is opened for the first time.
    pub(crate) said: Option<Said>,
    /// Whether the next press on the board is a cell of the sentence.
    pub(crate) is_picking: bool,
    /// What was asked last, and what is known of it.
    pub(crate) run: Option<Rc<SizingRun>>,
    /// The plan that is looked at.
    pub(crate) looked: Option<Looked>,
}

/// A plan of so many robots on the board, in the place of a person's own document.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Looked {
    /// Its place among the numbers of robots.
    pub(crate) place: usize,
    /// The own document, which is put aside meanwhile.
    pub(crate) own: Document,
}

impl State {
    /// Whether the charts stand below the board.
    pub fn shows_sizing(&self) -> bool {
        self.view.sizing.is_open && (self.view.sizing.looked.is_some() || self.can_size())
    }

    /// Whether it can be asked: the scene itself is on the board.
    pub fn can_size(&self) -> bool {
        self.view.sizing.looked.is_some() || self.can_place_fleet()
    }

    /// The document that a person made: the one on the board, or the one that is put aside
    /// while a plan of more robots is looked at.
    pub fn own_document(&self) -> &Document {
        match &self.view.sizing.looked {
            Some(looked) => &looked.own,
            None => &self.document,
        }
    }

    /// What is known of how many robots the floor bears.
    pub(crate) fn sizing(&self) -> Option<&SizingRun> {
        let run = self.view.sizing.run.as_deref();
        run.filter(|run| run.is_of(&self.own_document().draft))
    }

    /// Whether it is being solved.
    pub(crate) fn is_sizing(&self) -> bool {
        matches!(self.work.task(), Some(crate::Task::Sizing(_)))
    }
}

/// The floor without its robots, and without rules that name one.
pub(crate) fn floor(draft: &Draft) -> giveway_model::Scene {
    let mut scene = draft.scene().clone();
    scene.agents.clear();
    scene
        .constraints
        .retain(|rule| rule.named_agents().next().is_none());
    scene
}
