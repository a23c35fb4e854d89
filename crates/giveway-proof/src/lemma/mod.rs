//! Lemmas: statements about some agents, on which a claim about all of them rests.
//!
//! A formula of all agents grows with their number, and its proof faster. What makes plans of many agents dear
//! is mostly that some few get in each other's way. So a lemma says of a few agents that they cannot all
//! arrive so early, or not at such a cost; it is proved by the plain formula of these agents alone. That the
//! lemmas of a claim show it is arithmetic ([`of_lemmas`](crate::plain::of_lemmas)), proved by a formula of its
//! own. Which lemmas are tried is guessed from the cores of the search ([`Hint`]); a wrong guess costs time.

mod choose;
mod hint;
mod refine;
mod show;

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::message::read_map;
use giveway_model::{Cost, Instance, tr, words};
use serde::{Deserialize, Serialize};

use crate::exhaust::{Exhausted, least};
use crate::{Budget, escape, plain};

pub use hint::Hint;
pub(crate) use show::{Effort, Pool};

/// The names of the files of lemmas begin so; a number follows.
pub(crate) const LEMMA: &str = "lemma-";

/// The statement that some agents, all others left out, have no plan in which each arrives by its time
/// and that costs them together no more than this.
///
/// It holds of plans of all agents, too: without the others a plan stays one, at the same costs of these.
#[derive(
    Clone,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct Lemma {
    /// The agents by their names, each with its latest arrival, in time steps.
    #[borsh(deserialize_with = "read_map")]
    pub by: BTreeMap<String, u32>,
    /// The costs of these agents together, as far as they are limited. The makespan is no such cost: it
    /// is the latest of the arrivals.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[borsh(deserialize_with = "read_map")]
    pub most: BTreeMap<Cost, u32>,
}

impl Lemma {
    /// The lemma in words.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use giveway_proof::Lemma;
    /// let by = BTreeMap::from([("A1".to_owned(), 12), ("A4".to_owned(), 30)]);
    /// let lemma = Lemma { by, ..Lemma::default() };
    /// assert_eq!(
    ///     lemma.sentence(),
    ///     "Even without the other robots there is no plan in which A1 arrives by 12 and A4 arrives by 30."
    /// );
    /// ```
    pub fn sentence(&self) -> String {
        let by = self.by.iter();
        let by = by.map(|(agent, time)| tr!("{agent} arrives by {time}", agent, time));
        let arrivals = words::and(&by.collect::<Vec<_>>());
        let limits = self.most.iter();
        let limits = limits
            .map(|(cost, most)| tr!("{cost} at most {most}", cost = words::name(*cost), most));
        let with = match limits.collect::<Vec<_>>().as_slice() {
            [] => String::new(),
            limits => tr!(" with {limits}", limits = words::and(limits)),
        };
        escape::text(&tr!(
            "Even without the other robots there is no plan{with} in which {arrivals}.",
            with,
            arrivals
        ))
    }

    /// The instance with the agents of the lemma alone; `None` where one is missing. Rules are kept for
    /// those of their agents that are left.
    pub fn scene(&self, instance: &Instance) -> Option<Instance> {
        let mut scene = instance.clone();
        for agent in instance.agents() {
            if !self.by.contains_key(&agent.name) {
                scene.leave_out(&agent.name);
            }
        }
        (scene.agents().len() == self.by.len() && !self.by.is_empty()).then_some(scene)
    }
}

/// What an agent has of a cost at the least, to which lemmas add.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Least {
    /// As many steps and moves as its goal is cells away, and nothing of any other cost.
    Distance,
    /// What a search of it alone on the map finds.
    Search,
}

impl Least {
    /// The least of an agent by its number; `u32::MAX` where it has no way at all, `None` where the search
    /// ended too early.
    pub(crate) fn of(
        self,
        instance: &Instance,
        agent: usize,
        cost: Cost,
        budget: &Budget<'_>,
    ) -> Option<u32> {
        if self == Self::Search {
            return match least(instance, agent, cost, budget) {
                Exhausted::Plan(least) => Some(least),
                Exhausted::NoPlan => Some(u32::MAX),
                Exhausted::Stopped => None,
            };
        }
        let agent = instance.agents().get(agent)?;
        Some(match cost {
            Cost::Makespan | Cost::SumOfCosts | Cost::Moves => agent.goal.map_or(0, |goal| {
                let steps = plain::grid_distance(instance.grid(), agent.start, goal);
                steps.unwrap_or(u32::MAX)
            }),
            Cost::Charges | Cost::Waits | Cost::Penalty => 0,
        })
    }
}

/// A lemma with its proof, as a certificate lists it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProvedLemma {
    /// What it says.
    pub lemma: Lemma,
    /// The name of its files, without their endings.
    pub name: String,
    /// The variables of its formula.
    pub variables: usize,
    /// The clauses of its formula.
    pub clauses: usize,
}
