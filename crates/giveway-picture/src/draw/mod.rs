//! What a picture consists of: the sheet, the floor with the ways, robots, goals and
//! waypoints, the time; and what of it moves.

mod agents;
mod badge;
mod course;
mod ground;
mod keys;
mod label;
mod marks;
mod motion;
mod numbers;
mod rules;
mod sheet;
mod signs;
mod stage;
mod stays;
mod time;
mod words;

pub(crate) use motion::Motion;
pub(crate) use stage::Stage;
