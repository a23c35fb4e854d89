//! What the hand is doing on the board: a stroke, or an agent on its way onto
//! the board. The document stays as it is until the hand is lifted: then what was
//! done becomes one step of undo, or none.

mod canvas;
mod shaped;
mod stroke;
mod thing;

use std::rc::Rc;

use giveway_model::Cell;

use crate::area::Hand;

pub(crate) use canvas::Canvas;
pub(crate) use shaped::{Ink, Shaped};
pub(crate) use stroke::{Hold, Stroke};
pub(crate) use thing::Thing;

/// What the hand is doing on the board.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Gesture {
    /// Nothing.
    #[default]
    None,
    /// A stroke.
    Stroke(Rc<Stroke>),
    /// An agent is being placed.
    Placing(Placing),
    /// A row of starts or goals is being drawn.
    Row,
    /// A part of the floor is being framed, stretched or moved.
    Area(Rc<Hand>),
}

/// An agent on its way onto the board: its start is chosen, its goal not yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placing {
    /// Where it will start.
    pub start: Cell,
    /// Where the pointer or the keyboard is: its goal, as far as known.
    pub goal: Cell,
    /// Whether the pointer is down.
    pub is_held: bool,
    /// Whether the goal was pressed by itself: then it may be the start, too.
    pub(crate) is_second: bool,
}
