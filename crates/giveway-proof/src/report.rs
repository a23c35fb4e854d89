//! What came of a check.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Version;
use serde::{Deserialize, Serialize};

use crate::{Claim, bundle::Method};

/// What came of checking a certificate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Report {
    /// The format's version.
    pub giveway: Version,
    /// Whether every file is as it was written and every claim was shown again,
    /// but for those that are said to have nothing to be shown by.
    pub accepted: bool,
    /// Why it was not accepted: a sentence; `null` where it was.
    pub reason: Option<String>,
    /// Whether the check ended before it came to a result.
    pub stopped: bool,
    /// The claims that were checked, in their order.
    pub claims: Vec<Checked>,
}

/// A claim that was checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Checked {
    /// Its proof was checked.
    Proof {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// The variables of its formula.
        variables: usize,
        /// The clauses of its formula.
        clauses: usize,
        /// The steps of the proof that were needed.
        steps: usize,
    },
    /// It rests on a search, which was repeated.
    Search {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// What was searched.
        method: Method,
    },
    /// Nothing shows it.
    None {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// Why: a sentence.
        why: String,
    },
}

/// Why a certificate was not accepted.
pub(crate) enum Fault {
    Rejected(String),
    Stopped(String),
}

impl Fault {
    pub(crate) fn of(file: &str, what: &str) -> Self {
        Self::Rejected(format!("{file}: {what}."))
    }
}

impl Report {
    /// What comes of checks that put on a list what they have checked.
    pub(crate) fn of(check: impl FnOnce(&mut Vec<Checked>) -> Result<(), Fault>) -> Self {
        let mut claims = Vec::new();
        let (reason, stopped) = match check(&mut claims) {
            Ok(()) => (None, false),
            Err(Fault::Rejected(reason)) => (Some(reason), false),
            Err(Fault::Stopped(reason)) => (Some(reason), true),
        };
        Self {
            giveway: Version,
            accepted: reason.is_none(),
            reason,
            stopped,
            claims,
        }
    }
}
