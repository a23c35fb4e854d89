//! What can happen to the page.

use giveway_model::change::What;
use giveway_model::{AtGoal, Cell, Objective, Question, Scene};
use giveway_solve::{Progress, Response};

use crate::changing::Choice;
use crate::link::Linked;
use crate::steering::Lead;
use crate::{Edit, Fill, Lit, Notice, Selection, Speed, Tab, Theme, Tool};

/// What a person did, what the solver told, or that time went on.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// A scene was opened: it replaces the one on the board.
    Open(Box<Scene>),
    /// A link was opened: its scene replaces the one on the board.
    OpenLink(Box<Linked>),
    /// Something could not be done; the scene stays.
    Refuse(Notice),
    /// The notice was read.
    DismissNotice,

    /// A tool was picked.
    PickTool(Tool),
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
    /// The pointer went on to a cell.
    Drag(Cell),
    /// The pointer was lifted.
    Release,
    /// Leaves the stroke, or the agent that is being placed, as if it had never
    /// begun.
    Abandon,
    /// The selection changed.
    Select(Selection),
    /// An edit that is made beside the board.
    Edit(Edit),
    /// What is strewn by chance next time.
    SetFill(Fill),
    /// Takes the last edit back.
    Undo,
    /// Takes the last undo back.
    Redo,

    /// The costs to minimise.
    SetObjective(Objective),
    /// What happens to arrived agents.
    SetAtGoal(AtGoal),
    /// The least battery level.
    SetBatteryFloor(u32),
    /// The horizon in time steps.
    SetWithin(Option<u32>),
    /// The time limit in seconds.
    SetSeconds(u32),
    /// Whether every edit is solved at once.
    SetSolveOnChange(bool),
    /// Whether all plans of the Pareto front are sought.
    SetFront(bool),
    /// Show a plan of the front, by its number.
    ShowPoint(usize),

    /// Solve the scene on the board.
    Solve,
    /// Stop solving, at once.
    Cancel,
    /// The solver got to know something; `run` is [`crate::Run::id`].
    Progress {
        /// The run.
        run: u64,
        /// What became known.
        event: Progress,
    },
    /// The solver answered.
    Respond {
        /// The run.
        run: u64,
        /// The answer.
        response: Box<Response>,
    },
    /// The solver ended without an answer.
    Crash {
        /// The run.
        run: u64,
        /// Why, as a sentence.
        sentence: String,
        /// Whether it broke off and was replaced; else it did not even start.
        had_started: bool,
    },

    /// Ask a question about the plan that is shown.
    Ask(Question),
    /// Leave the question.
    CloseQuestion,
    /// Show the other plan, or this one again.
    ShowOther(bool),
    /// Light something of the answer up on the map.
    Light(Option<Lit>),
    /// Make the other plan the plan.
    TakeOther,
    /// Make the edits of a repair, by its index.
    TakeRepair(usize),

    /// Prove again what was answered last, to the question or of the plan, and
    /// check the proofs.
    CheckProof,

    /// The world changes at the time shown, while the plan runs.
    BeginChange,
    /// Leave what changes, as if it did not.
    DiscardChange,
    /// List a change beside the board.
    ListChange(What),
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

    /// Lead an agent by hand, in a plan of one's own.
    Steer(Lead),

    /// Play from the time shown, or from the start where it is the end.
    Play,
    /// Stop at the next step.
    Pause,
    /// Show a time.
    Seek(u32),
    /// One step on.
    StepForward,
    /// One step back.
    StepBack,
    /// The plan played on to a step.
    Reach(u32),
    /// How fast to play.
    SetSpeed(Speed),

    /// Shows or hides ways behind and ahead.
    ShowTrails(bool),
    /// Shades cells by how much they are used, or not.
    ShowHeat(bool),
    /// Lets the camera go with the agent selected, or not.
    Follow(bool),
    /// Gives an agent, by its index in the scene, one of the colours.
    Recolour(usize, usize),
    /// Shows or hides the plan table.
    ShowTable(bool),
    /// What a phone shows below the board.
    ShowTab(Tab),
    /// Whether there is room for two boards side by side.
    SetWide(bool),
    /// The colours.
    SetTheme(Theme),
}
