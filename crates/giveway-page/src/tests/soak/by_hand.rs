//! A search by hand, by chance. By hand every tree has an end; the planner's is not asked for.

use fastrand::Rng;

use crate::inside::{HandAction, InsideAction};

pub(super) fn by_hand(rng: &mut Rng, n: usize) -> InsideAction {
    InsideAction::Hand(match rng.u8(0..9) {
        0..2 => HandAction::Show(true),
        2 => HandAction::Conflict(n),
        3 => HandAction::Robot(n),
        4..6 => HandAction::Split,
        6 => HandAction::TakeBack,
        7 => HandAction::Again,
        _ => HandAction::Restart,
    })
}
