//! The remarks of a file on its scene: notes, and goals that it leaves open.

use giveway_model::Cell;

/// Remarks on the scene of a file for a person, and the goals that the file leaves open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Remarks {
    /// Remarks for a person, each a sentence.
    pub notes: Vec<String>,
    /// The goals that are open.
    pub open: OpenGoals,
    /// How the goals of the scene were chosen, each a sentence: said where no plan decides.
    pub chosen: Vec<String>,
}

/// Goals that a file leaves open. The scene has some goals that the file allows; the ends of
/// a plan beside it may be others.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum OpenGoals {
    /// All goals are given.
    #[default]
    None,
    /// The goals that each agent may choose from, in the order of the scene.
    Choices(Vec<Vec<Cell>>),
    /// Any agent may serve any order, and agents end anywhere.
    Orders(Orders),
}

/// Orders that any agent may serve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Orders {
    /// The cells of the shelves with each product that is ordered. Where agents only move
    /// (domain M of asprilo), an order is served where one of them ends at such a cell.
    pub shelves: Vec<Vec<Cell>>,
    /// Which product is wanted for which order, and how much where that is said.
    pub lines: Vec<(i32, i32, Option<i32>)>,
}

impl From<Vec<String>> for Remarks {
    fn from(notes: Vec<String>) -> Self {
        Self {
            notes,
            ..Self::default()
        }
    }
}
