//! The places that a pointer came to since the last frame.

use wasm_bindgen::JsCast as _;
use web_sys::PointerEvent;

use crate::support::has;

/// All of them, the latest last; one at least. Safari before 18.2 tells only the
/// latest, and over plain http every browser does.
pub(super) fn places(event: &PointerEvent) -> Vec<PointerEvent> {
    let mut places = Vec::new();
    if has(event, "getCoalescedEvents") {
        let all = event.get_coalesced_events();
        places.extend(all.iter().filter_map(|place| place.dyn_into().ok()));
    }
    if places.is_empty() {
        places.push(event.clone());
    }
    places
}
