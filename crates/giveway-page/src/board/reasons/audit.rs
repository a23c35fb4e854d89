//! Where a plan of elsewhere breaks the rules.

use giveway_model::Cell;
use giveway_model::check::Violation;

use super::{ConflictPlace, Later, Reasons, place};
use crate::MAX_SIDE;
use crate::audit::Audit;

/// The places of the time shown that are drawn.
const NOW: usize = 200;
/// So many broken rules before and after the time shown are looked at.
const AROUND: usize = 100;
/// The places of other times that are drawn.
const LATER: usize = 8;

/// What is against the rules of a plan of elsewhere: frames at the time shown, and
/// dotted ones at other times, the nearest first.
pub(super) fn in_audit(reasons: &mut Reasons, audit: &Audit, time: u32) {
    for violation in audit.plan.now(time) {
        let Some(burst) = ConflictPlace::of(violation) else {
            continue;
        };
        if reasons.bursts.len() < NOW && !reasons.bursts.contains(&burst) {
            reasons.bursts.push(burst);
            let on_page = |cell: &Cell| cell.x < MAX_SIDE && cell.y < MAX_SIDE;
            reasons.frames.extend(violation.cell.filter(on_page));
        }
    }
    let others = audit.plan.around(time, AROUND).iter();
    let mut others: Vec<&Violation> = others.filter(|violation| violation.time != time).collect();
    others.sort_by_key(|violation| violation.time.abs_diff(time));
    for violation in others {
        if reasons.later.len() == LATER {
            break;
        }
        let is_now = violation
            .cell
            .is_some_and(|cell| reasons.frames.contains(&cell));
        let is_new = |at: &(f64, f64)| {
            !is_now
                && reasons.bursts.iter().all(|burst| burst.middle() != *at)
                && reasons.later.iter().all(|later| later.at != *at)
        };
        if let Some(at) = place(violation).filter(is_new) {
            reasons.later.push(Later {
                at,
                is_cell: violation.cell.is_some(),
                time: violation.time,
            });
        }
    }
}
