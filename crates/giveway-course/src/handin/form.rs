//! The form in which a learner hands in: a name, a file, a link.

use giveway_model::tr;

use super::{HandIn, MAX_NAME, hand_in, link, write};
use crate::learner::Progress;
use crate::lesson::{Id, Lesson};

/// What was done in the form so far.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// The name, as it was typed.
    pub name: String,
    /// What was done last.
    pub done: Option<Done>,
}

/// What became of a hand-in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Done {
    /// It was saved as a file.
    Saved,
    /// It was copied as a link.
    Copied,
}

/// Something that is done in the form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormAction {
    /// A name is typed.
    Name(String),
    /// The file is to be saved.
    Save,
    /// The link is to be copied; nothing happens where there is none.
    Copy,
}

/// What must be done outside of the form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormEffect {
    /// Saves a file.
    Save {
        /// What it is called.
        name: String,
        /// What is in it.
        text: String,
    },
    /// Copies a link: what stands behind `#` in the address of the page.
    Copy(String),
}

/// What the form is about: a lesson, and what was done in it.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// How far the learner has come.
    pub progress: &'a Progress,
    /// The short name of the lesson.
    pub id: &'a Id,
    /// The lesson.
    pub lesson: &'a Lesson,
}

impl Form {
    /// What would be handed in now.
    pub fn made(&self, of: Subject<'_>) -> HandIn {
        hand_in(of.progress, of.id, of.lesson, &self.name)
    }

    /// The form after something is done, and what must be done outside.
    #[must_use]
    pub fn reduce(mut self, action: FormAction, of: Subject<'_>) -> (Self, Option<FormEffect>) {
        let effect = match action {
            FormAction::Name(name) => {
                self.name = name;
                self.done = None;
                None
            }
            FormAction::Save => {
                let made = self.made(of);
                self.done = Some(Done::Saved);
                Some(FormEffect::Save {
                    name: made.file_name(),
                    text: write(&made),
                })
            }
            FormAction::Copy => {
                let letters = link::write(&self.made(of));
                self.done = letters.as_ref().map(|_| Done::Copied);
                letters.map(|letters| FormEffect::Copy(format!("{}{letters}", link::KEY)))
            }
        };
        (self, effect)
    }

    /// What is said below the name: what its lack means, or how it is written in the file.
    pub fn name_hint(&self, of: Subject<'_>) -> Option<String> {
        let Some(name) = self.made(of).name else {
            return Some(tr!("Your lecturer will not know whose it is.").to_owned());
        };
        let written = self.name.split_whitespace().collect::<Vec<_>>().join(" ");
        (name != written).then(|| tr!("In the file it is “{name}”: a name has at most {n} letters, without signs that cannot be seen.", name, n = MAX_NAME))
    }

    /// Why there is no link, where there is none.
    pub fn no_link(&self, of: Subject<'_>) -> Option<&'static str> {
        let is_long = link::write(&self.made(of)).is_none();
        is_long.then(|| tr!("This is too long for a link. Save the file instead."))
    }

    /// What is said once it is done.
    pub fn done_words(&self) -> Option<&'static str> {
        self.done.map(|done| match done {
            Done::Saved => tr!("Saved. Give the file to your lecturer."),
            Done::Copied => tr!("Copied. Give the link to your lecturer."),
        })
    }
}
