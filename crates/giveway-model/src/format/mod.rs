//! Files as text: the project's own JSON, and foreign formats.

pub mod convert;
mod file_name;
pub mod foreign;
mod json;
mod layout;
mod lines;
pub mod link;
mod locate;
mod loss;
pub mod movingai;
pub mod native;
mod phrase;
mod schema;
mod text;

pub use crate::object::{ObjectOnly, from_object};
pub use file_name::{base_name, stem};
pub use loss::{Loss, Part, losses};
pub use schema::schema;
pub use text::read_text;
