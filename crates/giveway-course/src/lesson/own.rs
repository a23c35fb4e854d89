//! Lessons that came as a file or in a link: what a browser keeps of them, so that a
//! person can go on with them.

use super::link::{self, MARK};
use super::{Glossary, Id, Lesson};

/// The most lessons that are kept.
const MOST: usize = 12;
/// The most letters of all of them together.
const MAX_LETTERS: usize = 400_000;

/// Lessons that came as a file or in a link, the one that was opened last first. When
/// there are too many, the oldest ones go.
///
/// ```
/// use giveway_course::lesson::{Glossary, OwnLessons, read_lesson};
/// let text = r#"{ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
///   "steps": [{ "title": "One", "text": ["A sentence."],
///               "scene": { "giveway": 1, "map": ["."], "agents": [] } }] }"#;
/// let lesson = read_lesson(text, &Glossary::default()).unwrap();
/// let mut own = OwnLessons::default();
/// own.add(&lesson);
/// let own = OwnLessons::read(&own.write());
/// assert_eq!(own.lessons(&Glossary::default()), [lesson]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnLessons(Vec<(Id, String)>);

impl OwnLessons {
    /// Reads a text that was kept; what is no lesson is left out.
    pub fn read(text: &str) -> Self {
        let line = |line: &str| {
            let (id, letters) = line.split_once(' ')?;
            let is_lesson = letters.starts_with(MARK);
            Some((id.parse().ok()?, is_lesson.then(|| letters.to_owned())?))
        };
        let mut own = Self(text.lines().filter_map(line).take(MOST).collect());
        own.fit();
        own
    }

    /// The text that is kept.
    pub fn write(&self) -> String {
        let line = |(id, letters): &(Id, String)| format!("{id} {letters}\n");
        self.0.iter().map(line).collect()
    }

    /// A lesson is opened.
    pub fn add(&mut self, lesson: &Lesson) {
        let id = lesson.own_id();
        self.remove(&id);
        self.0.insert(0, (id, link::write(lesson, None)));
        self.fit();
    }

    /// A lesson is kept no longer.
    pub fn remove(&mut self, id: &Id) {
        self.0.retain(|(other, _)| other != id);
    }

    /// The lessons, but for those that cannot be read any more.
    pub fn lessons(&self, glossary: &Glossary) -> Vec<Lesson> {
        let read = |(_, letters): &(Id, String)| Some(link::read(letters, glossary).ok()?.0);
        self.0.iter().filter_map(read).collect()
    }

    fn fit(&mut self) {
        self.0.truncate(MOST);
        let mut letters = 0;
        self.0.retain(|(_, lesson)| {
            letters += lesson.len();
            letters <= MAX_LETTERS
        });
    }
}
