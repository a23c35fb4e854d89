//! A plan of one's own in words.

use giveway_model::tr;

use crate::steering::Steering;
use crate::words::at;

/// Where the agent is that is led, and what its last step brought.
pub(super) fn steering(own: &Steering) -> String {
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
