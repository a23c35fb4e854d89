//! The seven steps: what each says, when it is done, what it points at.

use giveway_model::{Cell, tr};

use crate::port::Sight;

/// A step of the tour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// The plan plays to its end.
    Watch,
    /// A robot that waits is selected.
    Select,
    /// A question is asked about it.
    Ask,
    /// A cell is closed.
    Close,
    /// The scene is solved again.
    Solve,
    /// A rule is added, and its price is asked for.
    Rule,
    /// The course is opened.
    GoOn,
}

/// What a step points at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The button that plays.
    Play,
    /// A cell of the board, or who is on it.
    Cell(Cell),
    /// The first question about what is selected.
    Question,
    /// The tool for obstacles.
    Obstacle,
    /// The button that solves.
    Solve,
    /// The tool for zones.
    Zone,
    /// The button that adds the rule which is being written.
    AddRule,
    /// The button that asks what the rules cost.
    Price,
    /// The button that opens the course.
    Course,
}

impl Step {
    /// All of them, in order.
    pub const ALL: [Self; 7] = [
        Self::Watch,
        Self::Select,
        Self::Ask,
        Self::Close,
        Self::Solve,
        Self::Rule,
        Self::GoOn,
    ];

    /// Its place among them, from 0.
    pub fn index(self) -> usize {
        let mut all = Self::ALL.into_iter();
        all.position(|step| step == self).unwrap_or_default()
    }

    /// The step after it; the last one has none and stays.
    #[must_use]
    pub fn next(self) -> Self {
        Self::ALL.get(self.index() + 1).copied().unwrap_or(self)
    }

    /// Whether a person has done it.
    pub fn is_done(self, sight: &Sight) -> bool {
        match self {
            Self::Watch => sight.is_solved && sight.last > 0 && sight.time == sight.last,
            Self::Select => sight.robot.as_deref() == Some(super::ROBOT),
            Self::Ask => sight.is_asking,
            Self::Close => sight.is_edited,
            Self::Solve => sight.is_solved,
            Self::Rule => sight.is_priced,
            Self::GoOn => false,
        }
    }

    /// Whether it can only be done with a plan of the scene.
    pub const fn needs_plan(self) -> bool {
        matches!(self, Self::Watch | Self::Select | Self::Ask)
    }

    /// Its title: what to do.
    pub fn title(self) -> &'static str {
        match self {
            Self::Watch => tr!("Play the plan"),
            Self::Select => tr!("Click a robot that waits"),
            Self::Ask => tr!("Ask why it waits"),
            Self::Close => tr!("Change the scene"),
            Self::Solve => tr!("Solve it again"),
            Self::Rule => tr!("Add a rule"),
            Self::GoOn => tr!("Go on with the course"),
        }
    }

    /// Two or three sentences about it.
    pub fn text(self) -> &'static str {
        match self {
            Self::Watch => tr!(
                "Two robots want to go through the same corridor. Press play, and watch who gives \
                 way. Your own scene comes back after the tour."
            ),
            Self::Select => tr!(
                "A1 wears a pause sign. It stays where it is for one step. Click it to see more."
            ),
            Self::Ask => tr!(
                "Each robot has a list of questions. Press the first one: the solver looks for the \
                 reason and proves it."
            ),
            Self::Close => tr!(
                "Take your time to read the answer. Then pick the tool for obstacles, and close \
                 cell (6, 1), which is on the way of A1."
            ),
            Self::Solve => tr!(
                "The scene has changed since this plan. Press Solve: you get the best plan, or a \
                 proof that there is none."
            ),
            Self::Rule => tr!(
                "Pick the tool for zones and draw over the cells (3, 1) and (4, 1). Add the rule: \
                 one robot at a time. Then ask what the rules cost."
            ),
            Self::GoOn => tr!(
                "The price stands beside the rule. In the course you find out how it is found: \
                 short lessons, and something to do in each."
            ),
        }
    }
}
