//! `manifest.json`: what a certificate claims and holds.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::words::in_english;
use giveway_model::{Cost, Costs, Instance, Objective, tr};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::{INSTANCE, Missing, PLAN, README, proof_files, readme};
use crate::Claim;
use crate::lemma::{LEMMA, Least, ProvedLemma};

/// The claims and the contents of a certificate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// The version of this format: 1.
    #[serde(rename = "giveway-certificate")]
    pub version: u32,
    /// The order of the costs.
    pub objective: Objective,
    /// The costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The claims, with what each rests on.
    pub claims: Vec<Entry>,
    /// The SHA-256 fingerprint of every other file.
    pub files: BTreeMap<String, String>,
}

/// A claim, and what it rests on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", try_from = "Written")]
pub enum Entry {
    /// A proof that can be checked.
    Proof {
        /// The claim.
        claim: Claim,
        /// The name of its files, without their endings.
        name: String,
        /// The variables of the formula.
        variables: usize,
        /// Its clauses.
        clauses: usize,
    },
    /// Lemmas with a proof each, and a proof that they show the claim.
    Lemmas {
        /// The claim.
        claim: Claim,
        /// The name of the files that put the lemmas together, without their endings.
        name: String,
        /// The variables of the formula that does so.
        variables: usize,
        /// Its clauses.
        clauses: usize,
        /// What each agent needs alone, to which the lemmas add.
        least: Least,
        /// The lemmas.
        lemmas: Vec<ProvedLemma>,
    },
    /// A search that can be repeated.
    Search {
        /// The claim.
        claim: Claim,
        /// The states that are searched.
        method: Method,
    },
    /// Nothing that could be checked.
    None {
        /// The claim.
        claim: Claim,
        /// Why there is nothing.
        why: Missing,
    },
}

/// An entry as it is written. Read as one object with all keys: code to read it
/// by its kind would hold every type in it a second time.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    kind: Kind,
    claim: Claim,
    name: Option<String>,
    variables: Option<usize>,
    clauses: Option<usize>,
    least: Option<Least>,
    lemmas: Option<Vec<ProvedLemma>>,
    method: Option<Method>,
    why: Option<Missing>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Proof,
    Lemmas,
    Search,
    None,
}

impl TryFrom<Written> for Entry {
    type Error = &'static str;

    fn try_from(written: Written) -> Result<Self, Self::Error> {
        let claim = written.claim;
        let proof = (written.name, written.variables, written.clauses);
        let lemmas = (written.least, written.lemmas);
        let by = (lemmas, written.method, written.why);
        match (written.kind, proof, by) {
            (
                Kind::Proof,
                (Some(name), Some(variables), Some(clauses)),
                ((None, None), None, None),
            ) => Ok(Self::Proof {
                claim,
                name,
                variables,
                clauses,
            }),
            (
                Kind::Lemmas,
                (Some(name), Some(variables), Some(clauses)),
                ((Some(least), Some(lemmas)), None, None),
            ) => Ok(Self::Lemmas {
                claim,
                name,
                variables,
                clauses,
                least,
                lemmas,
            }),
            (Kind::Search, (None, None, None), ((None, None), Some(method), None)) => {
                Ok(Self::Search { claim, method })
            }
            (Kind::None, (None, None, None), ((None, None), None, Some(why))) => {
                Ok(Self::None { claim, why })
            }
            _ => Err("a claim with the keys of another kind"),
        }
    }
}

impl Entry {
    /// The claim.
    pub fn claim(&self) -> &Claim {
        match self {
            Self::Proof { claim, .. }
            | Self::Lemmas { claim, .. }
            | Self::Search { claim, .. }
            | Self::None { claim, .. } => claim,
        }
    }
}

/// The states that a search exhausts.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Each agent alone on the map.
    Alone,
    /// The states of all agents together.
    Joint,
    /// Agents counted that have to pass where only so many can be at a time.
    Counting,
}

impl Method {
    /// The searched states, for a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Self::Alone => tr!("a search of ..." => "each robot alone"),
            Self::Joint => tr!("a search of ..." => "all states of all robots"),
            Self::Counting => tr!("a search of ..." => "the times at a bottleneck"),
        }
    }
}

impl Manifest {
    /// The files that belong to the certificate beside the manifest; nothing where
    /// two proofs have one name, or one has a name that no proof has.
    pub fn expected(&self) -> Option<BTreeSet<String>> {
        let mut expected = BTreeSet::from([README.to_owned(), INSTANCE.to_owned()]);
        if self.costs.is_some() {
            expected.insert(PLAN.to_owned());
        }
        let mut lemmas = BTreeSet::new();
        for entry in &self.claims {
            let (name, of_entry) = match entry {
                Entry::Proof { name, .. } => (name, [].as_slice()),
                Entry::Lemmas { name, lemmas, .. } => (name, lemmas.as_slice()),
                Entry::Search { .. } | Entry::None { .. } => continue,
            };
            let mut costs = Cost::ALL.iter().map(|cost| cost.name());
            if name != NO_PLAN && !costs.any(|cost| cost == name) {
                return None;
            }
            for file in proof_files(name) {
                if !expected.insert(file) {
                    return None;
                }
            }
            for ProvedLemma { name, .. } in of_entry {
                let number = name.strip_prefix(LEMMA)?.parse::<u32>().ok()?;
                if *name != format!("{LEMMA}{number}") {
                    return None;
                }
                // Claims share lemmas.
                lemmas.insert(name);
            }
        }
        for name in lemmas {
            expected.extend(proof_files(name));
        }
        Some(expected)
    }

    /// The `README.md` of a certificate with this manifest, about this instance. It is in
    /// English whatever is spoken, since whoever checks it writes it again.
    pub fn readme(&self, instance: &Instance) -> String {
        in_english(|| readme::text(self, instance))
    }

    /// The one text that this manifest has: any other is not it.
    pub fn text(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).unwrap_or_default();
        text.push('\n');
        text
    }
}

/// The name of a proof that there is no plan; others are named by their costs.
pub(crate) const NO_PLAN: &str = "no-plan";

/// The SHA-256 fingerprint of a file, in hexadecimal digits.
pub fn fingerprint(bytes: &[u8]) -> String {
    format!("{:x}", Sha256::digest(bytes))
}
