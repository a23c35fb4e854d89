//! The report of a check.

use std::collections::BTreeSet;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Version;
use giveway_model::tr;
use giveway_model::words::{count, grouped};
use serde::{Deserialize, Serialize};

use crate::{Claim, Least, Lemma, bundle::Method, conclude::Conclusion};

/// The report of checking a certificate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Report {
    /// The format's version.
    pub giveway: Version,
    /// Whether every file is as it was written and every claim was shown again,
    /// but for those that are said to have nothing to be shown by.
    pub accepted: bool,
    /// The weakest of the methods by which its claims were shown.
    pub certified: Certified,
    /// The joint conclusion of plan and claims: a sentence; `null` where the certificate was not accepted, or
    /// each claim stands for itself.
    pub conclusion: Option<String>,
    /// The same for programs.
    pub concluded: Option<Conclusion>,
    /// Why it was not accepted: a sentence; `null` where it was.
    pub reason: Option<String>,
    /// Whether the check ended before it came to a result.
    pub stopped: bool,
    /// The claims that were checked, in their order.
    pub claims: Vec<Checked>,
}

/// The methods by which all claims of a certificate were shown.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Certified {
    /// Each by a proof that was checked.
    Proved,
    /// Each by a proof or a search, which was repeated.
    ProvedAndSearched,
    /// Not all of them, or the certificate was not accepted.
    NotCertified,
}

impl Certified {
    /// The same in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Proved => "Proved",
            Self::ProvedAndSearched => "Proved and searched",
            Self::NotCertified => "Not certified",
        }
    }

    fn of(claims: &[Checked]) -> Self {
        let is = |test: fn(&Checked) -> bool| claims.iter().any(test);
        if is(|claim| matches!(claim, Checked::None { .. })) {
            Self::NotCertified
        } else if is(|claim| {
            matches!(
                claim,
                Checked::Search { .. }
                    | Checked::Lemmas {
                        least: Least::Search,
                        ..
                    }
            )
        }) {
            Self::ProvedAndSearched
        } else {
            Self::Proved
        }
    }
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
    /// The proofs of lemmas were checked, and that they show it.
    Lemmas {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// What they add to; a search of each robot alone was repeated.
        least: Least,
        /// The lemmas.
        lemmas: Vec<CheckedLemma>,
        /// The variables of the formula that puts them together.
        variables: usize,
        /// The clauses of that formula.
        clauses: usize,
        /// The steps of its proof that were needed.
        steps: usize,
    },
    /// It rests on a search, which was repeated.
    Search {
        /// The claim as a sentence.
        text: String,
        /// The claim.
        claim: Claim,
        /// The states that were searched.
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

/// A lemma whose proof was checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct CheckedLemma {
    /// The lemma as a sentence.
    pub text: String,
    /// The lemma.
    pub lemma: Lemma,
    /// The variables of its formula.
    pub variables: usize,
    /// The clauses of its formula.
    pub clauses: usize,
    /// The steps of the proof that were needed.
    pub steps: usize,
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
    /// How many claims rest on what: `The proof was checked: 3214 steps.`
    pub fn summary(&self) -> String {
        let (mut proofs, mut steps) = (0_u32, 0);
        let (mut searches, mut nothing) = (0_u32, 0_u32);
        let (mut by_lemmas, mut lemmas, mut largest) = (0_u32, BTreeSet::new(), 0);
        for claim in &self.claims {
            match claim {
                Checked::Lemmas {
                    lemmas: own,
                    steps: more,
                    ..
                } => {
                    by_lemmas += 1;
                    steps += more;
                    for CheckedLemma {
                        lemma, steps: more, ..
                    } in own
                    {
                        if lemmas.insert(lemma) {
                            steps += more;
                        }
                        largest = largest.max(lemma.by.len());
                    }
                }
                Checked::Proof { steps: more, .. } => {
                    proofs += 1;
                    steps += more;
                }
                Checked::Search { .. } => searches += 1,
                Checked::None { .. } => nothing += 1,
            }
        }
        let steps = match steps {
            // Its clauses contradict each other as they are.
            0 => tr!("no step was needed").to_owned(),
            1 => tr!("1 step").to_owned(),
            n => tr!("{steps} steps", steps = grouped(n as u64)),
        };
        let mut sentences = Vec::new();
        if proofs > 0 {
            sentences.push(tr!(
                "The proof was checked: {steps}." | "{n} proofs were checked: {steps}." % proofs,
                steps
            ));
        }
        if by_lemmas > 0 {
            sentences.push(tr!(
                "{n} claim rests on {lemmas}, the largest about {robots}: {steps}."
                    | "{n} claims rest on {lemmas}, the largest about {robots}: {steps}."
                        % by_lemmas,
                lemmas = lemma_count(lemmas.len()),
                robots = count(largest, "robot"),
                steps
            ));
        }
        if searches > 0 {
            sentences.push(tr!("{n} claim rests on a search, which was repeated."
                | "{n} claims rest on a search, which was repeated." % searches));
        }
        if nothing > 0 {
            sentences
                .push(tr!("{n} claim could not be checked."
                    | "{n} claims could not be checked." % nothing));
        }
        if sentences.is_empty() {
            sentences.push(tr!("Nothing is claimed: no cost can be below 0.").to_owned());
        }
        sentences.join(" ")
    }

    /// The report of checks, with their list and their joint conclusion.
    pub(crate) fn of(
        check: impl FnOnce(&mut Vec<Checked>) -> Result<Option<Conclusion>, Fault>,
    ) -> Self {
        let mut claims = Vec::new();
        let (concluded, reason, stopped) = match check(&mut claims) {
            Ok(concluded) => (concluded, None, false),
            Err(Fault::Rejected(reason)) => (None, Some(reason), false),
            Err(Fault::Stopped(reason)) => (None, Some(reason), true),
        };
        let certified = if reason.is_none() {
            Certified::of(&claims)
        } else {
            Certified::NotCertified
        };
        Self {
            giveway: Version,
            accepted: reason.is_none(),
            certified,
            conclusion: concluded.as_ref().map(Conclusion::sentence),
            concluded,
            reason,
            stopped,
            claims,
        }
    }
}

fn lemma_count(lemmas: usize) -> String {
    let lemmas = u32::try_from(lemmas).unwrap_or(u32::MAX);
    tr!("{n} lemma" | "{n} lemmas" % lemmas)
}
