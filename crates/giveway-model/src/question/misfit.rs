//! Why a question cannot be answered.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::{Question, sentence, to_words};
use crate::{Fault, tr};

/// Why a question cannot be answered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "misfit", rename_all = "kebab-case")]
pub enum Misfit {
    /// It names what does not exist, or not where it could be.
    Fault {
        /// Found, and expected.
        fault: Fault,
    },
    /// It asks about what is not so.
    NotSo {
        /// The facts of the plan, as sentences.
        is_so: String,
        /// A question that fits, in the words of a question; there need be none.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ask: Option<Question>,
    },
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fault { fault } => fault.fmt(f),
            Self::NotSo { is_so, ask: None } => f.write_str(is_so),
            Self::NotSo {
                is_so,
                ask: Some(ask),
            } => {
                write!(f, "{is_so} You can ask: {}", to_words(ask))
            }
        }
    }
}

impl Misfit {
    /// Found and expected, with the place in the question.
    pub fn fault(self) -> Fault {
        match self {
            Self::Fault { fault } => fault,
            Self::NotSo { is_so, ask } => {
                let expected = match ask {
                    Some(ask) => format!("one about what is so, such as \"{}\"", to_words(&ask)),
                    None => "one about what is so".to_owned(),
                };
                let is_so = is_so.trim_end_matches('.');
                Fault::at("", format!("one about what is not so: {is_so}"), expected)
            }
        }
    }

    /// The same, with the question that can be asked as a sentence rather than as
    /// it is typed.
    pub fn in_sentences(&self) -> String {
        match self {
            Self::NotSo {
                is_so,
                ask: Some(ask),
            } => tr!(
                "{is_so} You can ask: {question}",
                is_so,
                question = sentence(ask)
            ),
            other => other.to_string(),
        }
    }
}

impl std::error::Error for Misfit {}
