//! The files of the course: its index and glossary at first, each lesson when it is
//! opened.

use std::rc::Rc;

use giveway_course::lesson::{
    Course, Entry, Glossary, Id, Lesson, Term, read_course, read_glossary, read_lesson,
};
use giveway_model::{Fault, tr};

use super::language;
use crate::board::Film;
use crate::files::fetch_text;

/// Where the files are, relative to the page.
const FOLDER: &str = "static/course";

/// What the course shows before a lesson is opened.
pub(super) struct Shelf {
    /// The index.
    pub(super) course: Course,
    /// The terms.
    pub(super) glossary: Glossary,
    /// The small boards of the lessons, in the order of the index.
    pub(super) pictures: Vec<Option<Rc<Film>>>,
    /// The small boards of the terms, in the order of the glossary.
    pub(super) term_pictures: Vec<Option<Rc<Film>>>,
}

impl Shelf {
    /// A course with its glossary.
    pub(super) fn new(course: Course, glossary: Glossary) -> Self {
        let pictures = course.lessons().map(|entry| Film::of(&entry.picture));
        let terms = glossary.terms.iter();
        let term_pictures = terms.map(|term| Film::of(term.picture.as_ref()?));
        Self {
            pictures: pictures.collect(),
            term_pictures: term_pictures.collect(),
            course,
            glossary,
        }
    }

    /// Fetches index and glossary.
    ///
    /// # Errors
    /// Why they are not there, as a sentence.
    pub(super) async fn fetch() -> Result<Self, String> {
        // What the browser says of it helps nobody.
        let missing = |_| {
            tr!("The course could not be loaded. Try again when the network is back.").to_owned()
        };
        let faulty = |faults: Vec<Fault>| {
            let sentence = first(&faults);
            tr!("The course did not arrive: {sentence}", sentence)
        };
        let course = fetch_text(&format!("{FOLDER}/index.json")).await;
        let course = read_course(&course.map_err(missing)?).map_err(faulty)?;
        let glossary = fetch_text(&format!("{FOLDER}/glossary.json")).await;
        let glossary = read_glossary(&glossary.map_err(missing)?).map_err(faulty)?;
        Ok(Self::new(course, glossary))
    }

    /// The same in the language that is spoken; its terms are in the order of that one.
    pub(super) fn said(&self) -> Self {
        let mut glossary = language::said(&self.glossary);
        if !language::tag().is_empty() {
            let terms = &mut glossary.terms;
            terms.sort_by(|one, two| language::order(&one.name, &two.name));
        }
        Self::new(language::said(&self.course), glossary)
    }

    /// Fetches a lesson.
    ///
    /// # Errors
    /// Why it is not there, as a sentence.
    pub(super) async fn lesson(&self, id: &Id) -> Result<Lesson, String> {
        let text = fetch_text(&format!("{FOLDER}/{id}.json")).await;
        let text = text.map_err(|_| {
            tr!("The lesson could not be loaded. Try again when the network is back.").to_owned()
        })?;
        read_lesson(&text, &self.glossary).map_err(|faults| {
            let sentence = first(&faults);
            tr!("This lesson cannot be opened: {sentence}", sentence)
        })
    }

    /// A lesson in the index, with its number from 1.
    pub(super) fn entry(&self, id: &Id) -> Option<(usize, &Entry)> {
        let mut lessons = self.course.lessons().enumerate();
        let (index, entry) = lessons.find(|(_, entry)| entry.lesson == *id)?;
        Some((index + 1, entry))
    }

    /// A term.
    pub(super) fn term(&self, id: &Id) -> Option<&Term> {
        self.glossary.get(id)
    }
}

fn first(faults: &[Fault]) -> String {
    faults.first().map(ToString::to_string).unwrap_or_default()
}
