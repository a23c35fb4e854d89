//! A certificate as a folder of files: what it claims, and what shows it.
//!
//! | file | what |
//! |---|---|
//! | `README.md` | what was proved, in words |
//! | `manifest.json` | the same for programs, with the fingerprint of every other file |
//! | `instance.json` | the instance |
//! | `plan.json` | the plan, where there is one |
//! | `NAME.cnf`, `NAME.drat` | the formula of a claim and the proof that it is unsatisfiable |
//! | `NAME.names.txt` | what the variables of the formula stand for |
//! | `lemma-N.cnf`, ... | the same of a lemma about some of the agents |

#[cfg(feature = "archive")]
pub mod archive;
mod export;
pub(crate) mod manifest;
mod missing;
pub(crate) mod readme;

use std::collections::BTreeMap;

pub use export::{export, export_checked};
pub use manifest::{Entry, Manifest, Method, fingerprint};
pub use missing::Missing;

/// The files of a certificate by their names.
pub type Bundle = BTreeMap<String, Vec<u8>>;

pub(crate) const MANIFEST: &str = "manifest.json";
pub(crate) const README: &str = "README.md";
pub(crate) const INSTANCE: &str = "instance.json";
pub(crate) const PLAN: &str = "plan.json";

/// The three files of a proof.
pub(crate) fn proof_files(name: &str) -> [String; 3] {
    ["cnf", "drat", "names.txt"].map(|ending| format!("{name}.{ending}"))
}
