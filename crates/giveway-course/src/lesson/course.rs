//! The index of a course: chapters of lessons, with what the page of contents shows.

use giveway_model::{Plan, Scene, Version, object_only};
use serde::{Deserialize, Serialize};

use super::{Id, Text};

/// A course.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Course {
    /// The version of the format.
    pub giveway: Version,
    /// What it is called.
    pub title: String,
    /// What it is about, in a sentence.
    pub about: Text,
    /// Its chapters.
    pub chapters: Vec<Chapter>,
}

object_only!(Course);

/// A chapter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Chapter {
    /// What it is called.
    pub title: String,
    /// What it is about, in a few words.
    pub about: Text,
    /// Its lessons.
    pub lessons: Vec<Entry>,
}

object_only!(Chapter);

/// A lesson as the page of contents shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Entry {
    /// Its short name, which is that of its file.
    pub lesson: Id,
    /// What it is called.
    pub title: String,
    /// How long it takes, in minutes.
    pub minutes: u32,
    /// How many steps it has.
    pub steps: u32,
    /// A board at its most telling moment.
    pub picture: Picture,
}

object_only!(Entry);

/// A small board to look at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields, rename_all = "kebab-case")]
pub struct Picture {
    /// The scene.
    pub scene: Scene,
    /// The plan, legal or not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// The time shown.
    #[serde(default)]
    pub time: u32,
}

object_only!(Picture);

impl Course {
    /// Its lessons, in order.
    pub fn lessons(&self) -> impl Iterator<Item = &Entry> {
        self.chapters.iter().flat_map(|chapter| &chapter.lessons)
    }

    /// The minutes of all lessons together.
    pub fn minutes(&self) -> u32 {
        self.lessons()
            .fold(0, |sum, entry| sum.saturating_add(entry.minutes))
    }
}
