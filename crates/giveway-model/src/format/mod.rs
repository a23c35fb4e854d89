//! Files as text: the project's own JSON, and foreign formats.

/// The version of the project's own format that this crate writes, and the
/// newest that it reads.
pub const VERSION: u32 = 1;
