//! Conditions as certificates have them, in JSON.

use serde::de::Error as _;
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Condition;
use crate::{Cost, Question};

/// A condition in JSON.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Written {
    /// The contrast of a question about what an agent does or does not do.
    Contrast(Question),
    /// An agent arrives before a time.
    Arrival { agent: String, before: u32 },
    /// An agent has at most so many charges, moves or waits.
    AtMost {
        agent: String,
        cost: Cost,
        most: u32,
    },
}

impl Serialize for Condition {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let written = match self.clone() {
            Self::Below {
                agent: Some(agent),
                cost: Cost::Makespan | Cost::SumOfCosts,
                limit: before,
            } => Some(Written::Arrival { agent, before }),
            Self::Below {
                agent: Some(agent),
                cost: cost @ (Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty),
                limit,
            } => limit
                .checked_sub(1)
                .map(|most| Written::AtMost { agent, cost, most }),
            condition @ (Self::Never { .. }
            | Self::Visit { .. }
            | Self::Move { .. }
            | Self::Charge { .. }
            | Self::Before { .. }
            | Self::Keeps(_)
            | Self::Below { agent: None, .. }) => {
                Question::with_contrast(condition).map(Written::Contrast)
            }
        };
        let written = written.ok_or_else(|| S::Error::custom("no certificate has this condition"));
        written?.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Condition {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Written::deserialize(deserializer)? {
            Written::Arrival { agent, before } => Ok(Self::Below {
                agent: Some(agent),
                cost: Cost::Makespan,
                limit: before,
            }),
            Written::AtMost {
                agent,
                cost: cost @ (Cost::Charges | Cost::Moves | Cost::Waits),
                most,
            } => Ok(Self::Below {
                agent: Some(agent),
                cost,
                limit: most.saturating_add(1),
            }),
            Written::Contrast(question) => match question.condition(|_, _| None) {
                None | Some(Self::Below { .. }) => Err(D::Error::custom(format!(
                    "found \"{}\", which is about nothing that robots do, expected a question \
                     about what a robot does",
                    question.kind()
                ))),
                Some(
                    condition @ (Self::Never { .. }
                    | Self::Visit { .. }
                    | Self::Move { .. }
                    | Self::Charge { .. }
                    | Self::Before { .. }
                    | Self::Keeps(_)),
                ) => Ok(condition),
            },
            Written::AtMost {
                cost: cost @ (Cost::Makespan | Cost::SumOfCosts | Cost::Penalty),
                ..
            } => Err(D::Error::custom(format!(
                "found a limit of the {cost} of one robot, expected one of charges, moves or waits"
            ))),
        }
    }
}
