//! What the page says, made apart from how it is known.

pub mod change;
mod costs;
mod question;
mod status;
mod steering;

pub use costs::{count, grouped, name, objective, title, value, values};
pub use question::question;

pub use status::{Badge, Standing, standing};

/// A cell in a sentence: `(3, 1)`.
pub(crate) fn at(cell: giveway_model::Cell) -> String {
    cell.to_string()
}
