//! A lesson, an index or a glossary in another language: the same, in other words.
//!
//! The English text, as it stands in the file, is the key of a catalogue, as it is for
//! the sentences of the page. So a translation knows nothing of steps and tasks, and a
//! file in another language can never differ in what there is to do.

use super::task::{Choose, Predict};
use super::{Chapter, Course, Glossary, Lesson, Step, Task, Text};

/// Tells two meanings of a word apart: the name of a term in the glossary.
const TERM: &str = "a term";
/// All other words for a term in one text, with commas between them.
const ALSO: &str = "other words for a term";
/// Between a context and its text, as in every key of a catalogue.
const CONTEXT_END: char = '\u{4}';

/// Looks a text up by its key; `None` where it has no translation.
pub type Find<'a> = dyn FnMut(&str) -> Option<&'static str> + 'a;

/// What has texts for people.
pub trait Worded {
    /// Puts another text in the place of each one that is found.
    fn reword(&mut self, find: &mut Find<'_>);
}

/// The same in the words that are found. What is not found stays in English, and so does
/// what would not name the same robots, cells, terms and times.
///
/// ```
/// use giveway_course::lesson::{Chapter, translated};
/// let chapter = Chapter {
///     title: "Rules".into(),
///     about: "See [A1](robot:A1).".parse().unwrap(),
///     lessons: Vec::new(),
/// };
/// let german = translated(&chapter, |key| match key {
///     "Rules" => Some("Regeln"),
///     _ => Some("Siehe [A2](robot:A2)."),
/// });
/// assert_eq!(german.title, "Regeln");
/// assert_eq!(german.about, chapter.about, "it names another robot");
/// ```
pub fn translated<W: Worded + Clone>(
    english: &W,
    mut find: impl FnMut(&str) -> Option<&'static str>,
) -> W {
    let mut worded = english.clone();
    worded.reword(&mut find);
    worded
}

/// The keys of all texts, in their order.
pub fn keys<W: Worded + Clone>(english: &W) -> Vec<String> {
    let mut keys = Vec::new();
    translated(english, |key| {
        keys.push(key.to_owned());
        None
    });
    keys
}

impl Worded for Lesson {
    fn reword(&mut self, find: &mut Find<'_>) {
        self.title.reword(find);
        self.about.reword(find);
        self.steps.reword(find);
    }
}

impl Worded for Step {
    fn reword(&mut self, find: &mut Find<'_>) {
        self.title.reword(find);
        self.text.reword(find);
        if let Some(task) = &mut self.task {
            task.reword(find);
        }
        self.hints.reword(find);
        if let Some(reason) = &mut self.reason {
            reason.reword(find);
        }
    }
}

impl Worded for Task {
    fn reword(&mut self, find: &mut Find<'_>) {
        match self {
            Self::Paint(task) => task.say.reword(find),
            Self::Lead(task) => task.say.reword(find),
            Self::Predict(Predict { say, answers, .. }) => {
                say.reword(find);
                for guess in answers {
                    guess.text.reword(find);
                    guess.reply.reword(find);
                }
            }
            Self::Spot(task) => task.say.reword(find),
            Self::Choose(Choose { say, answers }) => {
                say.reword(find);
                for choice in answers {
                    choice.text.reword(find);
                    choice.reply.reword(find);
                }
            }
            Self::Order(task) => task.say.reword(find),
            Self::Change(task) => task.say.reword(find),
        }
    }
}

impl Worded for Course {
    fn reword(&mut self, find: &mut Find<'_>) {
        self.title.reword(find);
        self.about.reword(find);
        self.chapters.reword(find);
    }
}

impl Worded for Chapter {
    fn reword(&mut self, find: &mut Find<'_>) {
        self.title.reword(find);
        self.about.reword(find);
        for entry in &mut self.lessons {
            entry.title.reword(find);
        }
    }
}

impl Worded for Glossary {
    fn reword(&mut self, find: &mut Find<'_>) {
        for term in &mut self.terms {
            within(TERM, &mut term.name, find);
            if !term.also.is_empty() {
                let mut also = term.also.join(", ");
                within(ALSO, &mut also, find);
                term.also = also.split(", ").map(str::to_owned).collect();
            }
            term.text.reword(find);
        }
    }
}

impl Worded for String {
    fn reword(&mut self, find: &mut Find<'_>) {
        if let Some(found) = find(self) {
            found.clone_into(self);
        }
    }
}

impl Worded for Text {
    fn reword(&mut self, find: &mut Find<'_>) {
        let found = find(&self.to_string()).map(str::parse::<Self>);
        if let Some(Ok(other)) = found
            && other.names_the_same_as(self)
        {
            *self = other;
        }
    }
}

impl<W: Worded> Worded for Vec<W> {
    fn reword(&mut self, find: &mut Find<'_>) {
        for part in self {
            part.reword(find);
        }
    }
}

/// A word that means something else in another place.
fn within(context: &str, word: &mut String, find: &mut Find<'_>) {
    if let Some(found) = find(&format!("{context}{CONTEXT_END}{word}")) {
        found.clone_into(word);
    }
}
