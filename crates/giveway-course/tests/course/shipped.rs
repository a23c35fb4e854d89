//! The files of the course, read.

use std::fs;
use std::path::PathBuf;

use giveway_course::lesson::{Course, Glossary, Lesson, read_course, read_glossary, read_lesson};
use giveway_model::Fault;

/// The folder of the course.
pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../static/course")
}

/// A file of the course as text.
pub(crate) fn text(name: &str) -> String {
    let path = folder().join(format!("{name}.json"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn read<T>(name: &str, result: Result<T, Vec<Fault>>) -> T {
    result.unwrap_or_else(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        panic!("{name}.json: {}", faults.join("\n"))
    })
}

/// The index.
pub(crate) fn course() -> Course {
    read("index", read_course(&text("index")))
}

/// The glossary.
pub(crate) fn glossary() -> Glossary {
    read("glossary", read_glossary(&text("glossary")))
}

/// A lesson by its short name.
pub(crate) fn lesson(name: &str) -> Lesson {
    read(name, read_lesson(&text(name), &glossary()))
}

/// All lessons of the index with their short names, in order.
pub(crate) fn lessons() -> Vec<(String, Lesson)> {
    let course = course();
    let names = course.lessons().map(|entry| entry.lesson.to_string());
    names.map(|name| (name.clone(), lesson(&name))).collect()
}
