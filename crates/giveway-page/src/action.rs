//! What can happen to the page, by the place where it does.

mod ask;
mod file;
mod worker;

use std::rc::Rc;

use giveway_model::Cell;
use giveway_solve::plan::Planner;

use crate::area::AreaAction;
use crate::audit::AuditAction;
use crate::changing::{Choice, Filled};
use crate::draw::{Measure, Shape};
use crate::files::Opened;
use crate::find::FindAction;
use crate::fleet::FleetAction;
use crate::floor_plan::FloorPlanAction;
use crate::freedom::FreedomAction;
use crate::grow::GrowAction;
use crate::inside::InsideAction;
use crate::intake::{Save, protocol::Reply};
use crate::ledger::LedgerAction;
use crate::lesson::LessonAction;
use crate::order::OrderAction;
use crate::planners::By;
use crate::present::Presenting;
use crate::robots::RobotsAction;
use crate::rules::RuleAction;
use crate::sizing::SizingAction;
use crate::slot::SlotAction;
use crate::steering::Lead;
use crate::{ComparedLanes, Edit, Fill, Fold, Selection, Speed, Tab, Theme, Tool};

pub use ask::AskAction;
pub use file::FileAction;
pub use worker::WorkerAction;

/// What a person did, what the solver told, or that time went on.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Documents come and go.
    File(FileAction),
    /// An edit beside the board: of the scene, or of the world where that changes.
    Edit(Edit),
    /// Takes the last step back.
    Undo,
    /// Takes the last undo back.
    Redo,
    /// On the board.
    Board(BoardAction),
    /// The solver.
    Solve(SolveAction),
    /// A worker tells of its job.
    Worker(WorkerAction),
    /// Questions.
    Ask(AskAction),
    /// The world changes while a plan runs.
    Change(ChangeAction),
    /// An agent is led by hand, in a plan of one's own.
    Steer(Lead),
    /// A plan of elsewhere is judged.
    Audit(AuditAction),
    /// How the plan was found is looked into.
    Inside(InsideAction),
    /// A robot is looked for by its name.
    Find(FindAction),
    /// A part of the floor is selected, or something is done with it.
    Area(AreaAction),
    /// The floor gets rows and columns, or loses some.
    Grow(GrowAction),
    /// The table of the robots.
    Robots(RobotsAction),
    /// Several robots are to come onto the board.
    Fleet(FleetAction),
    /// How many robots does the floor bear?
    Sizing(SizingAction),
    /// A picture of the floor is under the grid.
    FloorPlan(FloorPlanAction),
    /// What all best plans share is laid over the plan.
    Freedom(FreedomAction),
    /// Who costs whom is asked of the plan.
    Ledger(LedgerAction),
    /// Who passes a cell after whom is asked of the plan.
    Order(OrderAction),
    /// Other people's files come in and go out.
    Intake(IntakeAction),
    /// The plan plays.
    Play(PlayAction),
    /// Rules of the scene's own.
    Rules(RuleAction),
    /// What is shown and how.
    View(ViewAction),
    /// The page has something to say by itself, or was heard.
    Slot(SlotAction),
    /// A lesson is on the board.
    Lesson(LessonAction),
}

/// Other people's files come in and go out, by way of the reader.
#[derive(Clone, Debug, PartialEq)]
pub enum IntakeAction {
    /// Files were opened that the page does not read by itself.
    Read(Vec<Opened>),
    /// The page's own files came that may be what is missing.
    Fetched {
        /// The number of the job.
        job: u64,
        /// Those that are there.
        files: Vec<Opened>,
    },
    /// The reader told how far it is.
    Progress {
        /// The number of the job.
        job: u64,
        /// A sentence.
        sentence: String,
    },
    /// The reader answered.
    Reply {
        /// The number of the job.
        job: u64,
        /// What.
        reply: Rc<Reply>,
    },
    /// The reader broke off, or did not even start.
    Crash {
        /// The number of the job.
        job: u64,
        /// Whether it had started; else it did not even do that.
        had_started: bool,
        /// Why, and what can be done, each a sentence.
        details: Vec<String>,
    },
    /// Something is to be written in another format.
    Save(Save),
    /// What was written is saved, or not wanted any longer.
    Saved,
}

/// On the board.
#[derive(Clone, Debug, PartialEq)]
pub enum BoardAction {
    /// A tool was picked.
    PickTool(Tool),
    /// A shape to draw was picked.
    PickShape(Shape),
    /// A measure of the shapes was set, in cells.
    SetMeasure(Measure, u32),
    /// The keyboard's place on the board is this cell now.
    MoveCursor(Cell),
    /// The keyboard went so many cells right and down from where it is, as far
    /// as the map goes. It says how far and not where to: keys can come faster
    /// than the page is drawn.
    StepCursor {
        /// Cells to the right, and down.
        by: (i32, i32),
        /// Whether what is there goes along.
        carries: bool,
    },
    /// A key applied the tool where the keyboard is.
    UseTool,
    /// The pointer went down on a cell.
    Press(Cell),
    /// The pointer went down on a cell, or a key applied the tool, in another way:
    /// with tools that paint, or that mark cells for rules.
    Mark {
        /// The cell.
        cell: Cell,
        /// Whether it takes cells away.
        takes: bool,
        /// Whether it draws a rectangle.
        is_rect: bool,
    },
    /// The pointer went on through cells, all since the last frame.
    Drag(Vec<Cell>),
    /// The pointer was lifted.
    Release,
    /// Removes what is selected.
    Delete,
    /// Leaves the stroke, or the agent being placed, as if it had never begun.
    Abandon,
    /// The selection changed.
    Select(Selection),
}

/// The solver.
#[derive(Clone, Debug, PartialEq)]
pub enum SolveAction {
    /// Solve the scene that the page opens on: it is no step of its own.
    Begin,
    /// Solve the scene on the board, from the best plan so far where there is one.
    Solve,
    /// Plan the scene with a planner of the textbook.
    Plan(Planner),
    /// Show the plan that one of the planners has for the scene.
    ShowPlan(By),
    /// Show it beside the plan on the board, or no longer.
    ShowBeside(By),
    /// Stop what runs, at once.
    Cancel,
    /// Show a plan of the front, by its number.
    ShowPoint(usize),
    /// Prove again what was answered last, of question or plan, and check the proofs.
    CheckProof,
    /// Make certificates of what the inspector tells, and save them.
    SaveProof,
}

/// The world changes while a plan runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChangeAction {
    /// The world changes at the time shown.
    Begin,
    /// An agent breaks down at the time shown, by its index.
    BreakDown(usize),
    /// A slot of the sentence of a listed breakdown is filled, by its place in the list.
    Fill(usize, Filled),
    /// Leave what changes, as if it did not.
    Discard,
    /// Take a listed change back, by its place in the list.
    TakeBack(usize),
    /// The methods to try.
    ChooseMethods(Choice),
    /// Ask the methods how to go on.
    Adapt,
    /// Preview the plan of a method, by its place.
    Preview(usize),
    /// Adopt the plan of a method, by its place.
    Adopt(usize),
}

/// The plan plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlayAction {
    /// Play from the time shown, or from the start where it is the end.
    Play,
    /// Stop at the next step.
    Pause,
    /// Show a time.
    Seek(u32),
    /// The next time at which two plans differ, or the one before (`false`).
    Difference(bool),
    /// One step on.
    StepForward,
    /// One step back.
    StepBack,
    /// The plan played on to a step.
    Reach(u32),
    /// How fast to play.
    SetSpeed(Speed),
}

/// What is shown and how; and what a person set for all scenes.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewAction {
    /// The notice was read.
    DismissNotice,
    /// Shows or hides ways behind and ahead.
    ShowTrails(bool),
    /// Shades cells by how much they are used, or not.
    ShowHeat(bool),
    /// Which lanes are shown while two plans are compared.
    ShowLanes(ComparedLanes),
    /// Lets the camera go with the agent selected, or not.
    Follow(bool),
    /// Shows or hides the plan table.
    ShowTable(bool),
    /// Unfolds a part of the inspector, or folds it.
    Unfold(Fold, bool),
    /// What a phone shows below the board.
    ShowTab(Tab),
    /// Whether there is room for two boards side by side.
    SetWide(bool),
    /// Shows the page to a room, or to one person again.
    Present(Presenting),
    /// Light or dark.
    SetTheme(Theme),
    /// The time limit in seconds.
    SetSeconds(u32),
    /// Whether every edit is solved at once.
    SetSolveOnChange(bool),
    /// Whether all plans of the Pareto front are sought.
    SetFront(bool),
    /// What is strewn by chance next time.
    SetFill(Fill),
    /// Whether single letters are keys.
    SetLetterKeys(bool),
}
