//! A plan of one's own in words.

use crate::steering::Steering;
use crate::words::at;

/// Where the agent is that is led, and what its last step brought.
pub(super) fn steering(own: &Steering) -> String {
    let name = own.name();
    let here = format!("{name} is at {} at time {}.", at(own.cell()), own.time());
    if !own.told.is_empty() {
        return format!("{here} {}", own.told);
    }
    if own.is_whole() {
        return format!("{here} All robots do their tasks. Check your plan.");
    }
    if own.can_go_back() {
        return here;
    }
    format!("{here} Lead it with the arrows, or press a cell beside it.")
}
