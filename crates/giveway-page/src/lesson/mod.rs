//! A lesson on the board: what it shows there, and what a person may do meanwhile.
//!
//! The lesson itself is another program of the page (`giveway-course`), which says what
//! the board shows and hears what happened on it. A person's own page is put aside as a
//! whole, and is back when the lesson ends; it alone is kept by the browser.

mod board;
mod happened;

use giveway_model::words::Later;
use giveway_model::{tr, tr_later};
use std::rc::Rc;

use giveway_course::lesson::{Layer, Tool as LessonTool};
use giveway_course::port::{Board, BoardPlan, Hand, Lit, Pick, ToPage};
use giveway_model::Cell;

use crate::steering::Lead;
use crate::{Action, BoardAction, FileAction, IntakeAction, SolveAction, State, Tool};

pub(crate) use board::{document, evidence};
pub use happened::{as_it_is, happened};

/// What a lesson does with the page, and what a person does with the lesson.
#[derive(Clone, Debug, PartialEq)]
pub enum LessonAction {
    /// The lesson says something.
    Says(Box<ToPage>),
    /// A person leaves it from the page.
    Leave,
}

/// A lesson on the board.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// What the lesson put on the board.
    pub board: Rc<Board>,
    /// The robot or the cell that the text names.
    pub lit: Option<Lit>,
    /// The cells that solved a task.
    pub sealed: Vec<Cell>,
    /// A person's own page.
    pub(crate) own: Rc<State>,
    /// Whether a search ran on it, which goes on when the lesson ends.
    pub(crate) resumes: bool,
    /// Whether what was hidden is shown.
    pub(crate) revealed: Revealed,
    /// What was pointed at last, with a number that tells it from the one before.
    pub(crate) pick: Option<(u32, Pick)>,
}

/// Whether what a lesson hides is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Revealed {
    /// It is hidden still.
    No,
    /// It is shown.
    Shown,
    /// A plan is shown that is proved to be the best.
    Best,
}

impl Lesson {
    /// A lesson that begins on a page.
    pub(crate) fn new(board: Rc<Board>, own: Rc<State>, resumes: bool) -> Self {
        Self {
            board,
            resumes,
            lit: None,
            sealed: Vec::new(),
            own,
            revealed: Revealed::No,
            pick: None,
        }
    }

    /// Whether a tool may be used.
    pub fn allows(&self, tool: Tool) -> bool {
        let tool = match tool {
            Tool::Select => return true,
            // No step of a lesson is about rules of a scene's own.
            Tool::Zone | Tool::OneWay => return false,
            Tool::Obstacle => LessonTool::Obstacle,
            Tool::Charger => LessonTool::Charger,
            Tool::SlowZone => LessonTool::SlowZone,
            Tool::Erase => LessonTool::Erase,
            Tool::Agent => LessonTool::Robot,
            Tool::Goal => LessonTool::Goal,
            Tool::Waypoint => LessonTool::Waypoint,
        };
        self.board.tools.contains(&tool)
    }

    /// Whether something on the board may be moved by hand.
    pub fn allows_moving(&self) -> bool {
        self.board.tools.contains(&LessonTool::Move)
    }

    /// Whether something is shown beside the map, or over it.
    pub fn shows(&self, layer: Layer) -> bool {
        self.board.show.contains(&layer) && !self.hides_plan()
    }

    /// Whether it is shown how the plan was found, or a person searches by hand.
    pub fn shows_inside(&self) -> bool {
        self.shows(Layer::Inside) || self.is_by_hand()
    }

    /// Whether a person searches by hand, though the best plan is hidden still.
    pub fn is_by_hand(&self) -> bool {
        self.board.show.contains(&Layer::ByHand)
    }

    /// Whether the plan and its timeline are hidden still.
    pub fn hides_plan(&self) -> bool {
        self.board.plan == BoardPlan::Hidden && self.revealed == Revealed::No
    }

    /// Whether broken rules are for the person to find.
    pub fn hides_conflicts(&self) -> bool {
        self.board.hand == Hand::Points && self.revealed == Revealed::No
    }

    /// Whether a robot is led, by its name.
    pub(crate) fn leads(&self, name: &str) -> bool {
        match &self.board.hand {
            Hand::Leads(names) => names.iter().any(|led| led == name),
            Hand::Looks | Hand::Points | Hand::Tours => false,
        }
    }

    /// Whether it is a tour: then the page is as it is without a lesson.
    pub(crate) fn is_tour(&self) -> bool {
        self.board.hand == Hand::Tours
    }
}

/// What becomes of an action while a lesson is on the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// It happens on the board of the lesson.
    Happens,
    /// It is about a person's own page, which is put aside.
    Own,
    /// The lesson ends, unless nothing comes of it.
    Leaves,
    /// It does not happen: a sentence says why.
    Closed(&'static str),
    /// It does not happen, and nobody asked for it.
    Dropped,
}

const NOT_NOW: Later = tr_later!("Leave the lesson before you do this.");

/// What becomes of an action on the board of a lesson.
pub(crate) fn fate(state: &State, lesson: &Lesson, action: &Action) -> Fate {
    match action {
        Action::Slot(_) | Action::File(FileAction::Resume(_)) => Fate::Own,
        Action::Intake(IntakeAction::Reply { .. }) => Fate::Leaves,
        Action::File(action) if !matches!(action, FileAction::Tell(_)) => Fate::Leaves,
        _ if lesson.is_tour() => Fate::Happens,
        Action::Board(BoardAction::PickTool(tool)) if !lesson.allows(*tool) => {
            Fate::Closed(tr!("This step does without that tool."))
        }
        Action::Board(BoardAction::Delete) if !lesson.allows(Tool::Erase) => {
            Fate::Closed(tr!("Nothing can be removed in this step."))
        }
        Action::Board(BoardAction::StepCursor { carries: true, .. })
            if !lesson.allows_moving() && lesson.board.hand == Hand::Looks =>
        {
            Fate::Closed(tr!("Nothing can be moved in this step."))
        }
        Action::Lesson(_)
        | Action::Board(_)
        | Action::Undo
        | Action::Redo
        | Action::Play(_)
        | Action::View(_)
        | Action::File(_)
        | Action::Intake(_)
        | Action::Worker(_)
        | Action::Solve(SolveAction::Cancel) => Fate::Happens,
        Action::Solve(SolveAction::Begin) => Fate::Dropped,
        Action::Steer(Lead::Discard) => {
            Fate::Closed(tr!("Press Start afresh to lead the robots anew."))
        }
        Action::Steer(_) => match state.selected_agent() {
            Some(agent) if leads(state, lesson, agent) => Fate::Happens,
            _ => Fate::Closed(tr!("You lead another robot here. Select that one first.")),
        },
        Action::Inside(_) if lesson.shows_inside() => Fate::Happens,
        Action::Freedom(_) if lesson.shows(Layer::Freedom) => Fate::Happens,
        Action::Solve(_)
        | Action::Edit(_)
        | Action::Ask(_)
        | Action::Rules(_)
        | Action::Change(_)
        | Action::Audit(_)
        | Action::Inside(_)
        | Action::Freedom(_)
        | Action::Ledger(_)
        | Action::Order(_)
        | Action::Sizing(_)
        | Action::Area(_)
        | Action::Robots(_)
        | Action::Grow(_)
        | Action::Fleet(_)
        | Action::FloorPlan(_)
        | Action::Find(_) => Fate::Closed(NOT_NOW.text()),
    }
}

fn leads(state: &State, lesson: &Lesson, agent: usize) -> bool {
    let agents = state.document.agents();
    agents
        .get(agent)
        .is_some_and(|agent| lesson.leads(&agent.name))
}

impl State {
    /// The lesson on the board; a tour is none.
    pub fn lesson(&self) -> Option<&Lesson> {
        self.lesson.as_deref().filter(|lesson| !lesson.is_tour())
    }

    /// The agent that the text of a lesson names just now, by its index.
    pub fn named_agent(&self) -> Option<usize> {
        match &self.lesson()?.lit {
            Some(Lit::Robot(name)) => {
                let mut agents = self.world().agents().iter();
                agents.position(|agent| agent.name == *name)
            }
            _ => None,
        }
    }

    /// The cell that the text of a lesson names just now.
    pub fn named_cell(&self) -> Option<Cell> {
        match self.lesson()?.lit {
            Some(Lit::Cell(cell)) => Some(self.document.draft.clamp(cell)),
            _ => None,
        }
    }

    /// A person's own page: this one, or the one that a lesson put aside.
    pub fn own(&self) -> &Self {
        self.lesson.as_ref().map_or(self, |lesson| &lesson.own)
    }
}
