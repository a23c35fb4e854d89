//! The judge: every rule that a plan breaks.
//!
//! It simulates the plan by the rules of the problem and shares nothing with
//! the solver. Each agent is first looked at alone (its path, its charges, its
//! battery), then all of them time step by time step for collisions.

mod battery;
mod charges;
mod collisions;
mod constraints;
mod costs;
mod findings;
mod moving;
mod occupancy;
mod over_time;
mod path;
mod sentence;
mod shape;
mod steps;
mod walk;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::{Cell, Costs, Instance, Plan};
use findings::Findings;

pub use battery::levels;
pub use costs::{arrivals, cost_of, costs, own_costs};
pub use over_time::{
    check_changes, check_history, costs_over_time, costs_until, level_at as level_over_time,
    levels as levels_over_time,
};
pub(crate) use over_time::{penalty_until, waits_on_end};
pub(crate) use steps::{Step, steps};
pub(crate) use walk::Walk;

/// The most violations that a report lists. A plan that breaks more is noise
/// rather than a plan, and pairs of colliding agents would fill the memory.
pub const MAX_VIOLATIONS: usize = 100_000;

/// The rule that a violation breaks.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// The path lists the agents or times in a way that is no path at all.
    Shape,
    /// The first cell is not the start.
    Start,
    /// The last cell is not the goal.
    Goal,
    /// A waypoint is not visited by the arrival.
    Waypoint,
    /// A step that is no wait, move or slow move.
    Move,
    /// A cell that is an obstacle or off the map.
    Obstacle,
    /// Two agents at one vertex at one time.
    Vertex,
    /// Two agents cross one normal edge in opposite directions.
    Swap,
    /// Two agents cross one slow edge in opposite directions.
    SlowSwap,
    /// A battery below the floor.
    Battery,
    /// A charge that is not allowed.
    Charge,
    /// A rule of the scene's own.
    Constraint,
}

impl Rule {
    /// The name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shape => "shape",
            Self::Start => "start",
            Self::Goal => "goal",
            Self::Waypoint => "waypoint",
            Self::Move => "move",
            Self::Obstacle => "obstacle",
            Self::Vertex => "vertex",
            Self::Swap => "swap",
            Self::SlowSwap => "slow-swap",
            Self::Battery => "battery",
            Self::Charge => "charge",
            Self::Constraint => "constraint",
        }
    }
}

/// One broken rule: where, when, who.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Violation {
    /// The rule.
    pub rule: Rule,
    /// The agents, in the order of the instance.
    pub agents: Vec<String>,
    /// The cell, where it is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell: Option<Cell>,
    /// The edge, where it is one: from, to, as the first agent goes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<[Cell; 2]>,
    /// The time, in steps from 0. Of a step, it is the time at which the step
    /// begins; of a slow swap, that at which the later agent leaves.
    pub time: u32,
    /// A sentence for people.
    pub message: String,
    /// The rule of the scene's own, where it is one.
    #[serde(flatten, default, skip_serializing_if = "Option::is_none")]
    pub broken: Option<Box<BrokenConstraint>>,
}

/// The rule of a scene's own that is broken, and where.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct BrokenConstraint {
    /// The kind of the constraint, as in files.
    pub kind: String,
    /// Its number in the scene, from 0.
    pub index: u32,
    /// Its name, where it has one.
    pub name: Option<String>,
    /// The cells, those of the first agent first.
    pub cells: Vec<Cell>,
}

/// The verdict on a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// Every violation, by time, then in the order of [`Rule`], then agents.
    /// At most [`MAX_VIOLATIONS`] of them.
    pub violations: Vec<Violation>,
    /// The five costs, where every agent has a path.
    pub costs: Option<Costs>,
}

impl Report {
    /// Whether no rule is broken.
    pub fn is_valid(&self) -> bool {
        self.violations.is_empty()
    }
}

/// Judges a plan.
///
/// Trailing repeats of a goal are cut before judging. An agent that ends
/// elsewhere than at its goal is judged as if it had arrived there. Collisions
/// come one a pair of agents and time, batteries one a stretch of time below
/// the floor.
///
/// ```
/// use giveway_model::{Instance, check::{Rule, check}, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["..", ".."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 1] }]
/// }"#).unwrap();
/// let plan = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 1]] } }"#,
/// ).unwrap();
/// let report = check(&instance, &plan);
/// assert_eq!(report.violations[0].rule, Rule::Move);
/// ```
pub fn check(instance: &Instance, plan: &Plan) -> Report {
    let mut findings = Findings::new(instance);
    shape::find(instance, plan, &mut findings);
    let walks = Walk::all(instance, plan);
    for walk in &walks {
        path::find(instance, walk, &mut findings);
        charges::find(instance, walk, &mut findings);
        battery::find(instance, walk, &mut findings);
    }
    collisions::find(instance, &walks, &mut findings);
    moving::find(instance, &walks, &mut findings);
    constraints::find(instance, &walks, &mut findings);
    Report {
        violations: findings.into_violations(),
        costs: costs(instance, plan),
    }
}
