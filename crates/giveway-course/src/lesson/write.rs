//! Writes lessons, courses and glossaries, for people and so that they read back the same.

use serde::Serialize;

use super::{Course, Glossary, Lesson};

/// Writes a lesson. Ends with a line break.
pub fn write_lesson(lesson: &Lesson) -> String {
    written(lesson)
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
    let mut text = serde_json::to_string_pretty(value).unwrap_or_default();
    text.push('\n');
    text
}
