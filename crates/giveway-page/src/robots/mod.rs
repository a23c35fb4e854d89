//! The table of the robots: a row each, edited as a spreadsheet is, pasted and copied.
//!
//! What was typed or pasted is checked as a whole ([`given`]). What fits becomes an edit; what
//! does not keeps its text, with its reason and the nearest remedy.

mod battery;
mod fault;
mod filter;
mod given;
mod order;
mod read;
mod rows;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::tr;

use crate::State;

pub use battery::CAPACITY;
pub use fault::Fault;
pub(crate) use given::{Given, Target, take};
pub(crate) use order::{HeldRows, hold, shown};
pub(crate) use read::{Grid, Part, grid};
pub use rows::{Banner, Cell, Row, Table, copied, table};
pub(crate) use rows::{csv, own_text};

/// What a person does with the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RobotsAction {
    /// It stands below the board, or not.
    Show(bool),
    /// The keyboard is at a cell of a row, as it is shown.
    Focus(usize, Column),
    /// A text was typed in a cell of a row, as it is shown.
    Type(usize, Column, String),
    /// A fault gives way to its remedy, by the row as it is shown.
    Remedy(usize, Column),
    /// A table was pasted; from the cell of the keyboard on (`true`), where it has no heads.
    Paste(String, bool),
    /// What fits of it is taken.
    Take,
    /// Nothing of it is.
    Drop,
    /// The rows are sorted by a column, or the other way round.
    Sort(Column),
    /// Only rows that have these words.
    Filter(String),
    /// A row is selected, or not any longer, as it is shown.
    Select(usize),
    /// All rows that are shown are selected, or none.
    SelectAll,
    /// The battery of those that are selected; `None` is unlimited.
    Battery(Option<u32>),
    /// The level at which the batteries of those that are selected begin.
    Level(u32),
    /// Those that are selected come once more, on free cells beside them.
    Duplicate,
    /// Those that are selected go.
    Delete,
}

/// A column of the table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Column {
    /// The name.
    #[default]
    Name,
    /// Where it starts.
    Start,
    /// The cells that it has to visit.
    Waypoints,
    /// Where it goes.
    Goal,
    /// How much its battery holds.
    Battery,
    /// The level that its battery begins with.
    Level,
    /// When it arrives; a result.
    Arrives,
    /// How many steps it waits; a result.
    Waits,
}

impl Column {
    /// All of them, from left to right.
    pub const ALL: [Self; 8] = [
        Self::Name,
        Self::Start,
        Self::Waypoints,
        Self::Goal,
        Self::Battery,
        Self::Level,
        Self::Arrives,
        Self::Waits,
    ];

    /// Its head.
    pub fn name(self) -> &'static str {
        match self {
            Self::Name => tr!("Name"),
            Self::Start => tr!("a column" => "Start"),
            Self::Waypoints => tr!("Waypoints"),
            Self::Goal => tr!("Goal"),
            Self::Battery => tr!("Battery"),
            Self::Level => tr!("At the start"),
            Self::Arrives => tr!("a column" => "Arrives"),
            Self::Waits => tr!("a column" => "Waits"),
        }
    }

    /// Whether it is a result, and not edited.
    pub const fn is_result(self) -> bool {
        matches!(self, Self::Arrives | Self::Waits)
    }
}

/// How the table is shown, and what was typed that could not be.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct RobotsView {
    pub(crate) is_open: bool,
    /// The column that rows are sorted by, and whether the other way round.
    pub(crate) sort: Option<(Column, bool)>,
    pub(crate) filter: String,
    /// The rows of before an edit, which moves none of them.
    pub(crate) held: Option<HeldRows>,
    /// The names of the robots that are selected.
    pub(crate) selected: Rc<BTreeSet<String>>,
    /// The cell of the keyboard: a row as it is shown, and a column.
    pub(crate) at: (usize, Column),
    pub(crate) waiting: Option<Rc<Waiting>>,
}

/// What was typed or pasted, while not all of it fits.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Waiting {
    pub(crate) given: Vec<Given>,
    /// Whether it was pasted: then nothing of it is taken by itself.
    pub(crate) is_pasted: bool,
}

impl State {
    /// Whether the table stands below the board.
    pub fn shows_robots(&self) -> bool {
        self.view.robots.is_open && self.can_place_fleet()
    }

    /// Whether the robots can be edited as a table: the scene itself is on the board.
    pub fn can_show_robots(&self) -> bool {
        self.can_place_fleet()
    }

    /// The robots whose rows are selected, by their indices; none where the table is not shown.
    pub(crate) fn rows_selected(&self) -> Vec<usize> {
        let names = &self.view.robots.selected;
        if names.is_empty() || !self.shows_robots() {
            return Vec::new();
        }
        let agents = self.document.draft.agents().iter().enumerate();
        let selected = agents.filter(|(_, agent)| names.contains(&agent.name));
        selected.map(|(index, _)| index).collect()
    }

    /// Whether a text is a table of robots that can be pasted here.
    pub fn takes_robots(&self, text: &str) -> bool {
        self.can_place_fleet() && read::is_table(text)
    }
}

/// The robot of a row as it is shown, by its index; `None` of one that is to come.
pub(crate) fn whose(state: &State, row: usize) -> Option<usize> {
    let index = shown(state).get(row).copied()?;
    (index < state.document.draft.agents().len()).then_some(index)
}
