//! The events of a search.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Constraint, Cost, Costs, Objective, Version, message::read_map};
use serde::{Deserialize, Serialize};

use super::{AgentLeast, Core, Scope};
use crate::{Reason, search::LatestArrivals};

/// How the best plan was found and proved: the first events and the last.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SearchTrace {
    /// The format's version.
    pub giveway: Version,
    /// The objective.
    pub objective: Objective,
    /// The events in order: at most the first [`SearchTrace::FIRST`] and the last
    /// [`SearchTrace::LAST`] of them. Their numbers have a gap where some are left
    /// out.
    pub events: Vec<TraceEvent>,
    /// How many events are left out between the first and the last.
    pub left_out: u64,
    /// The latest arrivals that the proof leaves; no file has them.
    #[serde(skip)]
    pub(crate) latest: Option<LatestArrivals>,
}

/// An event of a search.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct TraceEvent {
    /// Its number among all events, from 0.
    pub number: u64,
    /// Conflicts of the SAT solver in the whole search up to now.
    pub conflicts: u64,
    /// The event as a sentence that is true by itself: see [`super::words`].
    pub text: String,
    /// Rules of the scene's own that it rests on: with these it holds, and without any rule of
    /// the scene's own it does not. They are found when the search is over, as far as that is
    /// soon known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rules: Vec<Constraint>,
    /// The event.
    #[serde(flatten)]
    pub event: SearchEvent,
}

/// An event of a search.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum SearchEvent {
    /// The least that each agent needs alone bounds a cost: by their sum, of the makespan by the largest.
    Alone {
        /// The cost.
        cost: Cost,
        /// All agents.
        agents: Vec<AgentLeast>,
        /// The bound.
        at_least: u32,
    },
    /// A better plan, which the judge passed.
    Plan {
        /// Its costs.
        costs: Costs,
        /// The method that found it.
        by: FoundBy,
    },
    /// The search for the least of a cost begins, among the plans that have the
    /// optima of all costs before it.
    Phase {
        /// The cost.
        cost: Cost,
        /// The optima of the costs before it.
        #[borsh(deserialize_with = "read_map")]
        given: BTreeMap<Cost, u32>,
    },
    /// Softs that earlier cores relaxed are bounded again: the next round of cores.
    Round {
        /// The cost that is bounded.
        cost: Cost,
    },
    /// Agents get a place in the formula. No plan for the others leaves them a best
    /// way of their own so far.
    Entered {
        /// The agents, and those with whom each collided.
        agents: Vec<Entrant>,
    },
    /// Limits that cannot all be kept, so that the bound rises.
    Core(Core),
    /// All that is left up to the best plan is refuted at once: no plan is better.
    Closed {
        /// The cost that is bounded.
        cost: Cost,
        /// Of which plans this is so.
        #[serde(rename = "condition", default, skip_serializing_if = "Scope::is_empty")]
        scope: Scope,
        /// The bound before.
        from: u32,
        /// The bound from now on: what the best plan has.
        to: u32,
        /// Conflicts that it took.
        took: u64,
    },
    /// Agents that have to pass a bottleneck are counted, and the time that it takes them one
    /// after the other bounds a cost: of plans of any makespan, whatever else they have to keep.
    Counted {
        /// The cost.
        cost: Cost,
        /// The agents.
        agents: Vec<String>,
        /// Where they have to pass.
        at: Bottleneck,
        /// The bound.
        at_least: u32,
    },
    /// All positions that the agents can be in together were gone through, which
    /// shows the least values of these costs, each given those before it.
    Exhausted {
        /// The costs.
        #[borsh(deserialize_with = "read_map")]
        bounds: BTreeMap<Cost, u32>,
    },
    /// The proof begins again with an empty formula. What was proved stays proved.
    Restarted {
        /// Why.
        why: Restart,
    },
    /// The best plan has what is proved to be the least: nothing is better.
    Met {
        /// The costs of the objective for which that is so by now; the last event
        /// has all of them.
        #[borsh(deserialize_with = "read_map")]
        costs: BTreeMap<Cost, u32>,
        /// The makespan up to which it holds; `null` where it holds for all plans, or
        /// is not known yet.
        within: Option<u32>,
    },
    /// The last event where no plan exists.
    Impossible(Cannot),
    /// The last event where the search ended early.
    Stopped(Stopped),
}

/// Where agents have to pass of which only a few can at a time.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bottleneck {
    /// These cells in a row, where no two can pass each other.
    Passage(Vec<Cell>),
    /// The zone of a rule of the scene's own.
    Zone {
        /// The number of the rule, from 0.
        rule: usize,
        /// How many may be in the zone at a time.
        most: u32,
    },
}

/// The method that found a plan.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum FoundBy {
    /// None: it was handed in.
    Given,
    /// Each agent on a best way of its own, which collide nowhere.
    Alone,
    /// Agents planned one after the other.
    Prioritised,
    /// LaCAM.
    Lacam,
    /// Collisions repaired in small groups.
    Repair,
    /// Large neighbourhood search.
    Lns,
    /// The SAT solver.
    Solver,
    /// The SAT solver in part, the other agents planned around.
    PartlySolver,
    /// By going through all positions that agents can be in together.
    Exhaustion,
}

/// An agent that gets a place in the formula.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Entrant {
    /// The agent.
    pub agent: String,
    /// With whom it collided; nobody where its way around the others costs more than
    /// it needs alone.
    pub with: Vec<String>,
}

/// Why a proof begins again.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Restart {
    /// A first try had little time only.
    MoreTime,
    /// The least of the first cost needs plans beyond the horizon.
    Horizon,
}

/// An agent that cannot arrive.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Cannot {
    /// Agents that cannot all arrive; all of them where nobody is named.
    pub agents: Vec<String>,
    /// The makespan up to which it was proved; `null` where it holds for all plans.
    pub within: Option<u32>,
}

/// How far a search came that ended early.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Stopped {
    /// Why; nothing in a trace that was read from JSON.
    #[serde(skip_deserializing)]
    pub reason: Option<Reason>,
    /// The costs of the best plan; `null` without one.
    pub costs: Option<Costs>,
    /// The proved lower bound of each cost of the objective reached so far.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
}

impl SearchTrace {
    /// How many of the first events are kept.
    pub const FIRST: usize = 200;
    /// How many of the last events are kept.
    pub const LAST: usize = 2_000;

    /// A trace without events yet.
    pub const fn new(objective: Objective) -> Self {
        Self {
            giveway: Version,
            objective,
            events: Vec::new(),
            left_out: 0,
            latest: None,
        }
    }

    /// Adds the next event, and leaves one out where there are too many: for those
    /// who are told of one after the other.
    pub fn push(&mut self, event: TraceEvent) {
        self.events.push(event);
        if self.events.len() > Self::FIRST + Self::LAST {
            self.events.remove(Self::FIRST);
            self.left_out += 1;
        }
    }
}
