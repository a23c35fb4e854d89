//! The tip beside the pointer.

use std::rc::Rc;

use giveway_page::board::{Cast, Frame, TipLine, tip, tip_corner};
use giveway_page::{State, Tool};
use web_sys::HtmlElement;
use yew::prelude::*;

use super::pointer::{Pointer, use_pointed};
use crate::{Shown, glyph};

/// The width of a tip, the height of its first line and of each further one, in pixels: as in the
/// style sheet.
const WIDE: f64 = 248.0;
const FIRST: f64 = 40.0;
const LINE: f64 = 26.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct TipProps {
    pub(super) state: Shown,
    pub(super) cast: Rc<Cast>,
    pub(super) frame: Frame,
    pub(super) pointer: Rc<Pointer>,
}

/// Whether the pointer is told of: not while it draws, leads a robot, or before a room.
pub(super) fn has_tips(state: &State) -> bool {
    state.view.tool == Tool::Select
        && !state.is_presented()
        && state.document.mode.steering().is_none()
        && !state.has_gesture()
}

/// The tip, which no pointer meets. Aloud the cell has it as its description.
#[component]
pub(super) fn TipCard(props: &TipProps) -> Html {
    let TipProps {
        state,
        cast,
        frame,
        pointer,
    } = props;
    let card = use_node_ref();
    let pointed = use_pointed(pointer).filter(|_| has_tips(state));
    let told = pointed.and_then(|at| Some((at.cell, tip(state, cast, at.cell)?)));
    let corner = told.as_ref().map(|(cell, tip)| {
        let time = state.view.playback.time as usize;
        let track = state
            .selected_agent()
            .and_then(|agent| cast.tracks.get(agent));
        let way = track.map_or(&[][..], |track| {
            track.path().get(time..).unwrap_or_default()
        });
        let tall = FIRST + LINE * tip.lines.len() as f64;
        tip_corner(*cell, frame, (WIDE, tall), way.iter().copied().flatten())
    });
    {
        let card = card.clone();
        use_effect_with(corner, move |corner| {
            if let (Some((left, top)), Some(card)) = (corner, card.cast::<HtmlElement>()) {
                let place = format!("translate({left:.0}px, {top:.0}px)");
                // A browser that refuses shows it in the corner.
                let _ = card.style().set_property("transform", &place);
            }
        });
    }
    let Some((_, tip)) = told else {
        return html! {};
    };
    let line = |line: &TipLine| {
        html! { <p>{ glyph::show(line.agent, "tip-glyph") }{ line.text.clone() }</p> }
    };
    html! {
        <div class="cell-tip" ref={card} aria-hidden="true">
            <p><b>{ tip.cell.clone() }</b><span>{ tip.used.clone() }</span></p>
            { for tip.lines.iter().map(line) }
        </div>
    }
}
