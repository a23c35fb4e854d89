//! What can be predicted, and what is said of it.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::change::Changes;
use giveway_model::{Cell, Cost, tr};
use giveway_solve::change::Method;
use giveway_solve::plan::Planner;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// Something to predict. It has one right value: what plans differ in is none.
///
/// As JSON: `{ "is": "cost", "cost": "makespan" }`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    tag = "is",
    rename_all = "kebab-case",
    rename_all_fields = "kebab-case",
    deny_unknown_fields
)]
pub enum Quantity {
    /// A number: what the best plan costs. The cost is one of the scene's objective.
    Cost {
        /// The cost.
        cost: Cost,
    },
    /// A number: when a robot arrives in every best plan.
    Arrival {
        /// The robot.
        robot: String,
    },
    /// A cell: where a robot is at a time in every best plan.
    Place {
        /// The robot.
        robot: String,
        /// The time.
        time: u32,
    },
    /// A robot: the one that waits in every best plan, where no other does.
    Waits {},
    /// A cell: the waypoint that a robot visits first in every best plan.
    FirstWaypoint {
        /// The robot.
        robot: String,
    },
    /// A number: how many best plans there are.
    Plans {},
    /// A number: how many plans the Pareto front has.
    Points {
        /// The costs of the front, two or three.
        costs: Vec<Cost>,
    },
    /// A number: what the plan of a planner of the textbook costs.
    Planner {
        /// The planner.
        planner: Planner,
        /// The order of prioritised planning.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        order: Option<Vec<String>>,
        /// The cost.
        cost: Cost,
    },
    /// A number: the cost of a node of the tree of conflict-based search.
    Node {
        /// The node, from 0.
        number: u64,
    },
    /// A number: what the plan costs that a method goes on with after changes, or how
    /// many robots keep their path, where no cost is given.
    Changed {
        /// What changes.
        changes: Changes,
        /// How it goes on.
        method: Method,
        /// The cost.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        cost: Option<Cost>,
    },
    /// A number: what a rule of the scene's own costs, in the first cost of the objective:
    /// the best plan with it against the best one without it.
    Price {
        /// The rule, by its number in the scene, from 0.
        rule: u32,
    },
    /// A rule: the only one without which there is a plan.
    Decides {},
    /// A robot: the one that is first at a cell in every best plan.
    FirstAt {
        /// The cell.
        cell: Cell,
    },
    /// A number: how many steps a robot arrives later in the step's plan than alone, or
    /// how many of these are because of another robot.
    Delay {
        /// The robot.
        robot: String,
        /// The other one.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        because: Option<String>,
    },
    /// A robot: the one that loses most steps in the step's plan.
    LosesMost {},
    /// A robot: the one that costs the others most steps in the step's plan.
    CostsMost {},
}

/// What kind of thing a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// A number, or a time.
    Number,
    /// A robot.
    Robot,
    /// A cell.
    Cell,
    /// A rule of the scene's own.
    Rule,
}

impl Quantity {
    /// What kind of thing its value is.
    pub const fn kind(&self) -> ValueKind {
        match self {
            Self::Waits {} | Self::FirstAt { .. } | Self::LosesMost {} | Self::CostsMost {} => {
                ValueKind::Robot
            }
            Self::Decides {} => ValueKind::Rule,
            Self::Place { .. } | Self::FirstWaypoint { .. } => ValueKind::Cell,
            Self::Cost { .. }
            | Self::Arrival { .. }
            | Self::Plans {}
            | Self::Points { .. }
            | Self::Planner { .. }
            | Self::Node { .. }
            | Self::Changed { .. }
            | Self::Price { .. }
            | Self::Delay { .. } => ValueKind::Number,
        }
    }
}

/// A number, a robot, a cell or a rule. As JSON: `7`, `"A1"`, `[3, 1]` or `{ "rule": 0 }`.
///
/// ```
/// use giveway_course::lesson::Value;
/// let value: Value = serde_json::from_str(r#"{ "rule": 0 }"#).unwrap();
/// assert_eq!(value, Value::Rule { rule: 0 });
/// assert_eq!(value.to_string(), "rule 1", "people count from 1");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, BorshSerialize, BorshDeserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number, or a time.
    Number(u32),
    /// A robot, by its name.
    Robot(String),
    /// A cell.
    Cell(Cell),
    /// A rule of the scene's own.
    Rule {
        /// Its number in the scene, from 0.
        rule: u32,
    },
}

impl Value {
    /// What kind of thing it is.
    pub const fn kind(&self) -> ValueKind {
        match self {
            Self::Number(_) => ValueKind::Number,
            Self::Robot(_) => ValueKind::Robot,
            Self::Cell(_) => ValueKind::Cell,
            Self::Rule { .. } => ValueKind::Rule,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Robot(name) => name.fmt(f),
            Self::Cell(cell) => cell.fmt(f),
            Self::Rule { rule } => {
                f.write_str(&tr!("rule {number}", number = u64::from(*rule) + 1))
            }
        }
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;

        impl<'de> Visitor<'de> for Any {
            type Value = Value;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!(
                    "a number, a robot's name, a cell [x, y] or an object with the number of a rule"
                ))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<Value, E> {
                let small = u32::try_from(number).map(Value::Number);
                small.map_err(|_| E::invalid_value(de::Unexpected::Unsigned(number), &self))
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Value, E> {
                Ok(Value::Robot(name.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Value, A::Error> {
                let cell = <Cell as Deserialize>::deserialize(SeqAccessDeserializer::new(list));
                cell.map(Value::Cell)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Value, A::Error> {
                #[derive(Deserialize)]
                #[serde(deny_unknown_fields)]
                struct Rule {
                    rule: u32,
                }
                let rule = Rule::deserialize(MapAccessDeserializer::new(map));
                rule.map(|Rule { rule }| Value::Rule { rule })
            }
        }

        deserializer.deserialize_any(Any)
    }
}
