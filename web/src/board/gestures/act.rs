//! What a press comes to: a stroke of a brush, or a selection.

use giveway_model::Cell;
use giveway_page::board::zone_at;
use giveway_page::freedom::{FreedomAction, pressed};
use giveway_page::rules::RuleAction;
use giveway_page::steering::Lead;
use giveway_page::{Action, BoardAction, Selection, Tool};
use web_sys::PointerEvent;

use super::place::Px;
use super::{Act, Surface};
use crate::board::coalesced::places;
use crate::board::freedom::reads_numbers;
use crate::inspector;

impl Surface {
    pub(super) fn paints(&self) -> bool {
        self.state.view.tool != Tool::Select
    }

    /// Begins a stroke at a pixel, if that is on the map. Shift draws a rectangle, Alt takes
    /// away, with a tool that knows these.
    pub(super) fn begin_stroke(&self, at: Px, event: &PointerEvent) -> Act {
        match self.cell(self.frame.point(at)) {
            Some(cell) => {
                let (takes, is_rect) = (event.alt_key(), event.shift_key());
                self.send.emit(Action::Board(if takes || is_rect {
                    BoardAction::Mark {
                        cell,
                        takes,
                        is_rect,
                    }
                } else {
                    BoardAction::Press(cell)
                }));
                Act::Paint(cell)
            }
            None => Act::Spent,
        }
    }

    /// Takes a stroke on through all the places that the pointer came to since
    /// the last frame.
    pub(super) fn stroke(&self, mut last: Cell, event: &PointerEvent) -> Cell {
        let mut cells = Vec::new();
        for place in places(event) {
            let cell = self.nearest_cell(self.frame.point(self.px(&place)));
            if cell != last {
                cells.push(cell);
                last = cell;
            }
        }
        if !cells.is_empty() {
            self.send.emit(Action::Board(BoardAction::Drag(cells)));
        }
        last
    }

    /// Whether there is something at a pixel that is moved by hand. A finger
    /// moves the page, and on a map that is larger than the board the map is
    /// moved: there only what is selected is held.
    pub(super) fn holds(&self, at: Px, event: &PointerEvent) -> bool {
        let Some(cell) = self.cell(self.frame.point(at)) else {
            return false;
        };
        let is_selected = match self.state.view.selection {
            Selection::Cell(selected) => selected == cell,
            Selection::Agent(agent) => self.state.agent_at(cell) == Some(agent),
            Selection::Nothing => false,
        };
        let is_loose = self.is_fit && event.pointer_type() != "touch";
        (is_loose || is_selected) && self.state.can_move(cell)
    }

    /// The cell whose number is pressed at a pixel: what closing it costs.
    fn number_at(&self, at: Px, time: f64) -> Option<Cell> {
        let is_free = reads_numbers(self.frame.detail()) && self.agent_at(at, time).is_none();
        let cell = is_free.then(|| pressed(&self.state, self.frame.point(at)));
        cell.flatten()
    }

    /// The zone whose tab is at a pixel, where no robot stands on it and no cell is asked
    /// for.
    pub(super) fn zone_at(&self, at: Px, time: f64) -> Option<String> {
        if self.agent_at(at, time).is_some() || self.state.is_writing_rule() {
            return None;
        }
        zone_at(&self.state, self.frame.point(at), self.frame.detail())
    }

    pub(super) fn select(&self, at: Px, time: f64) {
        let cell = self.cell(self.frame.point(at));
        if self.state.document.mode.steering().is_some() {
            if let Some(cell) = cell {
                self.send.emit(Action::Steer(Lead::To(cell)));
            }
            return;
        }
        if let Some(cell) = cell {
            self.send.emit(Action::Board(BoardAction::MoveCursor(cell)));
        }
        if let Some(closed) = self.number_at(at, time) {
            self.send
                .emit(Action::Freedom(FreedomAction::Close(closed)));
            return;
        }
        if let Some(zone) = self.zone_at(at, time) {
            self.send.emit(Action::Rules(RuleAction::OfTab(zone)));
            inspector::show_rules();
            return;
        }
        let selection = match (self.agent_at(at, time), cell) {
            (Some(agent), _) => Selection::Agent(agent),
            (None, Some(cell)) => Selection::Cell(cell),
            (None, None) => Selection::Nothing,
        };
        self.send
            .emit(Action::Board(BoardAction::Select(selection)));
    }
}
