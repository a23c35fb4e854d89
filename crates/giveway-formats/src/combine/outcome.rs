//! The result of combining files: a scene with its plans, or why there is none.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::{Alternative, Conventions, Fit, Format, Heading};
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::words::count;
use giveway_model::{Fault, Instance, Plan, tr};

/// A plan of elsewhere, read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct ForeignPlan {
    /// The name of its file.
    pub file: String,
    /// Its format.
    pub format: Format,
    /// How it was read, where that is a matter of convention: what it is about
    /// (`cells`, `up`), and how.
    pub words: Vec<(String, String)>,
    /// The same as data.
    pub conventions: Conventions,
    /// Why it was read so, a sentence.
    pub why: String,
    /// The other ways to read it.
    pub alternatives: Vec<Alternative>,
    /// How well it fits the scene.
    pub fit: Fit,
    /// The costs that its file claims.
    pub claimed: Claimed,
    /// Its costs if every step that its file writes counted, waits at the goal after the arrival too.
    pub written: Claimed,
    /// Where agents that turn look at each time; empty where none does.
    pub headings: BTreeMap<String, Vec<Heading>>,
    /// Remarks for a person, each a sentence.
    pub notes: Vec<String>,
    /// The plan; it may break any rule.
    pub plan: Plan,
    /// The lower bounds of every plan that its file claims.
    pub bounds: ClaimedBounds,
}

impl ForeignPlan {
    /// The phrase that every format that is written loses the headings of its robots, where it has some.
    pub fn lost_headings(&self) -> Option<String> {
        (!self.headings.is_empty()).then(|| {
            let robots = count(self.headings.len(), "robot");
            format!("where {robots} look, turn by turn")
        })
    }
}

/// A scene and the plans for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Combined {
    /// The scene.
    pub instance: Instance,
    /// The plans, in the order of the files.
    pub plans: Vec<ForeignPlan>,
    /// Remarks on the scene for a person, each a sentence.
    pub notes: Vec<String>,
}

/// A file that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A map, by its name without folders where it is known.
    Map(Option<String>),
    /// The starts (and goals) of the agents, in a scenario.
    Scenario,
    /// The problem that a solution is for, in its makers' own format: map and agents.
    Problem,
    /// Files, by the names that another file gives them.
    Files(Vec<String>),
}

/// Why files make no scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// A file is wrong.
    File {
        /// Its name.
        file: String,
        /// Its faults.
        faults: Vec<Fault>,
    },
    /// A file of another kind is needed beside them.
    Missing {
        /// The file that needs it.
        file: String,
        /// The missing file.
        what: Missing,
        /// A sentence about it, with what to do.
        sentence: String,
    },
    /// The files do not belong together; a sentence.
    Apart(String),
}

impl Refused {
    /// The same as faults whose places are files.
    pub fn faults(self) -> Vec<Fault> {
        match self {
            Self::File { file, faults } => {
                let faults = faults.into_iter();
                faults.map(|fault| fault.in_file(&file)).collect()
            }
            Self::Missing { file, what, .. } => {
                let found = match &what {
                    Missing::Map(Some(map)) => tr!("a file for the map {map}", map),
                    Missing::Map(None) => tr!("a file for a map").to_owned(),
                    Missing::Scenario => tr!("a plan without the starts of its robots").to_owned(),
                    Missing::Problem => tr!("a solution without its problem").to_owned(),
                    Missing::Files(names) => {
                        tr!(
                            "a problem without the files {names}",
                            names = names.join(", ")
                        )
                    }
                };
                let expected = match what {
                    Missing::Map(_) => tr!("that map among the files"),
                    Missing::Scenario => tr!("its scenario (.scen) among the files"),
                    Missing::Problem => {
                        tr!("the file of its problem, with map and robots, among the files")
                    }
                    Missing::Files(_) => tr!("these files, too"),
                };
                vec![Fault::at(file, found, expected)]
            }
            Self::Apart(sentence) => {
                let found = sentence.trim_end_matches('.');
                vec![Fault::at("", found, tr!("files that belong together"))]
            }
        }
    }
}
