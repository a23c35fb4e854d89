//! What the page says, made apart from how it is known.

pub mod change;
mod costs;
mod question;
mod status;
mod steering;

pub use costs::{count, grouped, name, objective, title, value, values};
pub use question::{cells, question};
pub use status::{Badge, Standing, standing};
