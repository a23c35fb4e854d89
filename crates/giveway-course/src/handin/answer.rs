//! An answer to a task, as it is handed in.

use std::collections::BTreeMap;

use giveway_model::Path;
use giveway_solve::change::Method;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::Edits;
use crate::judge::Mark;
use crate::lesson::{Task, Value};

/// The last answer to a task.
///
/// As JSON: `{ "is": "value", "value": 9 }`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(
    tag = "is",
    rename_all = "kebab-case",
    rename_all_fields = "kebab-case",
    deny_unknown_fields
)]
pub enum Answer {
    /// To `predict`: a value was said.
    Value {
        /// The value.
        value: Value,
    },
    /// To `predict`: the answer was asked for.
    Shown {},
    /// To `spot`: conflicts were marked.
    Marks {
        /// The marks.
        marks: Vec<Mark>,
    },
    /// To `choose`: an answer was picked.
    Choice {
        /// Its index; in the file the first answer is 1.
        #[serde(with = "from_one")]
        choice: usize,
    },
    /// To `order`: the robots were put in an order.
    Order {
        /// Their names.
        order: Vec<String>,
    },
    /// To `order`: it was said that none works.
    NoOrder {},
    /// To `change`: a method was picked.
    Method {
        /// The method, such as `tunnel=1`.
        method: Method,
    },
    /// To `paint`: the scene was edited.
    Edits(Edits),
    /// To `lead`: robots were led.
    Paths {
        /// The path of each robot that was to be led.
        paths: BTreeMap<String, Path>,
        /// When they charge, where they do.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        charges: BTreeMap<String, Vec<u32>>,
    },
}

impl Answer {
    /// Whether it is an answer to this kind of task.
    pub(crate) const fn is_for(&self, task: &Task) -> bool {
        match self {
            Self::Value { .. } | Self::Shown {} => matches!(task, Task::Predict(_)),
            Self::Marks { .. } => matches!(task, Task::Spot(_)),
            Self::Choice { .. } => matches!(task, Task::Choose(_)),
            Self::Order { .. } | Self::NoOrder {} => matches!(task, Task::Order(_)),
            Self::Method { .. } => matches!(task, Task::Change(_)),
            Self::Edits(_) => matches!(task, Task::Paint(_)),
            Self::Paths { .. } => matches!(task, Task::Lead(_)),
        }
    }

    /// About how many letters it takes in a file.
    pub(crate) fn letters(&self) -> usize {
        let names = |names: &[String]| -> usize { names.iter().map(|name| name.len() + 3).sum() };
        30 + match self {
            Self::Value { .. }
            | Self::Shown {}
            | Self::Choice { .. }
            | Self::NoOrder {}
            | Self::Method { .. } => 10,
            Self::Marks { marks } => marks
                .iter()
                .map(|mark| 40 + names(&mark.robots) + 8 * mark.cells.len())
                .sum(),
            Self::Order { order } => names(order),
            Self::Edits(edits) => edits.letters(),
            Self::Paths { paths, charges } => {
                let paths = paths.iter().map(|(name, path)| name.len() + 8 * path.len());
                let charges = charges.iter().map(|(name, all)| name.len() + 4 * all.len());
                paths.chain(charges).sum()
            }
        }
    }
}

/// A count from 0 that stands in files as people count, from 1.
pub(super) mod from_one {
    use super::{Deserialize, Deserializer, Serializer, de};
    use giveway_model::tr;

    #[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
    pub(in crate::handin) fn serialize<S: Serializer>(
        index: &usize,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_u64(*index as u64 + 1)
    }

    pub(in crate::handin) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<usize, D::Error> {
        let number = u32::deserialize(deserializer)?;
        number
            .checked_sub(1)
            .map(|index| index as usize)
            .ok_or_else(|| {
                let expected = tr!("a number from 1");
                de::Error::custom(format!("found 0, expected {expected}"))
            })
    }
}
