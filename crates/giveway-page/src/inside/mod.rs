//! How the plan was found and proved, to be stepped through: the proof of the search,
//! the tree of CBS, the orders of prioritised planning, the steps of PIBT, the configurations
//! of `LaCAM`.
//!
//! All of it is looked at and nobody would miss it: it belongs to the scene on the
//! board, and is asked again where that is another one.

mod action;
mod board;
pub mod by_hand;
mod column;
mod crowd;
mod legend;
mod looked;
mod looking;
mod node;
mod nothing;
mod order;
mod orders;
mod plan;
pub(crate) mod proof;
mod steps;
mod tree;

use std::rc::Rc;

use giveway_model::tr;
use giveway_solve::plan::Planner;
use giveway_solve::trace::Core;

pub use action::InsideAction;
pub(crate) use board::place as place_of;
pub use board::{Ban, Meeting, Overlay, Shade, overlay};
pub use by_hand::{ByHand, HandAction};
pub use column::{Button, Choice, Column, Fact, Listed, OrderRow, Tint, Verdict, column};
pub use legend::{Sign, legend};
pub(crate) use looked::{Looked, OrderRun, Told, TreeRun};
pub(crate) use looking::wanted;
pub use looking::{Looking, What};
pub use nothing::{Nothing, nothing, said};
pub use orders::{Note, Stop, notes};
pub(crate) use plan::{conflict_time, of_configuration, of_node, of_order, of_pibt, on_one_cell};
pub(crate) use proof::trace as record;
pub use proof::{Chart, Dot, Kind, ProofRow, Tick, chart, rows};
pub(crate) use steps::place;
pub use steps::{Steps, steps};
pub use tree::{Fold, NodeBox, TreeView, view as tree_view};

use crate::lesson::Lesson;
use crate::{Answer, State};

/// A way to find a plan that can be looked into.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The search for the best plan and its proof.
    #[default]
    Proof,
    /// CBS: a tree of constraints.
    Tree,
    /// Prioritised planning: one order after the other.
    Orders,
    /// PIBT: one step of all robots after the other.
    Pibt,
    /// `LaCAM`: one configuration after the other.
    Lacam,
}

impl Method {
    /// All, in the order of their tabs.
    pub const ALL: [Self; 5] = [
        Self::Proof,
        Self::Tree,
        Self::Orders,
        Self::Pibt,
        Self::Lacam,
    ];

    /// The planner that it looks into; `None`: the search for the best plan.
    pub(crate) const fn planner(self) -> Option<Planner> {
        match self {
            Self::Proof => None,
            Self::Tree => Some(Planner::Cbs),
            Self::Orders => Some(Planner::Prioritised),
            Self::Pibt => Some(Planner::Pibt),
            Self::Lacam => Some(Planner::Lacam),
        }
    }

    /// Its name.
    pub fn title(self) -> &'static str {
        match self {
            Self::Proof => tr!("a method" => "Bounds"),
            Self::Tree => tr!("Conflict tree"),
            Self::Orders => tr!("One by one"),
            Self::Pibt => "PIBT",
            Self::Lacam => "LaCAM",
        }
    }

    /// The entry of the menu that opens it.
    pub fn entry(self) -> &'static str {
        match self {
            Self::Proof => tr!("How it was proved: bounds"),
            Self::Tree => tr!("How it was proved: conflict tree"),
            Self::Orders => tr!("How it was proved: one by one"),
            Self::Pibt => tr!("How it was found: PIBT"),
            Self::Lacam => tr!("How it was found: LaCAM"),
        }
    }
}

/// What is looked at of how the plan was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inside {
    /// Whether it has the place of the lanes.
    pub is_open: bool,
    /// Of which method.
    pub method: Method,
    /// Whether its steps follow each other by themselves.
    pub is_playing: bool,
    /// The time of the plan that was shown before: leaving brings it back.
    pub(crate) time_before: Option<u32>,
    /// The step of the proof, by its row; `None`: the last one, whichever that is.
    pub(crate) step: Option<usize>,
    /// The robots that are looked at alone.
    pub(crate) alone: Option<AloneView>,
    /// The node of the tree, by its number.
    pub(crate) node: u64,
    /// The search by hand.
    pub by_hand: ByHand,
    /// The order, by its place in the list.
    pub(crate) order: usize,
    /// How many of its robots have planned; `None`: all.
    pub(crate) robots: Option<usize>,
    /// The step of PIBT, or of `LaCAM`.
    pub(crate) moment: usize,
    /// What was found out about the scene.
    pub(crate) looked: Option<Rc<Looked>>,
    /// The plan of the node, or of the order so far.
    pub(crate) shown: Option<Rc<Answer>>,
}

/// Some robots that are looked at alone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AloneView {
    /// The step that they are of.
    pub(crate) core: Rc<Core>,
    /// The row of that step among those of all robots.
    pub(crate) back: usize,
}

impl State {
    /// Whether the page shows how the plan was found.
    pub fn is_inside(&self) -> bool {
        self.inside.is_open && self.can_look_inside()
    }

    /// Whether there is something to look into: nothing else is done with the plan.
    pub fn can_look_inside(&self) -> bool {
        let is_wanted = self.lesson().is_none_or(Lesson::shows_inside);
        self.document.mode.is_editing() && !self.is_embedded() && is_wanted
    }

    /// Whether it stays open: a lesson that shows it has nothing else in its place.
    pub fn keeps_inside(&self) -> bool {
        let is_alone =
            |it: &Lesson| it.shows_inside() && !it.shows(giveway_course::lesson::Layer::Lanes);
        self.is_inside() && self.lesson().is_some_and(is_alone)
    }

    /// How many steps there are to go through.
    pub(crate) fn inside_steps(&self) -> usize {
        steps::place(self).map_or(0, |(_, last, _)| last)
    }

    /// The plan of the node or the order that is looked at.
    pub(crate) fn inside_plan(&self) -> Option<&Rc<Answer>> {
        let is_other = self.is_inside() && self.inside.method != Method::Proof;
        self.inside
            .shown
            .as_ref()
            .filter(|answer| is_other && (Rc::ptr_eq(&answer.draft, &self.document.draft)))
    }

    /// The plan of the step of a planner of crowds that is looked at.
    pub fn inside_answer(&self) -> Option<&Rc<Answer>> {
        self.inside_plan()
    }

    /// What was found out about the scene on the board.
    pub(crate) fn looked(&self) -> Option<&Looked> {
        let looked = self.inside.looked.as_deref()?;
        let is_of = looked.is_of(&self.document) && self.document.changed_last().is_none();
        is_of.then_some(looked)
    }
}

/// The index of a robot on the board.
pub(crate) fn index(state: &State, name: &str) -> Option<usize> {
    let mut agents = state.document.draft.agents().iter();
    agents.position(|agent| agent.name == name)
}
