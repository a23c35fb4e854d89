//! Files as text: the project's own JSON, links, and what readers of JSON and text share.

mod encoding;
mod file_name;
pub mod json;
mod layout;
pub mod link;
pub mod locate;
pub mod native;
pub mod own;
mod phrase;
mod schema;
pub mod text;

pub use crate::object::{ObjectOnly, from_object};
pub use encoding::{Encoding, decode, read_text};
pub use file_name::{base_name, stem};
pub use schema::schema;
