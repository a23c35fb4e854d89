//! Reasons in words: the one place where they are made.
//!
//! Reasons are data; whoever wants other words replaces this folder. A template
//! a kind, each read as a person would say it.

mod alone;
mod contrast;
mod costs;
mod differences;
mod facts;
mod groups;
mod heads;
mod how;
mod joined;
mod nearby;
mod own_plan;
mod prices;
mod repairs;
mod unsolvable;
mod verdict;
mod violations;

pub use alone::alone_sentence;
pub use differences::other_charges;
pub(crate) use facts::fact;
pub(crate) use groups::fact_group;
pub use heads::{facts_claim, facts_title, helps_mark, verdict_word, witness_title};
pub use how::{how_of, how_sentence};
pub(crate) use joined::because;
pub(crate) use nearby::{here_sentence, near_sentence, nearby, variation};
pub(crate) use own_plan::own_plan;
pub use prices::{group_price_clause, price_clause};
pub use repairs::edits_in_words;
pub(crate) use repairs::repair;
pub(crate) use unsolvable::unsolvable;
pub(crate) use verdict::{KnownSoFar, verdict};
