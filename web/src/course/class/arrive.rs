//! Files and links of a class on their way in.

use std::rc::Rc;

use giveway_course::grade::{Came, Given, Unread};
use giveway_course::lesson::{Glossary, Id, read_lesson};
use giveway_model::tr;
use gloo::file::File;

use super::Collected;

/// The most files of a class; more are not looked at.
const MOST_FILES: usize = 1_000;

/// A file that was chosen, with what is in it.
pub(super) fn chosen(file: &File, bytes: &[u8]) -> Came {
    let text = String::from_utf8_lossy(bytes).into_owned();
    let time = AsRef::<web_sys::File>::as_ref(file).last_modified();
    Came::file(file.name(), time, text)
}

impl Collected {
    /// Adds what came; lessons first, so that hand-ins are judged against them.
    pub(super) fn add(&mut self, files: Vec<Came>, glossary: &Glossary) {
        if !files.is_empty() {
            self.told.clear();
        }
        let (lessons, others): (Vec<Came>, Vec<Came>) =
            files.into_iter().partition(Came::is_lesson);
        for came in lessons {
            match read_lesson(&came.text, glossary) {
                Ok(lesson) => {
                    let id = lesson.own_id();
                    self.class.give(Given::new(id, Rc::new(lesson)));
                }
                Err(faults) => {
                    let name = came.name.unwrap_or_default();
                    if let Some(fault) = faults.into_iter().next() {
                        self.class.add_unreadable(&name, fault);
                    }
                }
            }
        }
        for came in others {
            if self.class.files().len() >= MOST_FILES {
                self.told = tr!("Only the first {n} files are judged.", n = MOST_FILES);
                return;
            }
            let name = came.name.unwrap_or_else(|| {
                self.links += 1;
                tr!("Link {n}", n = self.links)
            });
            self.class.add(&name, came.date, &came.text);
        }
    }

    /// The lessons of hand-ins that nobody gave, each once.
    pub(super) fn missing_lessons(&self) -> Vec<Id> {
        let mut missing = Vec::new();
        for file in self.class.files() {
            if let Some(Unread::OtherLesson { hand_in, .. }) = file.unread() {
                let id = &hand_in.hand_in.lesson;
                if !missing.contains(id) {
                    missing.push(id.clone());
                }
            }
        }
        missing
    }
}
