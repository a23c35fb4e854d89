//! What is said of the input beside an answer: it is part of the answer, in every format.

use giveway_model::{Assumption, Instance, assumption, constraint};
use serde::Serialize;

use super::plain;

/// What is said of the input of a command.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Said {
    /// What the scene takes for granted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    assumptions: Vec<Assumption>,
    /// How the input was read, each a sentence.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
}

impl Said {
    /// Adds sentences; one that was said already is not said again.
    pub(crate) fn add(&mut self, notes: impl IntoIterator<Item = String>) {
        for note in notes {
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
    }

    /// Says what an instance takes for granted.
    pub(crate) fn assume(&mut self, instance: &Instance) {
        self.assumptions = instance.assumptions().to_vec();
        self.add(assumption::sentences(instance.assumptions()));
        self.add(constraint::sentences(instance.constraints()));
    }

    /// The sentences.
    pub(crate) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// A line for each sentence, and an empty one below them.
    pub(super) fn text(&self) -> String {
        let mut lines = String::new();
        for note in &self.notes {
            lines = lines + "note: " + &plain::text(note) + "\n";
        }
        if !lines.is_empty() {
            lines.push('\n');
        }
        lines
    }
}

/// An answer with what is said of its input.
#[derive(Serialize)]
pub(super) struct Noted<'a, T> {
    #[serde(flatten)]
    pub(super) answer: &'a T,
    #[serde(flatten)]
    pub(super) said: &'a Said,
}
