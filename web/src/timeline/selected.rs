//! The lane of the agent that is selected: found, brought into view, and focused.

use std::rc::Rc;

use giveway_page::timeline::Lane;
use giveway_page::{Selection, State};
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};
use yew::prelude::*;

use super::seen::Extent;
use crate::held::Held;

/// Brings the lane that was selected into view, and the focus to it where the
/// keyboard selected it.
#[hook]
pub(super) fn use_selected_in_view(
    selected: Option<usize>,
    extent: Extent,
    lanes: &NodeRef,
    focus: &Rc<Held<Option<usize>>>,
) {
    const RULER: f64 = 24.0;
    {
        let lanes = lanes.clone();
        use_effect_with((selected, extent.lanes), move |(selected, _)| {
            let (Some(index), Some(place)) = (*selected, lanes.cast::<Element>()) else {
                return;
            };
            let top = index as f64 * extent.lane;
            let shown = f64::from(place.client_height()) - RULER;
            let scrolled = f64::from(place.scroll_top());
            let to = if top < scrolled {
                top
            } else if top + extent.lane > scrolled + shown {
                top + extent.lane - shown
            } else {
                return;
            };
            place.set_scroll_top(to.ceil() as i32);
        });
    }
    // After every render: the lane may have been drawn only now.
    let (lanes, focus) = (lanes.clone(), Rc::clone(focus));
    use_effect(move || {
        let wanted = focus.get();
        let button = wanted.and_then(|index| {
            let selector = format!("[data-lane=\"{index}\"]");
            lanes.cast::<Element>()?.query_selector(&selector).ok()?
        });
        if let Some(button) = button.and_then(|button| button.dyn_into::<HtmlElement>().ok()) {
            let _ = button.focus();
            focus.set(None);
        }
    });
}

/// The lane whose label has the focus.
pub(super) fn lane_of(event: &KeyboardEvent) -> Option<usize> {
    let target: Element = event.target()?.dyn_into().ok()?;
    target.get_attribute("data-lane")?.parse().ok()
}

/// The lane of the agent that is selected. The answer may be of an older draft:
/// agents are the same if their names are.
pub(super) fn selected_lane(state: &State, lanes: &[Lane]) -> Option<usize> {
    let Selection::Agent(agent) = state.view.selection else {
        return None;
    };
    let name = &state.world().agents().get(agent)?.name;
    lanes.iter().position(|lane| lane.name == *name)
}

pub(super) fn selection(state: &State, lanes: &[Lane], index: usize) -> Selection {
    let name = lanes.get(index).map(|lane| &lane.name);
    let mut agents = state.world().agents().iter();
    let agent = agents.position(|agent| Some(&agent.name) == name);
    agent.map_or(Selection::Nothing, Selection::Agent)
}
