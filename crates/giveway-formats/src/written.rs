//! A plan as a file writes it, before anybody decides what its numbers and
//! letters mean.

use super::{Conventions, WrittenAt, WrittenCell};
use giveway_model::LeftOutRule;
use giveway_model::compare::{Claimed, ClaimedBounds};

/// Two numbers of a file that stand for a cell, in the order of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pair {
    /// The number that is written first.
    pub first: i32,
    /// The number that is written second.
    pub second: i32,
}

impl Pair {
    /// A pair of numbers.
    pub const fn new(first: i32, second: i32) -> Self {
        Self { first, second }
    }
}

/// A step that is named by its direction, for an agent that may go everywhere
/// at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// `u`; whether that raises or lowers `y` is a matter of convention.
    Up,
    /// `d`, the opposite.
    Down,
    /// `l`: `x - 1`.
    Left,
    /// `r`: `x + 1`.
    Right,
    /// `w`: stays.
    Wait,
}

impl Move {
    /// Its step in `x` and `y`, up being the row above.
    pub const fn offset(self) -> (i32, i32) {
        match self {
            Self::Up => (0, -1),
            Self::Down => (0, 1),
            Self::Left => (-1, 0),
            Self::Right => (1, 0),
            Self::Wait => (0, 0),
        }
    }

    /// The move that adds so much to `x` and `y`, up being the row above.
    pub(crate) fn of_offset(offset: (i64, i64)) -> Option<Self> {
        match offset {
            (0, -1) => Some(Self::Up),
            (0, 1) => Some(Self::Down),
            (-1, 0) => Some(Self::Left),
            (1, 0) => Some(Self::Right),
            (0, 0) => Some(Self::Wait),
            _ => None,
        }
    }
}

/// An action of an agent that must turn before it goes elsewhere (the action
/// model `MAPF_T`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// One cell ahead.
    Forward,
    /// A quarter turn clockwise, at its cell.
    Clockwise,
    /// A quarter turn counterclockwise, at its cell.
    Counterclockwise,
    /// Stays as it is.
    Wait,
}

/// How a file writes where an agent goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Walk {
    /// A cell at each time from 0.
    Cells(Vec<Pair>),
    /// A move a step, from its start.
    Moves(Vec<Move>),
    /// A move a step, where the format leaves no doubt that up is to the row above.
    Fixed(Vec<Move>),
    /// An action a step, from its start; it faces this direction at time 0.
    Turns(super::Heading, Vec<Action>),
}

/// The act of an agent with shelves and goods at its cell (asprilo).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handling {
    /// Lifts the shelf above it.
    PickUp,
    /// Delivers a product for an order.
    Deliver {
        /// The number of the order.
        order: i32,
        /// The number of the product.
        product: i32,
        /// How much, where that is said.
        amount: Option<i32>,
    },
}

/// An agent of a written plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenAgent {
    /// Its name, where the file gives one.
    pub name: Option<String>,
    /// Where it starts, where the file says so.
    pub start: Option<WrittenCell>,
    /// Where it is to go, where the file says so.
    pub goal: Option<WrittenCell>,
    /// Cells that it is to visit on the way.
    pub waypoints: Vec<WrittenCell>,
    /// Its acts on the way, each with the time of its end.
    pub handling: Vec<(usize, Handling)>,
    /// Where it goes.
    pub walk: Walk,
    /// Where the file writes that.
    pub at: WrittenAt,
}

impl WrittenAgent {
    /// An agent of which the file gives nothing but its walk.
    pub const fn walking(walk: Walk, at: WrittenAt) -> Self {
        Self {
            name: None,
            start: None,
            goal: None,
            waypoints: Vec::new(),
            handling: Vec::new(),
            walk,
            at,
        }
    }
}

/// A plan as a file writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenPlan {
    /// The name of the map that it is for, as it is written, where the file says so.
    pub map: Option<String>,
    /// The agents, in the order of the file.
    pub agents: Vec<WrittenAgent>,
    /// The costs that it claims.
    pub claimed: Claimed,
    /// The lower bounds of every plan that it claims.
    pub bounds: ClaimedBounds,
    /// Rules of its problem that scenes do not have.
    pub left_out: Vec<LeftOutRule>,
    /// The conventions that the format's makers document.
    pub documented: Conventions,
    /// Remarks for a person, each a sentence: `The file says itself that the plan is not valid.`
    pub notes: Vec<String>,
}

impl WrittenPlan {
    /// A plan of which the file gives nothing but its agents.
    pub fn new(agents: Vec<WrittenAgent>, documented: Conventions) -> Self {
        Self {
            map: None,
            agents,
            claimed: Claimed::default(),
            bounds: ClaimedBounds::default(),
            left_out: Vec::new(),
            documented,
            notes: Vec::new(),
        }
    }
}
