//! Why a plan is as it is, or why there is none: reasons as data.
//!
//! - [`ask`]: the search, asked about a changed instance; [`budgets`]: the budgets of many such searches;
//! - `explanation`: the question to the service, and its answer as far as known;
//! - [`engine`]: the order of the parts; `telling`: the first layers, told to the host;
//! - [`fitting`]: a question that fits the plan; [`verdict`]: the best other plan beside the one asked about;
//! - [`closest`]: of these, one that is close to it; [`how`]: how it differs, and who pays;
//! - `changed`: a question after a change of the world, as one about a snapshot of the plan;
//!   `whole` tells the answer of the whole plan;
//! - [`group`], [`edits`]: facts left out, edits made;
//! - [`reasons`]: the parts that say why, in their order;
//! - [`contrasted`]: the search for what a question asks for, with facts left out;
//! - [`group_mus`]: facts that alone make it impossible; [`growing`]: a smallest set of agents that
//!   alone do; [`alone`]: what sets of agents alone need;
//! - [`fact_groups`]: these facts in groups; [`shelves`]: shelf blocks and aisles;
//! - [`causes`]: which of these help when they are left out, and further sets;
//! - [`soft`]: plans that break as few rules as can be;
//! - [`repairs`]: edits that help;
//! - [`waits`], [`own_way`]: what would happen; [`lone_walk`]: the walk of one agent that breaks
//!   the fewest rules; `losses`: who arrives last, or loses most, beside its arrival alone;
//! - [`own_plan`]: a person's own plan beside the best;
//! - [`unsolvable`]: all of these, where there is no plan;
//! - [`layers`]: the layers of an answer; `here`: what the plan shows; `near`: small variations of it;
//! - [`answer`]: reasons in the shapes in which they are written as JSON;
//! - [`words`]: reasons in words.

pub mod alone;
pub mod answer;
pub(crate) mod ask;
pub(crate) mod budgets;
pub(crate) mod causes;
pub(crate) mod changed;
mod closest;
pub(crate) mod contrasted;
pub(crate) mod edits;
pub(crate) mod engine;
mod explanation;
mod fact_groups;
pub(crate) mod fitting;
pub(crate) mod group;
pub(crate) mod group_mus;
mod growing;
mod here;
pub(crate) mod how;
mod layers;
pub(crate) mod lone_walk;
mod losses;
mod near;
pub(crate) mod own_plan;
pub(crate) mod own_way;
pub(crate) mod reasons;
pub(crate) mod repairs;
mod shelves;
pub(crate) mod soft;
mod telling;
#[cfg(test)]
mod tests;
pub(crate) mod unsolvable;
pub(crate) mod verdict;
pub(crate) mod waits;
pub(crate) mod whole;
pub(crate) mod words;

pub use alone::SubsetBound;
pub use answer::{Class, Core, Edit, Excess, Fact, FactKind, Helps, Repair, WitnessEntry};
pub use edits::edited_instance;
pub use explanation::{ExplainAnswer, ExplainRequest, Part, Verdict};
pub use fact_groups::{FactGroup, FactGroupKind, FactPrice, GroupMark, MOST_GROUPS};
pub use how::{AgentDifference, How};
pub use layers::{Here, Layer, Near, Passing, Variation, VariationKind};
pub use words::{
    alone_sentence, edits_in_words, facts_claim, facts_title, group_price_clause, helps_mark,
    how_of, how_sentence, other_charges, price_clause, verdict_word, witness_title,
};
