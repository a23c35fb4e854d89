//! Writes lessons, courses and glossaries, for people and so that they read back the same.

use serde::Serialize;

use super::layout::laid_out;
use super::{Course, Glossary, Lesson};

/// Writes a lesson. Ends with a line break.
pub fn write_lesson(lesson: &Lesson) -> String {
    written(lesson)
}

/// A lesson as JSON without blanks.
pub(crate) fn dense(lesson: &Lesson) -> String {
    without_defaults(&serde_json::to_string(lesson).unwrap_or_default())
}

/// Writes the index of a course. Ends with a line break.
pub fn write_course(course: &Course) -> String {
    written(course)
}

/// Writes a glossary. Ends with a line break.
pub fn write_glossary(glossary: &Glossary) -> String {
    written(glossary)
}

fn written<T: Serialize>(value: &T) -> String {
    // Texts, numbers and lists of them always have a JSON form.
    let dense = serde_json::to_string(value).unwrap_or_default();
    let mut text = laid_out(&without_defaults(&dense));
    text.push('\n');
    text
}

/// Without what scenes and plans have by default. No text holds any of these: a quote
/// within a text has a backslash before it.
fn without_defaults(dense: &str) -> String {
    dense
        .replace(
            r#","rules":{"at_goal":"stay","battery_floor":0},"objective":"#,
            r#","objective":"#,
        )
        .replace(
            r#","objective":["makespan","sum-of-costs","charges"],"agents":"#,
            r#","agents":"#,
        )
        .replace(r#"},"charges":{}"#, "}")
}
