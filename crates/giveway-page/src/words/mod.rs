//! What the page says, made apart from how it is known.

pub mod change;
mod costs;
mod status;
mod steering;

pub use costs::{objective, title, values};
pub use giveway_model::question::sentence as question;
pub use giveway_model::words::{count, grouped, name, value};
pub use status::{Badge, Standing, standing};

/// A cell in a sentence: `(3, 1)`.
pub(crate) fn at(cell: giveway_model::Cell) -> String {
    cell.to_string()
}
