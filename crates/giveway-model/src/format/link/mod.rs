//! A scene and its plans as one line of text, the part of a link behind `#`, as the
//! page reads and writes it.
//!
//! ```text
//! giveway=1&check=231.9ae0daaf&map=10.2f6s2f...&name=warehouse&rules=0.0&costs=012&agents=A1.0.0.9.2!10.10;...
//! &audit=1-AQ...!l2rR...;...
//! ```

pub mod arrival;
pub mod lesson;
pub mod message;
pub mod plan;
pub mod repair;
pub mod scene;
pub mod seal;
pub mod text;

/// The longest text that the page reads, in bytes.
pub const LONGEST: usize = 1_000_000;
/// The largest side of a map that the page takes, in cells.
pub const MAX_SIDE: u32 = crate::MAX_SIDE;
/// The most agents that the page takes.
pub const MAX_AGENTS: usize = crate::MAX_AGENTS;
