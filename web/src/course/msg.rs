//! What happens in the course.

use std::rc::Rc;

use giveway_course::learner::Action;
use giveway_course::lesson::{Id, Lesson};
use giveway_course::tour;

use super::author::AuthorMsg;
use super::class::ClassMsg;
use super::contents::Page;
use super::handin::HandMsg;
use super::place::Place;
use super::shelf::Shelf;

/// Something that happens.
#[derive(Clone)]
pub(super) enum Msg {
    /// Something that a learner does, or hears.
    Do(Action),
    /// Something that happens on the tour.
    Tour(tour::Action),
    /// The page wants the tour, the next lesson, or an address to be opened; the contents,
    /// where it is empty.
    Open(String),
    /// The page tells the language that is spoken.
    Told(String),
    /// That language is spoken from now on.
    Spoken,
    /// A person wants another language, by its tag.
    Speak(&'static str),
    /// A place is chosen.
    Enter(Place),
    /// A lesson that came as a file or in a link is kept no longer.
    Remove(Id),
    /// The one that was removed last is kept again.
    BringBack,
    /// Index and glossary are there, or are not.
    Shelved(Result<Rc<Shelf>, String>),
    /// A lesson is there, or is not.
    Fetched(Place, Result<Rc<Lesson>, String>),
    /// Something is done in the editor.
    Author(AuthorMsg),
    /// A lesson is handed in.
    Hand(HandMsg),
    /// Something happens to the hand-ins of a class.
    Class(ClassMsg),
    /// Another tab has kept progress.
    Elsewhere,
    /// Shows a page of the contents, or closes them.
    Show(Option<Page>),
    /// Moves a robot in the order, from one place to another.
    Move(usize, usize),
    /// Types a value.
    Type(String),
    /// The judge has been looking for a while.
    Late,
    /// A translator or an extension has changed the elements: they are built anew.
    Foreign,
    /// The page is to be shown to a room.
    Present,
    /// The lesson is to be printed.
    Print,
    /// It was printed, or not.
    Printed,
}
