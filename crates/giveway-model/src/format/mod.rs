//! Files as text: the project's own JSON, and foreign formats.

mod json;
mod layout;
mod locate;
pub mod movingai;
pub mod native;
mod phrase;
mod text;

pub use text::read_text;
