//! Who passes a cell after whom: the order of the plan on the board, one cell at a time, and
//! what follows from it when a robot is late.

mod column;
mod crossing;
mod export;
mod known;
mod lanes;
mod late;
mod links;
mod strip;

use std::rc::Rc;

use giveway_model::Cell;
use giveway_order::Order;

use crate::{Activity, Answer, State, Task};

pub use column::{Column, ExportRow, PassRow, column};
pub use export::OrderExport;
pub(crate) use known::OrderKnown;
pub use lanes::{LaneLink, LaneOrder, Stay, fate, lane_order, lanes};
pub use late::{ArrivalRow, LateCard, MOST_LATE};
pub(crate) use late::{LateView, status};
pub use links::{LinkRow, Links};
pub use strip::{Strip, StripRobot, legend, notes, strip};

pub(crate) use column::gap;
pub(crate) use crossing::visits_at;
pub(crate) use export::written;
pub(crate) use late::{begins as late_begins, first as first_late};

/// What a person does with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OrderAction {
    /// Opens it below the board, or leaves it.
    Show(bool),
    /// The cell that it is about.
    At(Cell),
    /// Asks what follows if a robot is late, or leaves that.
    Late(bool),
    /// The robot that is late, by its place among the robots of the order.
    Robot(usize),
    /// How late it comes, in steps.
    Steps(u32),
    /// The visit that it comes late to, by its number from 0.
    To(usize),
    /// Changes the world at the time of the lateness, with it as a breakdown.
    Replan,
    /// Shows all links as a table, or leaves that.
    Links(bool),
    /// Adds the rule `gap`, under which no link is without slack.
    AddGap,
    /// Saves the order as a file.
    Save(OrderExport),
}

/// How it is shown. It is shown where it is of the plan on the board.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OrderView {
    pub(crate) is_open: bool,
    /// The cell that was chosen; `None`: the one with the most links.
    pub(crate) cell: Option<Cell>,
    /// The lateness that is asked about.
    pub(crate) late: Option<LateView>,
    /// Whether all links are shown as a table.
    pub(crate) is_whole: bool,
    /// The format that was saved last.
    pub(crate) export: OrderExport,
}

impl State {
    /// Whether the order can be asked for: the board has a plan of a person's own scene.
    pub fn can_order(&self) -> bool {
        let answer = self.document.fresh_answer();
        let has_plan = answer.is_some_and(|answer| answer.plan().is_some());
        let is_editing = self.document.mode.activity == Activity::Editing;
        has_plan && is_editing && self.lesson().is_none()
    }

    /// Whether the order is offered among the questions about the plan as a whole.
    pub fn offers_order(&self) -> bool {
        let is_idle = self.document.mode.asking().is_none() && !self.shows_order();
        is_idle && self.can_order() && self.document.agents().len() > 1
    }

    /// Whether the lanes stand in the order at a cell.
    pub fn shows_order(&self) -> bool {
        self.order_known().is_some()
    }

    /// What is known of the order, where it is open and the board has nothing else to show.
    pub(crate) fn order_known(&self) -> Option<&Rc<OrderKnown>> {
        let is_hidden = self.is_inside() || self.hides_answers() || self.so_far().is_some();
        let is_open = self.view.order.is_open && self.document.mode.is_editing() && !is_hidden;
        if is_open { self.document.order() } else { None }
    }

    /// Whether the order is being made.
    pub(crate) fn is_ordering(&self) -> bool {
        matches!(self.work.task(), Some(Task::Order(_)))
    }

    /// The order that is shown.
    pub(crate) fn order(&self) -> Option<&Order> {
        self.order_known()?.told.as_deref()?.order.as_ref()
    }

    /// The cell that the order is shown at.
    pub fn order_cell(&self) -> Option<Cell> {
        let order = self.order()?;
        self.view.order.cell.or_else(|| crossing::busiest(order))
    }

    /// Whether a lateness is asked about, of which nothing is known and nothing is looked for.
    pub(crate) fn late_outcome_is_lost(&self) -> bool {
        self.shows_order() && !self.is_ordering() && late::outcome(self).is_none()
    }

    /// The plan as it is carried out when the robot is late, where that is asked about.
    pub(crate) fn late_plan(&self) -> Option<&Rc<Answer>> {
        late::outcome(self)?.answer.as_ref()
    }
}
