//! What a person does with the order of a plan, by chance.

use super::Session;
use crate::order::{OrderAction, OrderExport};

impl Session {
    pub(super) fn order(&mut self) -> OrderAction {
        let n = self.rng.usize(0..4);
        match self.rng.u8(0..11) {
            0..3 => OrderAction::Show(n > 0),
            3 => OrderAction::At(self.cell()),
            4 => OrderAction::Late(n > 0),
            5 => OrderAction::Robot(n),
            6 => OrderAction::To(n),
            7 => OrderAction::AddGap,
            8 => OrderAction::Replan,
            9 => OrderAction::Links(n > 0),
            _ => OrderAction::Save(OrderExport::ALL[n]),
        }
    }
}
