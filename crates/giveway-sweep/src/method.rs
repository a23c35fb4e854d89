//! Who plans: the search, a planner of the textbook, or one of others.

use std::fmt;
use std::str::FromStr;

use giveway_solve::plan::Planner;
use serde::{Deserialize, Serialize};

use crate::planner::wrong_name;

/// Who plans.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum Method {
    /// The search for the best plan, with its proof.
    Search,
    /// A planner of the textbook.
    Planner(Planner),
    /// A planner of others, by its name.
    Command(String),
}

impl Method {
    /// Whether it proves that a plan is best.
    pub const fn proves(&self) -> bool {
        matches!(self, Self::Search | Self::Planner(Planner::Cbs))
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Search => f.write_str("search"),
            Self::Planner(planner) => planner.fmt(f),
            Self::Command(name) => f.write_str(name),
        }
    }
}

/// Reads the search and the planners of the textbook; those of others have names of a spec.
impl FromStr for Method {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "search" {
            return Ok(Self::Search);
        }
        let planner = text.parse().map_err(|_| {
            format!("found the planner \"{text}\", expected search, prioritised, cbs, pibt, lacam or lns")
        })?;
        Ok(Self::Planner(planner))
    }
}

impl TryFrom<String> for Method {
    type Error = String;

    /// In tasks and rows, other names are those of commands.
    fn try_from(text: String) -> Result<Self, String> {
        text.parse().or_else(|error| match wrong_name(&text) {
            None => Ok(Self::Command(text)),
            Some(_) => Err(error),
        })
    }
}

impl From<Method> for String {
    fn from(method: Method) -> Self {
        method.to_string()
    }
}
