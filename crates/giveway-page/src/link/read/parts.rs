//! The parts of a text, `name=value` between `&`: which there may be, and what is read
//! of each.

use std::collections::BTreeMap;

use giveway_model::format::link::{scene::PARTS as SCENE, text};
use giveway_model::tr;

use crate::link::From;

/// The parts that make an answer.
pub(super) const ANSWER: [&str; 8] = [
    "changes",
    "plan",
    "knows",
    "slept",
    "claim",
    "steps",
    "asked-within",
    "planner",
];

/// What a link may hold beside a scene.
const PUBLIC: [&str; 11] = [
    "plan", "knows", "slept", "changes", "audit", "time", "ask", "within", "colours", "looks",
    "verdict",
];

/// What only this browser writes.
const HERE: [&str; 18] = [
    "ours",
    "claim",
    "steps",
    "asked-within",
    "planner",
    "stale",
    "front",
    "report",
    "listed",
    "compared",
    "own",
    "asked",
    "shows-other",
    "told",
    "told-report",
    "prices",
    "ledger",
    "past",
];

/// What belongs to a scene and is no part of an answer: the version, the horizon that
/// was set, how robots look.
const BESIDE_SCENE: [&str; 4] = ["giveway", "within", "colours", "looks"];

/// Whether a part of a document is read from anywhere.
pub(in crate::link) fn is_public(part: &str) -> bool {
    let key = key(part);
    key == "giveway" || is_known(key, From::Anywhere)
}

/// Whether a part tells of the scene alone, and nothing of an answer.
pub(in crate::link) fn is_of_scene(part: &str) -> bool {
    let key = key(part);
    SCENE.contains(&key) || BESIDE_SCENE.contains(&key)
}

fn key(part: &str) -> &str {
    part.split_once('=').map_or(part, |(key, _)| key)
}

fn is_known(key: &str, from: From) -> bool {
    SCENE.contains(&key) || PUBLIC.contains(&key) || (from == From::Here && HERE.contains(&key))
}

/// The parts of a text by their names.
#[derive(Debug, Default)]
pub(super) struct Parts<'a>(BTreeMap<&'a str, &'a str>);

impl<'a> Parts<'a> {
    /// The parts of a text, of the version that is read.
    ///
    /// # Errors
    /// Which part there may not be, or what else is wrong, as a sentence.
    pub(super) fn split(text: &'a str, from: From) -> Result<Self, String> {
        let is_cut = |part: &str| from == From::Anywhere && !part.contains('=');
        if text.starts_with("giveway=") && text.split('&').any(is_cut) {
            return Err(tr!("It was cut in the middle of a part.").to_owned());
        }
        let mut all = text.split('&').filter_map(|part| part.split_once('='));
        match all.next() {
            Some(("giveway", "1")) => {}
            Some(("giveway", version)) => {
                let version: String = version.chars().take(20).collect();
                return Err(tr!(
                    "It is of version {version}; this page reads version 1.",
                    version
                ));
            }
            _ => return Err(tr!("It holds no scene of Giveway.").to_owned()),
        }
        let mut parts = BTreeMap::new();
        for (key, value) in all {
            if !is_known(key, from) || parts.insert(key, value).is_some() {
                return Err(broken(key));
            }
        }
        Ok(Self(parts))
    }

    /// A part as it was written.
    pub(super) fn get(&self, key: &str) -> Option<&'a str> {
        self.0.get(key).copied()
    }

    /// What is read of a part, where there is one.
    ///
    /// # Errors
    /// That it is broken, where nothing can be read of it.
    pub(super) fn read<T>(
        &self,
        key: &str,
        read: impl FnOnce(&'a str) -> Option<T>,
    ) -> Result<Option<T>, String> {
        let part = self.get(key);
        part.map(|text| read(text).ok_or_else(|| broken(key)))
            .transpose()
    }

    /// Some parts as one text, to be recognised by.
    pub(super) fn joined(&self, keys: &[&str]) -> String {
        let mut text = String::new();
        for key in keys {
            text.push('&');
            text += self.get(key).unwrap_or("-");
        }
        text
    }
}

/// That a part is broken, as a sentence.
pub(super) fn broken(key: &str) -> String {
    let key = text::unescape(key).unwrap_or_else(|| key.to_owned());
    let key: String = key.chars().take(20).collect();
    tr!("Its part “{key}” is broken.", key)
}
