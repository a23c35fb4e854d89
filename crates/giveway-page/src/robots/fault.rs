//! Why a cell of the table cannot be so.

use giveway_model::{Cell, tr};

use super::Column;

/// Why a cell of the table cannot be so.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Which.
    pub column: Column,
    /// Why.
    pub why: String,
    /// What could stand there instead: how that is offered, and its text.
    pub remedy: Option<(String, String)>,
    /// The cell of the floor that it is about.
    pub place: Option<Cell>,
}

pub(super) fn fault(column: Column, why: &str, remedy: Option<(String, String)>) -> Fault {
    Fault {
        column,
        why: why.to_owned(),
        remedy,
        place: None,
    }
}

pub(super) fn unread(column: Column) -> Fault {
    let why = match column {
        Column::Waypoints => tr!("Cells are written 4, 3; 5, 3."),
        _ => tr!("A cell is written 4, 3."),
    };
    fault(column, why, None)
}
