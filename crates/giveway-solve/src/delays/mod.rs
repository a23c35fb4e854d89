//! Who costs whom: the delay of each agent against its own best way alone, split by whom it
//! lets pass, and where the steps are lost.
//!
//! - [`request`], [`answer`]: the shapes in which they are written as JSON; [`fraction`]: exact
//!   parts of a delay;
//! - [`running`]: the plan, or what is left of it after changes of the world;
//! - [`ledger`]: the rows, agent by agent; [`calmed`]: the plan by which they are split;
//! - [`heat`]: where the steps are lost; [`places`]: where most are;
//! - [`proof`]: how many every plan loses;
//! - [`serve`](mod@serve): all of it in order; [`words`]: the answer in sentences.

mod answer;
mod calmed;
mod fraction;
mod heat;
mod ledger;
mod places;
mod proof;
mod request;
mod running;
mod serve;
pub mod words;

pub use answer::{
    AgentDelay, AgentLoss, CauseTotal, CellLoss, DelayCause, DelayProof, DelaysAnswer, LossPlace,
    Share,
};
pub use fraction::Fraction;
pub use request::DelaysRequest;
pub(crate) use serve::serve;
