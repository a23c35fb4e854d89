//! The planners by name.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use giveway_model::tr;
use serde::{Deserialize, Deserializer, Serialize, de};

/// A planner of the textbook.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Planner {
    /// Prioritised planning.
    Prioritised,
    /// Conflict-based search.
    Cbs,
    /// Priority inheritance with backtracking.
    Pibt,
    /// Lazy constraints addition search, in its anytime form LaCAM*.
    Lacam,
    /// Large neighbourhood search.
    Lns,
}

impl Planner {
    /// All of them, in the order in which lists show them.
    pub const ALL: [Self; 5] = [
        Self::Prioritised,
        Self::Cbs,
        Self::Pibt,
        Self::Lacam,
        Self::Lns,
    ];

    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Prioritised => "prioritised",
            Self::Cbs => "cbs",
            Self::Pibt => "pibt",
            Self::Lacam => "lacam",
            Self::Lns => "lns",
        }
    }

    /// The name for people, which may begin a sentence.
    pub fn title(self) -> &'static str {
        match self {
            Self::Prioritised => tr!("Prioritised planning"),
            Self::Cbs => "CBS",
            Self::Pibt => "PIBT",
            Self::Lacam => "LaCAM",
            Self::Lns => "LNS",
        }
    }

    /// The name of its steps, for people, after a number of them.
    pub fn steps(self, n: u64) -> &'static str {
        match (self, n) {
            (Self::Prioritised, 1) => tr!("a number of" => "order tried"),
            (Self::Prioritised, _) => tr!("a number of" => "orders tried"),
            (Self::Cbs, 1) => tr!("a number of" => "node of the constraint tree"),
            (Self::Cbs, _) => tr!("a number of" => "nodes of the constraint tree"),
            (Self::Pibt, 1) => tr!("a number of" => "time step"),
            (Self::Pibt, _) => tr!("a number of" => "time steps"),
            (Self::Lacam, 1) => tr!("a number of" => "configuration"),
            (Self::Lacam, _) => tr!("a number of" => "configurations"),
            (Self::Lns, 1) => tr!("a number of" => "neighbourhood"),
            (Self::Lns, _) => tr!("a number of" => "neighbourhoods"),
        }
    }
}

impl fmt::Display for Planner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A word that names no planner.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownPlanner(pub String);

impl fmt::Display for UnknownPlanner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "found \"{}\", expected prioritised, cbs, pibt, lacam or lns",
            self.0
        )
    }
}

impl std::error::Error for UnknownPlanner {}

impl FromStr for Planner {
    type Err = UnknownPlanner;

    fn from_str(word: &str) -> Result<Self, UnknownPlanner> {
        Self::ALL
            .into_iter()
            .find(|planner| planner.name() == word)
            .ok_or_else(|| UnknownPlanner(word.to_owned()))
    }
}

impl<'de> Deserialize<'de> for Planner {
    /// By hand, since derived code also takes `{"cbs": null}`.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = Cow::<str>::deserialize(deserializer)?;
        word.parse().map_err(de::Error::custom)
    }
}
