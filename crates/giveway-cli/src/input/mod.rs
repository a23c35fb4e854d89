//! What comes in: files and standard input, told apart by what they hold.

mod changes;
pub(crate) mod foreign;
mod instance;
mod kind;
mod plan;
mod rules;
mod scenario;
mod source;

pub(crate) use changes::{ChangesFile, changes};
pub(crate) use instance::{instance, native};
pub(crate) use kind::Kind;
pub(crate) use plan::{is_plan, plan, plan_in, plan_over_time};
pub(crate) use rules::rule_of_file;
pub(crate) use scenario::{Map, Maps, Scen};
pub(crate) use source::{Source, is_standard_input};
