//! Edits: one vocabulary for the brush, the inspector, repairs, things dragged by
//! hand, and changes of the world.
//!
//! An edit is plain data with two interpreters: [`Sketch`] makes it of the scene
//! as it is now, [`world`] of the world from a time on.

mod area;
mod fill;
mod grow;
mod places;
mod repair;
mod reshape;
mod rules;
mod scene;
mod sketch;
pub(crate) mod world;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::constraint::Heading;
use giveway_model::{Agent, AtGoal, Battery, Cell, Constraint, Objective, Units};

use crate::area::{Clip, Way};

pub use fill::{DENSEST, Fill};
pub(crate) use repair::repair;
pub(crate) use scene::fresh_name;
pub(crate) use sketch::Sketch;

/// What a brush paints on a cell, and takes away again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// An obstacle.
    Obstacle,
    /// A charger; it stays in a slow zone.
    Charger,
    /// A part of the slow zone; a charger stays in it.
    Slow,
}

/// One change that a person makes. Agents are told by their index: in the scene,
/// or among all that there ever are in a world that changes.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Paints a cell (`true`), or takes away what was painted.
    Paint(Paint, Cell, bool),
    /// Paints cells; those that a robot needs stay free of obstacles.
    PaintCells(Paint, Vec<Cell>),
    /// Takes away what is on a cell.
    Erase(Cell),
    /// Moves an obstacle or a charger from a cell to another one.
    MovePaint(Paint, Cell, Cell),

    /// An agent comes onto the board.
    AddAgent(Agent),
    /// Several agents come onto the board.
    AddAgents(Vec<Agent>),
    /// All agents as they are now: the first of them are those that there were.
    PutAgents(Vec<Agent>),
    /// Takes an agent away.
    RemoveAgent(usize),
    /// Takes several agents away.
    RemoveAgents(BTreeSet<usize>),
    /// Where an agent begins.
    SetStart(usize, Cell),
    /// Where an agent has to arrive.
    SetGoal(usize, Cell),
    /// A further cell that an agent has to visit.
    AddWaypoint(usize, Cell),
    /// Takes a waypoint of an agent away.
    DropWaypoint(usize, Cell),
    /// Moves a waypoint of an agent from a cell to another one.
    MoveWaypoint(usize, Cell, Cell),
    /// The battery of an agent; `None` is unlimited. It begins at most full.
    SetBattery(usize, Option<Battery>),
    /// The level of an agent's battery from now on.
    SetLevel(usize, u32),
    /// An agent stands still for so many steps.
    Delay(usize, u32),
    /// An agent breaks down for good: it is removed, and its cell is an obstacle.
    Stop(usize),
    /// What an agent is called; an empty name leaves it as it is.
    Rename(usize, String),
    /// Where an agent faces at its start; `None` is open.
    Face(usize, Option<Heading>),

    /// What the scene is called.
    Name(String),
    /// Columns and rows; what no longer is on the map is taken away.
    Resize(u32, u32),
    /// A free map of the same size, and nobody on it.
    Clear,
    /// Obstacles and agents by chance.
    Fill(Fill),
    /// The costs to minimise.
    Objective(Objective),
    /// What happens to arrived agents.
    AtGoal(AtGoal),
    /// The side of a cell and the length of a step; `None` takes them away.
    Units(Option<Units>),
    /// The least battery level.
    BatteryFloor(u32),
    /// The horizon in time steps.
    Within(Option<u32>),
    /// A rule of the scene's own, by its index, asks for less.
    WeakenRule(usize, Weaker),
    /// Zones and rules of the scene's own.
    Rules(RuleEdit),
    /// A part of the floor as a whole.
    Area(AreaEdit),
    /// Rows and columns of the floor come or go.
    Grow(Reshape, Lost),
    /// Gives an agent, by its index, one of the colours.
    Recolour(usize, usize),
}

/// An edit of zones and of rules of the scene's own. Rules are told by their index, zones by
/// their name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RuleEdit {
    /// Adds a cell to a zone (`true`), or takes it away.
    PaintZone(String, Cell, bool),
    /// The same of all cells between two corners, both included.
    PaintRect(String, Cell, Cell, bool),
    /// What a zone is called; an empty name leaves it as it is.
    RenameZone(String, String),
    /// Removes a zone, with the rules that are about it.
    RemoveZone(String),
    /// Adds a rule, or puts it in the place of another one.
    Put(Option<usize>, Constraint),
    /// Removes a rule.
    Remove(usize),
    /// Puts a rule in force, or out of it.
    Switch(usize),
    /// Lays a one-way lane along cells; a lane that is there turns round.
    Lane(Vec<Cell>),
}

/// Which rows and columns of the floor come or go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reshape {
    /// Those at its sides.
    Sides(Sides),
    /// Some beside each other.
    Lines(Lines),
}

/// Columns or rows beside each other that come or go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lines {
    /// Which of the two.
    pub axis: Axis,
    /// The first one that goes, or that moves to make room.
    pub at: u32,
    /// How many come; below 0, how many go.
    pub more: i32,
}

/// Columns or rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Columns, from the left.
    Columns,
    /// Rows, from above.
    Rows,
}

/// Rows and columns more at each side of the floor, or less.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sides {
    /// Columns at the left.
    pub left: i32,
    /// Rows above.
    pub top: i32,
    /// Columns at the right.
    pub right: i32,
    /// Rows below.
    pub bottom: i32,
}

/// What becomes of what robots have on cells that go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lost {
    /// It moves to the nearest free cell.
    #[default]
    Move,
    /// Robots that start or end there go, and waypoints there.
    Remove,
}

/// An edit of a part of the floor as a whole.
#[derive(Clone, Debug, PartialEq)]
pub enum AreaEdit {
    /// What is on these cells goes elsewhere.
    Move(Rc<BTreeSet<Cell>>, Way),
    /// What was copied comes so many cells right and down of where it was.
    Put(Rc<Clip>, (i32, i32)),
    /// What is on these cells is taken away.
    Erase(Rc<BTreeSet<Cell>>),
}

/// What a rule of the scene's own does not ask for any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weaker {
    /// It is switched off.
    Off,
    /// It allows so many agents in its zone, or wait steps on end.
    Most(u32),
    /// It leaves the time until then.
    Until(u32),
}

impl Edit {
    /// Whether it puts another scene in the place of the one that there is: a
    /// plan of that is then nothing to go on with.
    pub(crate) const fn is_afresh(&self) -> bool {
        matches!(self, Self::Clear | Self::Fill(_))
    }
}
