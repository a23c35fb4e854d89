//! The nose of the robot that is selected, where turns take time: a hand turns it at its start. The
//! keyboard has buttons for it in the inspector.

use giveway_model::constraint::Heading;
use giveway_page::board::{Nose, degrees};
use giveway_page::{Action, Edit};
use web_sys::{Element, PointerEvent};
use yew::prelude::*;

use super::units;

/// From the middle of the robot so many pixels nothing is meant yet.
const DEAD: f64 = 6.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct NoseProps {
    pub(super) nose: Nose,
    pub(super) send: Callback<Action>,
}

#[component]
pub(super) fn TurnedNose(props: &NoseProps) -> Html {
    let NoseProps { nose, send } = props;
    let middle = use_node_ref();
    // Where it faces while a hand turns it; nothing while none does.
    let turned = use_state_eq(|| None::<Option<Heading>>);
    let down = {
        let turned = turned.clone();
        let heading = nose.heading;
        Callback::from(move |event: PointerEvent| {
            event.stop_propagation();
            event.prevent_default();
            if let Some(place) = event.target_dyn_into::<Element>() {
                // Without a capture the nose still turns while the pointer is on it.
                let _ = place.set_pointer_capture(event.pointer_id());
            }
            turned.set(Some(heading));
        })
    };
    let moved = {
        let (turned, middle) = (turned.clone(), middle.clone());
        Callback::from(move |event: PointerEvent| {
            if turned.is_none() {
                return;
            }
            event.stop_propagation();
            if let Some(heading) = towards(&middle, &event) {
                turned.set(Some(Some(heading)));
            }
        })
    };
    let up = {
        let (turned, send) = (turned.clone(), send.clone());
        let Nose { agent, heading, .. } = *nose;
        Callback::from(move |event: PointerEvent| {
            let Some(now) = *turned else { return };
            event.stop_propagation();
            turned.set(None);
            // A tap turns it by a quarter.
            let now = if now == heading {
                Some(next(heading))
            } else {
                now
            };
            send.emit(Action::Edit(Edit::Face(agent, now)));
        })
    };
    let cancel = {
        let turned = turned.clone();
        Callback::from(move |_: PointerEvent| turned.set(None))
    };
    let mouse = Callback::from(|event: MouseEvent| event.stop_propagation());
    let shown = turned.unwrap_or(nose.heading);
    let turn = format!("rotate({:.0})", shown.map_or(0.0, degrees));
    let place = format!(
        "translate({:.1} {:.1})",
        units(nose.at.x.into()),
        units(nose.at.y.into())
    );
    html! {
        <g class={classes!("turned-nose", shown.is_none().then_some("open"))} aria-hidden="true" transform={place}
            onpointerdown={down} onpointermove={moved} onpointerup={up} onpointercancel={cancel} onmousedown={mouse}>
            <circle class="nose-middle" ref={middle} r="1" />
            <g transform={turn}>
                <circle class="nose-grip" cx="56" r="24" />
                <path class="nose" d="M46-15 68 0 46 15Z" />
            </g>
        </g>
    }
}

/// The direction from the middle of the robot to the pointer; nothing close to the middle.
fn towards(middle: &NodeRef, event: &PointerEvent) -> Option<Heading> {
    let area = middle.cast::<Element>()?.get_bounding_client_rect();
    let dx = f64::from(event.client_x()) - (area.x() + area.width() / 2.0);
    let dy = f64::from(event.client_y()) - (area.y() + area.height() / 2.0);
    if dx.hypot(dy) < DEAD {
        return None;
    }
    Some(match (dx.abs() > dy.abs(), dx > 0.0, dy > 0.0) {
        (true, true, _) => Heading::East,
        (true, false, _) => Heading::West,
        (false, _, true) => Heading::South,
        (false, _, false) => Heading::North,
    })
}

/// A quarter turn clockwise.
const fn next(heading: Option<Heading>) -> Heading {
    match heading {
        None | Some(Heading::North) => Heading::East,
        Some(Heading::East) => Heading::South,
        Some(Heading::South) => Heading::West,
        Some(Heading::West) => Heading::North,
    }
}
