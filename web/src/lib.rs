//! The playground: a page that shows a [`giveway_page::State`], sends actions,
//! and runs the solver in a worker.
//!
//! What is shown, and why, is decided in `giveway-page`; here it becomes
//! elements, events and motion.

mod app;
mod board;
mod broke;
mod clock;
mod compare;
mod copy;
pub mod course;
mod dialog;
mod drop;
mod embed;
mod field;
mod files;
mod floor_plan;
mod foreign;
mod glyph;
mod held;
mod icon;
mod inspector;
mod intake;
mod keep;
mod keys;
mod language;
mod lesson;
mod newest;
mod notice;
mod opening;
mod paper;
mod part;
mod paste;
mod present;
mod same;
mod script;
mod settings;
mod sheet;
mod shown;
mod slot;
mod solver;
mod status;
mod support;
mod theme;
mod timeline;
mod tools;
mod top_bar;
mod turning;
mod wide;
mod worker_client;

pub use app::App;
pub use board::{Board, BoardProps};
pub use broke::watch;
pub use clock::{Clock, Listening};
pub use glyph::form;
pub use inspector::{Inspector, InspectorProps};
pub use shown::Shown;
pub use timeline::{Dock, DockProps};
pub use tools::{Tools, ToolsProps};
