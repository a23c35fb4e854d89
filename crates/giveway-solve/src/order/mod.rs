//! The order that robots can keep without a common clock: the graph of a plan, who is pushed
//! when one is late, and the same in other formats.
//!
//! `giveway-order` makes all of it out of the scene, the plan and its changes; this is its place
//! in the service.
//!
//! - [`request`], [`answer`]: the shapes in which they are written as JSON;
//! - [`serve`](mod@serve): all of it in order.

mod answer;
mod request;
mod serve;

pub use answer::{OrderAnswer, OrderFile};
pub use request::{OrderFormat, OrderRequest};
pub(crate) use serve::serve;
