//! What is done at random with a floor as a whole: robots in rows, areas, its size.

use super::Session;
use crate::area::{AreaAction, Frame};
use crate::fleet::FleetAction;
use crate::grow::{GrowAction, Side};
use crate::{Action, Axis, Lines, Lost};

impl Session {
    pub(super) fn fleet(&mut self) -> FleetAction {
        match self.rng.u8(0..8) {
            0 => FleetAction::Count(self.rng.bool().then(|| self.rng.u32(0..9))),
            1 => FleetAction::Back(self.rng.bool()),
            2 => FleetAction::Waypoints(self.rng.u32(0..4)),
            3 => FleetAction::DrawAgain,
            4 => FleetAction::Battery(self.rng.bool().then(|| self.rng.u32(1..30))),
            5 => FleetAction::Level(self.rng.u32(0..30)),
            6 => FleetAction::Add,
            _ => FleetAction::Cancel,
        }
    }

    /// What is done with a part of the floor, whether or not there is one.
    pub(super) fn area(&mut self) -> AreaAction {
        let cell = self.cell();
        let n = self.rng.i32(-6..7);
        match self.rng.u8(0..16) {
            0..4 => {
                let frames = [Frame::Replace, Frame::Add, Frame::Take];
                AreaAction::Begin(cell, *self.rng.choice(&frames).unwrap())
            }
            4 => AreaAction::Grab(cell),
            5 => AreaAction::Stretch(1, -1),
            6 => AreaAction::All,
            7 => AreaAction::Nudge(n, 1),
            8 => AreaAction::Copy,
            9 => AreaAction::Paste,
            10 => AreaAction::Mirror(n > 0),
            11 => AreaAction::Turn,
            12 => AreaAction::Repeat(n > 0),
            13 => AreaAction::Copies(n.unsigned_abs()),
            14 => AreaAction::Erase,
            15 if n > 0 => AreaAction::Make,
            _ => AreaAction::Drop,
        }
    }

    /// The floor gets another size, or not.
    pub(super) fn grow(&mut self) -> Vec<Action> {
        let side = *self.rng.choice(&Side::ALL).unwrap();
        let more = self.rng.i32(-3..4);
        let lost = if more > 0 { Lost::Move } else { Lost::Remove };
        if self.rng.u8(0..3) == 0 {
            let axis = if self.rng.bool() {
                Axis::Columns
            } else {
                Axis::Rows
            };
            let at = self.rng.u32(0..9);
            let lines = GrowAction::Lines(Lines { axis, at, more });
            return [lines, GrowAction::Lost(lost), GrowAction::Make]
                .map(Action::Grow)
                .to_vec();
        }
        let steps = [
            GrowAction::Open,
            GrowAction::Side(side, more),
            GrowAction::Step(side, more),
            GrowAction::Hold,
            GrowAction::Drag(side, -more),
            GrowAction::Release,
            GrowAction::Lost(lost),
            GrowAction::Make,
        ];
        let count = self.rng.usize(0..=steps.len());
        steps.into_iter().take(count).map(Action::Grow).collect()
    }
}
