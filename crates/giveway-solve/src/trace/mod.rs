//! How the best plan was found and proved, told in the problem's own words: the
//! events of a search in order, as plain data, with sentences apart.

mod core;
mod event;
mod recorder;
mod rules;
#[cfg(test)]
mod tests;
pub mod words;

pub use core::{AgentLeast, AgentLimit, Core, EarlierCore, Literals, Scope, Together};
pub use event::{
    Bottleneck, Cannot, Entrant, FoundBy, Restart, SearchEvent, SearchTrace, Stopped, TraceEvent,
};
pub(crate) use recorder::{Names, Recorder};
pub(crate) use rules::name_rules;
