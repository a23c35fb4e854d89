//! The course's own texts: its index, its glossary, its lessons, in the order of the
//! course.

use std::fs;

use giveway_course::lesson::{
    Course, Glossary, Lesson, Worded, keys, read_course, read_glossary, read_lesson,
};
use giveway_model::Fault;

use super::Said;
use crate::source;

/// Where its files are.
const FOLDER: &str = "static/course";

/// The course as it is read, in English.
#[derive(Clone, Debug)]
pub struct Files {
    /// The index.
    pub course: Course,
    /// The terms.
    pub glossary: Glossary,
    /// The lessons, by their short names.
    pub lessons: Vec<(String, Lesson)>,
}

impl Files {
    /// Reads them all.
    ///
    /// # Panics
    ///
    /// If one is not as it should be.
    pub fn read() -> Self {
        let course = whole("index", read_course);
        let glossary = whole("glossary", read_glossary);
        let names = course.lessons().map(|entry| entry.lesson.to_string());
        let lesson = |name: String| {
            let lesson = whole(&name, |text| read_lesson(text, &glossary));
            (name, lesson)
        };
        Self {
            lessons: names.map(lesson).collect(),
            glossary,
            course,
        }
    }
}

fn whole<T>(name: &str, read: impl FnOnce(&str) -> Result<T, Vec<Fault>>) -> T {
    let text = fs::read_to_string(source::root().join(path(name))).expect("a file of the course");
    read(&text).unwrap_or_else(|faults| panic!("{name}: {}", faults[0]))
}

fn path(name: &str) -> String {
    format!("{FOLDER}/{name}.json")
}

/// All that the files say.
pub(super) fn said() -> Vec<Said> {
    let files = Files::read();
    let mut all = of("index", &files.course);
    for (name, lesson) in &files.lessons {
        all.extend(of(name, lesson));
    }
    all.extend(of("glossary", &files.glossary));
    all
}

fn of<W: Worded + Clone>(name: &str, worded: &W) -> Vec<Said> {
    let path = path(name);
    let keys = keys(worded).into_iter();
    keys.map(|key| Said::of_data(&key, &path)).collect()
}
