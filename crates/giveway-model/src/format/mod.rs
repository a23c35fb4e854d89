//! Files as text: the project's own JSON, and foreign formats.

mod json;
mod layout;
mod locate;
pub mod movingai;
pub mod native;
mod phrase;
mod schema;
mod text;

pub use crate::object::from_object;
pub use schema::schema;
pub use text::read_text;
