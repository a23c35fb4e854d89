//! What can happen to a draft.

use giveway_model::{Plan, Scene};

use super::Draft;
use crate::lesson::Lesson;

/// Something that happens to a draft.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Something is written into a field.
    Write {
        /// Of the lesson, or of the step that is shown.
        whose: Whose,
        /// The field.
        field: String,
        /// What is in it now.
        text: String,
    },
    /// One of several things is chosen, or no longer, in a field of the step.
    Toggle {
        /// The field.
        field: String,
        /// Which of them.
        value: String,
    },
    /// A step is shown.
    Go(usize),
    /// An empty step comes behind the one that is shown.
    Add,
    /// A step is there twice.
    Copy(usize),
    /// A step is removed.
    Remove(usize),
    /// A step goes to another place.
    Move {
        /// From here.
        from: usize,
        /// To here.
        to: usize,
    },
    /// The scene on the page becomes the step's board, without a plan at first.
    TakeScene(Box<Scene>),
    /// The plan on the page comes with it.
    TakePlan(Box<Plan>),
    /// And the time shown there.
    TakeTime(u32),
    /// The step has no board of its own any more: the one before stays.
    DropBoard,
    /// One more answer.
    AddAnswer,
    /// An answer is removed.
    RemoveAnswer(usize),
    /// The last thing is undone that can be.
    Undo,
    /// A new lesson.
    New,
    /// A lesson that was written before.
    Open(Box<Lesson>),
    /// A draft that was kept, by this page or another one.
    Kept(Box<Draft>),
    /// The draft of another tab takes the place of this one.
    Take(Box<Draft>),
    /// The draft that was there before this one, as it was kept: the way back to it.
    Before(Box<Draft>),
}

/// Whose field it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The lesson's.
    Lesson,
    /// That of the step that is shown.
    Step,
}
