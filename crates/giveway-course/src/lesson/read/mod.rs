//! Reads lessons, courses and glossaries with the distrust of any other file: sizes
//! are bounded, keys are known, and each link has what it names.

mod bounds;
mod check;
mod flaw;
mod flaw_words;
mod links;
mod tasks;
mod within;

use giveway_model::{Fault, format::native, tr};

use super::{Course, Glossary, Lesson};
use bounds::Faults;

pub use flaw::{Flaw, LessonFault, Place, Things};

pub use bounds::{
    MAX_ANSWERS, MAX_BYTES, MAX_CELLS, MAX_EDITS, MAX_FIRST, MAX_HINTS, MAX_LESSONS, MAX_MINUTES,
    MAX_ORDERED, MAX_PARAGRAPHS, MAX_STEPS, MAX_TERMS, MAX_TIME, MAX_TITLE,
};

/// Reads a lesson whose terms are those of a glossary.
///
/// # Errors
/// Every fault, each with its place, line and column: the text is no JSON or too long,
/// a key is unknown or missing, a number is out of bounds, markup is broken, a link has
/// nothing that it names, a scene is no instance, a task does not fit its step.
///
/// ```
/// use giveway_course::lesson::{Glossary, read_lesson};
/// let text = r#"{ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
///   "steps": [{ "title": "One", "text": ["See [A2](robot:A2)."],
///               "scene": { "giveway": 1, "map": ["."], "agents": [] } }] }"#;
/// let faults = read_lesson(text, &Glossary::default()).unwrap_err();
/// assert_eq!(faults[0].place, "steps[0].text[0]");
/// ```
pub fn read_lesson(text: &str, glossary: &Glossary) -> Result<Lesson, Vec<Fault>> {
    let lesson: Lesson = read(text)?;
    let mut faults = Faults::default();
    check::lesson(&lesson, glossary, &mut faults);
    faults.or(lesson, text)
}

/// What is wrong with a lesson that no text holds yet, each with its place.
pub(crate) fn check_lesson(lesson: &Lesson, glossary: &Glossary) -> Vec<LessonFault> {
    let mut faults = Faults::default();
    check::lesson(lesson, glossary, &mut faults);
    faults.all()
}

/// Reads the index of a course.
///
/// # Errors
/// As [`read_lesson`].
pub fn read_course(text: &str) -> Result<Course, Vec<Fault>> {
    let course: Course = read(text)?;
    let mut faults = Faults::default();
    check::course(&course, &mut faults);
    faults.or(course, text)
}

/// Reads a glossary.
///
/// # Errors
/// As [`read_lesson`].
pub fn read_glossary(text: &str) -> Result<Glossary, Vec<Fault>> {
    let glossary: Glossary = read(text)?;
    let mut faults = Faults::default();
    check::glossary(&glossary, &mut faults);
    faults.or(glossary, text)
}

fn read<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Vec<Fault>> {
    if text.len() > MAX_BYTES {
        let found = tr!("{n} bytes", n = text.len());
        let fault = Fault::at("", found, tr!("at most {most}", most = MAX_BYTES));
        return Err(vec![fault.in_text(1, 1)]);
    }
    native::read_object(text).map_err(|fault| vec![within::task(text, fault)])
}
