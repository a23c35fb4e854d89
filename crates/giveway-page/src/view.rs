//! What is shown of a document, and what a person's hand is doing: nothing that
//! anyone would miss.

use std::rc::Rc;

use giveway_model::Cell;

use crate::area::{Area, Clip};
use crate::asking::Found;
use crate::draw::Drawing;
use crate::find::Find;
use crate::fleet::Fleet;
use crate::floor_plan::FloorPlan;
use crate::freedom::Overlay;
use crate::gesture::Gesture;
use crate::grow::Growing;
use crate::ledger::LedgerView;
use crate::order::OrderView;
use crate::planners::By;
use crate::present::Presenting;
use crate::robots::RobotsView;
use crate::rules::RulesView;
use crate::sizing::SizingView;
use crate::slot::Waiting;
use crate::{Notice, Playback, Theme, Tool};

/// What the inspector tells of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// The plan as a whole.
    #[default]
    Nothing,
    /// An agent, by its index in the scene.
    Agent(usize),
    /// A cell.
    Cell(Cell),
}

/// What a phone shows below the board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The agent or cell selected.
    Inspector,
    /// The lanes.
    #[default]
    Timeline,
    /// The plan table.
    Plan,
}

/// What is drawn over the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layers {
    /// Ways behind and ahead.
    pub trails: bool,
    /// Cells shaded by how much they are used.
    pub heat: bool,
}

impl Default for Layers {
    fn default() -> Self {
        Self {
            trails: true,
            heat: false,
        }
    }
}

/// Where the page is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Place {
    /// In a window of its own.
    #[default]
    Own,
    /// Inside another page: a plan is watched, nothing is edited or kept.
    Embedded,
}

/// A cell that is to come into view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sought {
    /// The cell.
    pub cell: Cell,
    /// Tells it from the one before, which may have been the same cell.
    pub(crate) number: u32,
}

/// A part of the inspector that unfolds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    /// What is edited of the scene as a whole.
    Scene,
    /// What is edited of a robot.
    Robot,
}

/// Which parts of the inspector were unfolded (`true`) or folded; `None`: neither yet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Folds {
    scene: Option<bool>,
    robot: Option<bool>,
}

impl Folds {
    /// Whether a part is unfolded; nothing where that was not said of this scene.
    pub const fn of(&self, fold: Fold) -> Option<bool> {
        match fold {
            Fold::Scene => self.scene,
            Fold::Robot => self.robot,
        }
    }

    pub(crate) const fn set(&mut self, fold: Fold, is_open: bool) {
        match fold {
            Fold::Scene => self.scene = Some(is_open),
            Fold::Robot => self.robot = Some(is_open),
        }
    }
}

/// Which lanes are shown while two plans are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ComparedLanes {
    /// Those of the robots that differ.
    #[default]
    Differing,
    /// Those of all robots.
    All,
}

/// What is shown and how.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Where the page is shown.
    pub place: Place,
    /// Whether it is shown to a room.
    pub presenting: Presenting,
    /// The time shown, and the speed.
    pub playback: Playback,
    /// What the inspector tells of.
    pub selection: Selection,
    /// The agent that was selected before a cell was: questions at the cell are about it.
    pub(crate) asker: Option<usize>,
    /// What the pointer does on the board.
    pub tool: Tool,
    /// The shape that the tools draw, and its measures.
    pub drawing: Drawing,
    /// Robots that are to come onto the board at once.
    pub(crate) fleet: Option<Fleet>,
    /// A picture of the floor, under the grid.
    pub(crate) floor_plan: Option<Rc<FloorPlan>>,
    /// The part of the floor that is selected.
    pub(crate) area: Option<Area>,
    /// The size of the floor, on its way.
    pub(crate) growing: Option<Growing>,
    /// The table of the robots.
    pub(crate) robots: RobotsView,
    /// How many robots the floor bears.
    pub(crate) sizing: SizingView,
    /// What was copied of a floor.
    pub(crate) clip: Option<Rc<Clip>>,
    /// What the hand is doing on the board.
    pub(crate) gesture: Gesture,
    /// The cell of the keyboard on the board.
    pub cursor: Cell,
    /// What is drawn over the map.
    pub layers: Layers,
    /// Whether the camera goes with the agent selected.
    pub follow: bool,
    /// What is typed to find a robot, while one is looked for.
    pub find: Option<Find>,
    /// The cell that was to come into view last.
    pub sought: Option<Sought>,
    /// The broken rule of a plan of elsewhere that was gone to last, by its index.
    pub(crate) conflict: Option<usize>,
    /// A better plan that a question found.
    pub(crate) found: Option<Found>,
    /// Whose plan is to be shown beside the one on the board.
    pub(crate) versus: Option<By>,
    /// What is shown and written of the scene's own rules.
    pub(crate) rules: RulesView,
    /// What is laid over the plan: what must be so.
    pub(crate) overlay: Overlay,
    /// How the ledger of delays is shown.
    pub(crate) ledger: LedgerView,
    /// How the order of the plan is shown.
    pub(crate) order: OrderView,
    /// Which lanes are shown while two plans are compared.
    pub lanes: ComparedLanes,
    /// Which parts of the inspector are unfolded.
    pub folds: Folds,
    /// Whether the plan table is open.
    pub table: bool,
    /// Light or dark.
    pub theme: Theme,
    /// What a phone shows below the board.
    pub tab: Tab,
    /// Whether there is room for two boards, side by side or as pages of a phone: else the other
    /// plan of an answer takes the place of this one.
    pub is_wide: bool,
    /// What a person must be told once.
    pub notice: Option<Notice>,
    /// What the page has to say by itself, until its turn comes.
    pub waiting: Waiting,
}

impl Default for View {
    fn default() -> Self {
        Self {
            place: Place::Own,
            presenting: Presenting::Off,
            playback: Playback::default(),
            selection: Selection::Nothing,
            asker: None,
            tool: Tool::Select,
            drawing: Drawing::default(),
            fleet: None,
            floor_plan: None,
            area: None,
            clip: None,
            robots: RobotsView::default(),
            sizing: SizingView::default(),
            growing: None,
            gesture: Gesture::None,
            cursor: Cell::new(0, 0),
            layers: Layers::default(),
            follow: false,
            find: None,
            sought: None,
            conflict: None,
            found: None,
            versus: None,
            rules: RulesView::default(),
            overlay: Overlay::default(),
            ledger: LedgerView::default(),
            order: OrderView::default(),
            lanes: ComparedLanes::default(),
            folds: Folds::default(),
            table: true,
            theme: Theme::System,
            tab: Tab::Timeline,
            is_wide: false,
            notice: None,
            waiting: Waiting::default(),
        }
    }
}
