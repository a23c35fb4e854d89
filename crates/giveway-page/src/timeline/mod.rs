//! The timeline as plain data: what an agent does in each step, where that
//! stands on the axis of time, and how far a solve has come.

mod axis;
mod gauge;
mod lane;
mod names;
mod row;
mod shapes;

pub use axis::{Axis, MIN_COLUMN};
pub use gauge::{Gauge, gauge, work_done};
pub use lane::{Lane, Step, Turn, Way};
pub use names::{ShownName, shown_names};
pub use row::Row;
pub use shapes::Shapes;
pub(crate) use shapes::{rounded, stripes};
