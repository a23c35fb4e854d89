//! What a lesson and the playground's page say to each other: two programs, plain data.
//!
//! The lesson says what the board shows and what may be done on it; the page says what
//! was done. Each board that is opened has a number, which all that the page says of it
//! carries: what it said of an earlier one is dropped.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::change::Changes;
use giveway_model::check::Violation;
use giveway_model::{Cell, Constraint, Cost, Plan, Scene, Zone};
use giveway_solve::change::Method;

use crate::lesson::{Layer, Tool};

/// The number of a board that was opened.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, BorshSerialize, BorshDeserialize,
)]
pub struct BoardNumber(pub u32);

/// From the lesson to the page.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum ToPage {
    /// Puts a scene on the board. What a person had there is put aside first.
    Open(Box<Board>),
    /// Lights a robot or a cell; nothing any more where there is none.
    Light(Option<Lit>),
    /// Goes to a time of the plan, and stops there.
    Go(u32),
    /// Plays the plan from the time shown.
    Play,
    /// Shows a plan as evidence, and what was hidden with it.
    Show(Box<Evidence>),
    /// Puts a seal on the cells that solved a task.
    Seal(Vec<Cell>),
    /// This robot, by its name, is led from where it is by now.
    Lead(String),
    /// The robot that is led waits for a step.
    Wait,
    /// Does what a person could do, on the board of a tour.
    Do(Deed),
    /// Takes the last edit, or the last step of a robot that is led, back.
    TakeBack,
    /// Puts the board back to what it was when it was opened; it has this number from
    /// then on.
    StartAfresh(BoardNumber),
    /// Asks for a person's own board as it is now: its scene, its plan and the time are
    /// told under the number 0, which no board of a lesson has.
    Take,
    /// Says why something that was done on the board does nothing, as a sentence.
    Say(String),
    /// Shows the page to a room.
    Present,
    /// Turns the page to a language, by its tag. The course hears of it as of any other
    /// choice.
    Speak(String),
    /// The lesson ends: a person's own scene comes back.
    Close,
}

/// What is on the board, and what may be done there.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Board {
    /// The number of the board.
    pub number: BoardNumber,
    /// The scene.
    pub scene: Scene,
    /// What is shown of a plan.
    pub plan: BoardPlan,
    /// What changes while that plan runs: the board shows it from then on.
    pub changes: Option<Changes>,
    /// The time shown first.
    pub time: u32,
    /// Whether the plan plays at once.
    pub playing: bool,
    /// The tools that are live.
    pub tools: Vec<Tool>,
    /// The most edits.
    pub edits: Option<u32>,
    /// The cells that may be changed; all where there is no list.
    pub cells: Option<Vec<Cell>>,
    /// What is shown beside the map.
    pub show: Vec<Layer>,
    /// What clicks and keys on the board are for.
    pub hand: Hand,
}

/// What the board shows of a plan.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum BoardPlan {
    /// There is none.
    None,
    /// This one, legal or not.
    Given(Plan),
    /// The best one: the page solves the scene.
    Best,
    /// It is hidden, and its timeline with it, until evidence is shown.
    Hidden,
}

/// What a person's hand does on the board, beside the tools.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Hand {
    /// It looks and selects.
    Looks,
    /// It leads these robots, step by step; the others go as the plan has it, and
    /// stand still where there is none.
    Leads(Vec<String>),
    /// It points at robots, cells and times, and each click is told.
    Points,
    /// It does whatever it likes: the page is as it is without a lesson. So a tour has
    /// it.
    Tours,
}

/// What a tour does for a person.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Deed {
    /// Selects a robot, by its name.
    Select(String),
    /// Asks the first question that is offered.
    Ask,
    /// Paints an obstacle.
    Paint(Cell),
    /// Solves the scene.
    Solve,
    /// Marks a zone and adds a rule.
    Rule(Zone, Constraint),
    /// Asks what the rules cost.
    Price,
}

/// A robot or a cell.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Lit {
    /// A robot, by its name.
    Robot(String),
    /// A cell.
    Cell(Cell),
}

/// What shows that something is so.
#[derive(Clone, Debug, Default, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Evidence {
    /// A plan.
    pub plan: Option<Plan>,
    /// What changes while the plan runs, where it goes on after that.
    pub changes: Option<Changes>,
    /// Broken rules, of that plan or of the one on the board.
    pub violations: Vec<Violation>,
    /// The time to go to.
    pub time: Option<u32>,
    /// Whether no plan is better than this one, as it is proved.
    pub proved: bool,
    /// What it would be without a rule.
    pub without: Option<Box<WithoutRule>>,
}

/// The best plan without a rule: beside the best one with it, or where no plan keeps the rule.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct WithoutRule {
    /// The rule, by its number in the scene, from 0.
    pub rule: u32,
    /// The plan without it.
    pub plan: Plan,
    /// What the rule costs, where there are plans with it.
    pub price: Option<RulePrice>,
}

/// What a rule costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct RulePrice {
    /// The first cost of the objective.
    pub cost: Cost,
    /// How much of it the best plan with the rule has.
    pub with: u32,
    /// How much of it the plan without the rule has.
    pub without: u32,
}

impl Evidence {
    /// Whether it shows a plan.
    pub const fn has_plan(&self) -> bool {
        self.plan.is_some() || self.without.is_some()
    }

    /// Whether it shows nothing.
    pub fn is_empty(&self) -> bool {
        !self.has_plan() && self.violations.is_empty() && self.time.is_none()
    }
}

/// From the page to the lesson.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct FromPage {
    /// The board that it is about.
    pub number: BoardNumber,
    /// What happened.
    pub what: Happened,
}

/// What happened on the board.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Happened {
    /// The scene was edited, or an edit was taken back.
    Board(Box<Scene>),
    /// A robot was led: the plan so far, of all robots.
    Led(Box<Plan>),
    /// Another robot is led now, by its name.
    Leads(String),
    /// A person pointed at something.
    Picked(Pick),
    /// Another time is shown.
    Time(u32),
    /// A person went on after a change by a method.
    Changed(Method),
    /// A person closed the lesson from the page.
    Closed,
    /// What a tour sees of the page is something else now.
    Seen(Sight),
}

/// What a tour sees of the page.
#[derive(Clone, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is seen by itself: none of them excludes another"
)]
pub struct Sight {
    /// The time shown.
    pub time: u32,
    /// The last time of the plan; 0 where there is none.
    pub last: u32,
    /// The robot that is selected, by its name.
    pub robot: Option<String>,
    /// Whether a question is asked.
    pub is_asking: bool,
    /// Whether the tool for obstacles is picked.
    pub paints: bool,
    /// Whether the scene is another one than at first.
    pub is_edited: bool,
    /// Whether the scene is solved as it is.
    pub is_solved: bool,
    /// Whether the tool for zones is picked.
    pub marks: bool,
    /// Whether a rule is being written.
    pub is_writing: bool,
    /// Whether the scene has a rule of its own.
    pub is_ruled: bool,
    /// Whether the prices of these rules are told.
    pub is_priced: bool,
}

/// What a person pointed at.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Pick {
    /// The cell.
    pub cell: Cell,
    /// The time shown then.
    pub time: u32,
    /// The robots that stood there, or were clicked, by their names.
    pub robots: Vec<String>,
}

impl ToPage {
    /// The message, to be posted.
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the bytes are none, as a sentence.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        borsh::from_slice(bytes).map_err(|error| error.to_string())
    }
}

impl FromPage {
    /// The message, to be posted.
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes(self)
    }

    /// Reads a posted message.
    ///
    /// # Errors
    /// When the bytes are none, as a sentence.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        borsh::from_slice(bytes).map_err(|error| error.to_string())
    }
}

fn to_bytes<T: BorshSerialize>(message: &T) -> Vec<u8> {
    // Memory always takes them, and no number in them is none.
    borsh::to_vec(message).unwrap_or_default()
}
