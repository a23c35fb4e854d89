//! Files and links of a class on their way in.

use std::rc::Rc;

use giveway_course::grade::{Given, Unread};
use giveway_course::handin::link;
use giveway_course::lesson::{Glossary, Id, read_lesson};
use giveway_model::tr;
use gloo::file::File;

use super::Collected;

/// The most files of a class; more are not looked at.
const MOST_FILES: usize = 1_000;

/// A file or a link that came.
#[derive(Clone)]
pub(in crate::course) struct Came {
    /// Its name; a link has none.
    pub(super) name: Option<String>,
    /// When it was changed last, in seconds.
    pub(super) date: Option<u64>,
    /// What is in it.
    pub(super) text: String,
}

/// Whether what the page wants to be opened are hand-ins: files as a list, a text, or links.
pub(in crate::course) fn are_hand_ins(address: &str) -> bool {
    address.starts_with('[') || address.contains(link::KEY) || address.contains("\"hand-in\":")
}

/// The files, or the links, one a line.
pub(in crate::course) fn came(address: &str) -> Vec<Came> {
    if address.starts_with('[') {
        let list: Vec<(String, f64, String)> = serde_json::from_str(address).unwrap_or_default();
        return list.into_iter().map(file).collect();
    }
    if address.contains("\"hand-in\":") {
        return vec![Came {
            name: Some(tr!("Pasted text").to_owned()),
            date: None,
            text: address.to_owned(),
        }];
    }
    let lines = address.lines().filter(|line| line.contains(link::KEY));
    let link = |line: &str| Came {
        name: None,
        date: None,
        text: line.to_owned(),
    };
    lines.map(link).collect()
}

/// A file by its name, the milliseconds of its last change, and its text.
fn file((name, time, text): (String, f64, String)) -> Came {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a conversion of floats saturates, and no file is of before 1970"
    )]
    let date = (time / 1_000.0) as u64;
    Came {
        name: Some(name),
        date: Some(date),
        text,
    }
}

impl Came {
    /// A file that was chosen, with what is in it.
    pub(super) fn of(chosen: &File, bytes: &[u8]) -> Self {
        let text = String::from_utf8_lossy(bytes).into_owned();
        let time = AsRef::<web_sys::File>::as_ref(chosen).last_modified();
        file((chosen.name(), time, text))
    }
}

/// Whether a file is a lesson by a look at it.
fn is_lesson(text: &str) -> bool {
    text.contains("\"steps\"") && !text.contains("\"hand-in\"")
}

impl Collected {
    /// Adds what came; lessons first, so that hand-ins are judged against them.
    pub(super) fn add(&mut self, files: Vec<Came>, glossary: &Glossary) {
        let (lessons, others): (Vec<Came>, Vec<Came>) =
            files.into_iter().partition(|it| is_lesson(&it.text));
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
