//! The playhead: moved by hand with the clock, every frame.

use giveway_page::timeline::Axis;
use web_sys::{Element, HtmlElement};
use yew::prelude::*;

use super::seen::Seen;
use crate::Clock;

/// How near the playhead comes to an end of what is seen, in pixels.
const NEAR: f64 = 40.0;

/// What the clock moves.
#[derive(Clone, PartialEq)]
pub(super) struct Moved {
    /// The line over the lanes.
    pub head: NodeRef,
    /// The thumb of the ruler.
    pub thumb: NodeRef,
    /// The places that scroll, to keep the playhead in view.
    pub places: [NodeRef; 2],
}

/// Keeps the playhead where the clock is, and in view.
#[hook]
pub(super) fn use_head(moved: &Moved, axis: Axis, seen: &Seen, playing: bool) {
    let clock = use_context::<Clock>();
    let moved = moved.clone();
    let (room, label) = (seen.room, seen.label);
    use_effect_with(
        (clock, moved, axis, room, label, playing),
        move |(clock, moved, axis, room, label, playing)| {
            let (moved, axis, room, label, playing) =
                (moved.clone(), *axis, *room, *label, *playing);
            let scrolls = axis.width() > room;
            let last_time = std::cell::Cell::new(None);
            let listening = clock.as_ref().map(|clock| {
                clock.listen(move |time| {
                    let x = axis.x(time);
                    put(&moved.head, x + label);
                    put(&moved.thumb, x);
                    // A person may look elsewhere while the time stands still.
                    let before = last_time.replace(Some(time));
                    if scrolls && before.is_none_or(|before: f64| (before - time).abs() > 1e-9) {
                        keep_in_view(&moved.places, x, room, playing);
                    }
                })
            });
            move || drop(listening)
        },
    );
}

fn put(place: &NodeRef, x: f64) {
    if let Some(element) = place.cast::<HtmlElement>() {
        let _ = element
            .style()
            .set_property("transform", &format!("translateX({x:.2}px)"));
    }
}

fn keep_in_view(places: &[NodeRef], x: f64, room: f64, playing: bool) {
    // While it plays there is more to see ahead than behind.
    let ahead = if playing {
        (room * 0.3).max(NEAR)
    } else {
        NEAR
    };
    for place in places.iter().filter_map(NodeRef::cast::<Element>) {
        let left = f64::from(place.scroll_left());
        let to = if x > left + room - ahead {
            x - room + ahead
        } else if x < left + NEAR {
            x - NEAR
        } else {
            continue;
        };
        place.set_scroll_left(to.round() as i32);
    }
}
