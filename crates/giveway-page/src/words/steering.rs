//! A plan of one's own in words.

use giveway_model::tr;

use crate::steering::Steering;
use crate::words::at;

/// Where the agent is that is led, and what its last step brought. The judge of a lesson checks
/// by itself.
pub(super) fn steering(own: &Steering, can_check: bool) -> String {
    let name = own.name();
    let here = tr!(
        "{name} is at {cell} at time {time}.",
        name,
        cell = at(own.cell()),
        time = own.time()
    );
    if !own.told.is_empty() {
        return format!("{here} {}", own.told);
    }
    if own.is_whole() && !can_check {
        return tr!("{here} All robots do their tasks.", here);
    }
    if own.is_whole() {
        return tr!("{here} All robots do their tasks. Check your plan.", here);
    }
    if own.can_go_back() {
        return here;
    }
    tr!(
        "{here} Lead it with the arrows, or press a cell beside it.",
        here
    )
}
