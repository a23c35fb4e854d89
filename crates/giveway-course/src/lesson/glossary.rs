//! The glossary: every term of the field that the page and its lessons use.

use giveway_model::{Version, object_only};
use serde::{Deserialize, Serialize};

use super::{Id, Picture, Text};

/// A glossary.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Glossary {
    /// The version of the format.
    pub giveway: Version,
    /// Its terms, by their names.
    pub terms: Vec<Term>,
}

object_only!(Glossary);

/// A term.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Term {
    /// Its short name, by which texts link to it.
    pub term: Id,
    /// The term, as it begins an entry: `Sum of costs`.
    pub name: String,
    /// Other words for it, and other forms of it, within a sentence.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<String>,
    /// What it means, in one or two sentences.
    pub text: Text,
    /// A small board that shows it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<Picture>,
    /// Where it comes from, where somebody coined it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<Source>,
    /// The lesson that is about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lesson: Option<Id>,
}

object_only!(Term);

/// A paper or a book.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Source {
    /// Who wrote it.
    pub authors: String,
    /// What it is called.
    pub title: String,
    /// The year.
    pub year: u32,
}

object_only!(Source);

impl Glossary {
    /// The entry of a term.
    pub fn get(&self, term: &Id) -> Option<&Term> {
        self.terms.iter().find(|entry| entry.term == *term)
    }
}
