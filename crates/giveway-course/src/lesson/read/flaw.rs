//! The faults of a lesson as data: the place, and what is wrong there.
//!
//! A file's reader says them in the words of the file ([`super::flaw_words`]), the
//! editor in the words of its form ([`crate::author::sentence`]).

use giveway_model::{Cell, Cost, Fault};

use crate::lesson::Id;

/// A fault of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct LessonFault {
    /// Where it is.
    pub place: Place,
    /// What is wrong.
    pub flaw: Flaw,
}

/// A place in a lesson.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The step, from 0; none for the lesson as a whole.
    pub step: Option<usize>,
    /// The field of the step or the lesson, as it is named in a file: `task.say`.
    pub field: String,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Flaw {
    /// A list or a text is too long.
    TooMany {
        /// What is counted.
        things: Things,
        /// How many there are.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// A number is out of its bounds.
    OutOfRange {
        /// The number.
        number: u32,
        /// The least that it may be.
        least: u32,
        /// The most that it may be.
        most: u32,
    },
    /// A title is empty.
    NoTitle,
    /// A title has a control character.
    ControlCharacter,
    /// A paragraph is empty.
    NoWords,
    /// A link names a robot that is not there.
    LinkedRobot(String),
    /// A link names a cell outside of the map.
    LinkedCell(Cell),
    /// A link names a term that the glossary does not have.
    LinkedTerm(Id),
    /// A link names a time that is too late.
    LinkedTime(u32),
    /// The lesson has no steps.
    NoSteps,
    /// The first step has no scene.
    NoScene,
    /// The scene is no instance.
    BadScene(Fault),
    /// A step has no text.
    NoParagraphs,
    /// A step has a plan and asks the solver for one, too.
    TwoPlans,
    /// A task needs a plan, and the step has none.
    NoPlan,
    /// A task asks for conflicts, and the plan has none.
    LegalPlan,
    /// A cell is outside of the map.
    UnknownCell(Cell),
    /// A robot is not there.
    UnknownRobot(String),
    /// A rule of the scene's own, by its number from 0, is not there, or not in force.
    UnknownRule(u32),
    /// A task has no hints.
    NoHints,
    /// A task has no reason.
    NoReason,
    /// There are hints or a reason, but no task.
    NoTask,
    /// A task needs tools, and the step has none.
    NoTools,
    /// Nobody may be led.
    NoRobots,
    /// A prediction has one answer to pick from.
    OneAnswer,
    /// A choice has fewer than two answers; this many.
    FewAnswers(usize),
    /// No answer is right.
    NoRightAnswer,
    /// A value is of another kind than what is asked for.
    OtherKind(String),
    /// Something is there twice.
    Twice(String),
    /// These are not the costs of a Pareto front; so many.
    NoFront(usize),
    /// The scene's objective does not have this cost.
    NotOptimised(Cost),
    /// Two costs should differ.
    SameCosts,
    /// There is no method to pick from.
    NoMethods,
    /// Nothing has to be reached.
    NoAim,
}

/// Things that are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Things {
    /// Characters of a title.
    Characters,
    /// Steps of a lesson.
    Steps,
    /// Paragraphs of a step.
    Paragraphs,
    /// Hints of a task.
    Hints,
    /// Tools of a step.
    Tools,
    /// Cells of a step or a path.
    Cells,
    /// Robots of a task.
    Robots,
    /// Rules of a scene's own.
    Rules,
    /// Answers of a task.
    Answers,
    /// Methods of a task.
    Methods,
    /// Lessons of a course.
    Lessons,
    /// Terms of a glossary.
    Terms,
}
