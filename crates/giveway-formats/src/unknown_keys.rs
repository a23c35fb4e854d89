//! Keys of a file that its reader does not know.

use giveway_model::format::locate::Fields;
use giveway_model::words::and;
use giveway_model::{Assumption, tr};

/// Keys that change no problem, in files of any maker: what people write about a file, and
/// how its makers found a plan.
const HARMLESS: [&str; 37] = [
    "author",
    "authors",
    "color",
    "colour",
    "comment",
    "comments",
    "comp_time",
    "computation_time",
    "copyright",
    "created",
    "creator",
    "date",
    "description",
    "difficulty",
    "expanded",
    "generated",
    "highLevelExpanded",
    "id",
    "instance",
    "label",
    "lowLevelExpanded",
    "license",
    "map_name",
    "meta",
    "metadata",
    "name",
    "note",
    "notes",
    "numTaskAssignments",
    "random_seed",
    "runtime",
    "seed",
    "solver",
    "source",
    "time",
    "title",
    "version",
];

/// The most keys that are named.
const MAX_KEYS: usize = 32;

/// Whether a key is known to change nothing. Keys that begin with `_`, `x-` or `$` are remarks.
pub(super) fn is_harmless(key: &str) -> bool {
    let is_remark = key.starts_with(['_', '$']) || key.starts_with("x-");
    is_remark || HARMLESS.contains(&key)
}

/// Keys that were passed over and may mean something.
#[derive(Clone, Debug, Default)]
pub(super) struct UnknownKeys(Vec<String>);

impl UnknownKeys {
    /// The keys of an object in JSON that are not known; none where the text is no object.
    pub(super) fn in_object(text: &str, is_known: impl Fn(&str) -> bool) -> Self {
        let mut unknown = Self::default();
        unknown.note_object("", text, is_known);
        unknown
    }

    /// Notes the keys of an object in JSON that are not known.
    pub(super) fn note_object(&mut self, way: &str, text: &str, is_known: impl Fn(&str) -> bool) {
        if let Ok(fields) = serde_json::from_str::<Fields<'_>>(text) {
            for key in fields.names().filter(|key| !is_known(key)) {
                self.note(way, key);
            }
        }
    }

    /// Notes a key with the keys on the way to it, such as `agents.speed`, unless it is
    /// known to change nothing.
    pub(super) fn note(&mut self, way: &str, key: &str) {
        if is_harmless(key) || self.0.len() >= MAX_KEYS {
            return;
        }
        let whole = if way.is_empty() {
            key.to_owned()
        } else {
            format!("{way}.{key}")
        };
        if !self.0.contains(&whole) {
            self.0.push(whole);
        }
    }

    /// Takes what another one noted.
    pub(super) fn merge(&mut self, other: &Self) {
        for key in &other.0 {
            if self.0.len() < MAX_KEYS && !self.0.contains(key) {
                self.0.push(key.clone());
            }
        }
    }

    /// The keys.
    pub(super) fn keys(self) -> Vec<String> {
        self.0
    }

    /// The same for a scene.
    pub(super) fn assumptions(self) -> Vec<Assumption> {
        let keys = self.0.into_iter();
        keys.map(|key| Assumption::UnknownKey { key }).collect()
    }

    /// The same for a plan: a sentence.
    pub(super) fn sentence(&self) -> Option<String> {
        let keys = (!self.0.is_empty()).then(|| and(&self.0))?;
        Some(tr!(
            "Keys of the plan's file that are not heeded: {keys}.",
            keys
        ))
    }
}
