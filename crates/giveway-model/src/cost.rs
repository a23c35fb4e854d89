//! The costs of a plan, and objectives over them.

use borsh::io;
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, de};

/// One of the five costs.
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
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Cost {
    /// The latest arrival.
    Makespan,
    /// The sum of arrivals.
    SumOfCosts,
    /// The number of charges.
    Charges,
    /// The number of cell-to-cell moves; a slow move is one.
    Moves,
    /// The number of wait steps before arrival.
    Waits,
    /// What rules of the scene's own make times in a zone and late arrivals cost.
    Penalty,
}

impl Cost {
    /// All of them, in the order in which results list them.
    pub const ALL: [Self; 6] = [
        Self::Makespan,
        Self::SumOfCosts,
        Self::Charges,
        Self::Moves,
        Self::Waits,
        Self::Penalty,
    ];

    /// Those of every scene: all but the penalty, which rules of a scene's own make.
    pub const USUAL: [Self; 5] = [
        Self::Makespan,
        Self::SumOfCosts,
        Self::Charges,
        Self::Moves,
        Self::Waits,
    ];

    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Makespan => "makespan",
            Self::SumOfCosts => "sum-of-costs",
            Self::Charges => "charges",
            Self::Moves => "moves",
            Self::Waits => "waits",
            Self::Penalty => "penalty",
        }
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no cost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownCost(pub String);

impl fmt::Display for UnknownCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "found \"{}\", expected makespan, sum-of-costs, charges, moves, waits or penalty",
            self.0
        )
    }
}

impl std::error::Error for UnknownCost {}

impl FromStr for Cost {
    type Err = UnknownCost;

    fn from_str(word: &str) -> Result<Self, UnknownCost> {
        Self::ALL
            .into_iter()
            .find(|cost| cost.name() == word)
            .ok_or_else(|| UnknownCost(word.to_owned()))
    }
}

impl<'de> Deserialize<'de> for Cost {
    /// By hand, since derived code also takes `{"moves": null}`.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = Cow::<str>::deserialize(deserializer)?;
        word.parse().map_err(de::Error::custom)
    }
}

/// The five costs of one plan.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Costs {
    /// The latest arrival, in time steps.
    pub makespan: u32,
    /// The sum of arrivals, in time steps.
    pub sum_of_costs: u32,
    /// The number of charges.
    pub charges: u32,
    /// The number of cell-to-cell moves.
    pub moves: u32,
    /// The number of wait steps before arrival.
    pub waits: u32,
    /// What rules of the scene's own make times in a zone and late arrivals cost.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub penalty: u32,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it so")]
const fn is_zero(cost: &u32) -> bool {
    *cost == 0
}

impl Costs {
    /// The value of one cost.
    pub const fn get(&self, cost: Cost) -> u32 {
        match cost {
            Cost::Makespan => self.makespan,
            Cost::SumOfCosts => self.sum_of_costs,
            Cost::Charges => self.charges,
            Cost::Moves => self.moves,
            Cost::Waits => self.waits,
            Cost::Penalty => self.penalty,
        }
    }

    /// The values in the order of an objective: smaller is better,
    /// lexicographically.
    ///
    /// ```
    /// use giveway_model::{Costs, Objective};
    /// let costs = Costs { makespan: 4, sum_of_costs: 7, charges: 0, moves: 6, waits: 1, penalty: 0 };
    /// assert_eq!(costs.vector(&Objective::default()), [4, 7, 0]);
    /// ```
    pub fn vector(&self, objective: &Objective) -> Vec<u32> {
        objective.costs().iter().map(|&c| self.get(c)).collect()
    }
}

/// An ordered list of distinct costs, optimised lexicographically.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, borsh::BorshSerialize)]
#[serde(try_from = "Vec<Cost>", into = "Vec<Cost>")]
pub struct Objective(Vec<Cost>);

/// Why a list of costs is no objective.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ObjectiveError {
    /// It is empty.
    Empty,
    /// A cost stands in it twice.
    Repeated(Cost),
    /// A word names no cost.
    Unknown(UnknownCost),
}

impl fmt::Display for ObjectiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("found no cost, expected at least one"),
            Self::Repeated(cost) => write!(f, "found {cost} twice, expected each cost once"),
            Self::Unknown(word) => word.fmt(f),
        }
    }
}

impl std::error::Error for ObjectiveError {}

impl Objective {
    /// An objective from its costs, the most important first.
    ///
    /// # Errors
    /// When the list is empty or a cost stands in it twice.
    pub fn new(costs: Vec<Cost>) -> Result<Self, ObjectiveError> {
        if costs.is_empty() {
            return Err(ObjectiveError::Empty);
        }
        for (i, cost) in costs.iter().enumerate() {
            if costs.iter().take(i).any(|other| other == cost) {
                return Err(ObjectiveError::Repeated(*cost));
            }
        }
        Ok(Self(costs))
    }

    /// The same with a cost at the end, where it has it not.
    #[must_use]
    pub fn with_last(mut self, cost: Cost) -> Self {
        if !self.0.contains(&cost) {
            self.0.push(cost);
        }
        self
    }

    /// The costs, the most important first.
    pub fn costs(&self) -> &[Cost] {
        &self.0
    }
}

impl Default for Objective {
    /// `makespan,sum-of-costs,charges`.
    fn default() -> Self {
        Self(vec![Cost::Makespan, Cost::SumOfCosts, Cost::Charges])
    }
}

impl FromStr for Objective {
    type Err = ObjectiveError;

    /// Reads `makespan,sum-of-costs`.
    fn from_str(list: &str) -> Result<Self, ObjectiveError> {
        let costs = list
            .split(',')
            .map(str::trim)
            .filter(|word| !word.is_empty())
            .map(|word| word.parse().map_err(ObjectiveError::Unknown))
            .collect::<Result<Vec<Cost>, _>>()?;
        Self::new(costs)
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, cost) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str(",")?;
            }
            f.write_str(cost.name())?;
        }
        Ok(())
    }
}

impl TryFrom<Vec<Cost>> for Objective {
    type Error = ObjectiveError;

    fn try_from(costs: Vec<Cost>) -> Result<Self, ObjectiveError> {
        Self::new(costs)
    }
}

impl From<Objective> for Vec<Cost> {
    fn from(objective: Objective) -> Self {
        objective.0
    }
}

impl borsh::BorshDeserialize for Objective {
    fn deserialize_reader<R: io::Read>(reader: &mut R) -> io::Result<Self> {
        Self::new(borsh::BorshDeserialize::deserialize_reader(reader)?).map_err(io::Error::other)
    }
}
