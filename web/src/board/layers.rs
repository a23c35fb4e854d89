//! What lies on the map, from below to above, and frames around cells.

use std::rc::Rc;

use giveway_model::{Cell, sorting};
use giveway_page::Draft;
use giveway_page::beside::ahead;
use giveway_page::board::{Cast, Detail, FloorLook, lit};
use giveway_page::changing::{Stopped, broken_down_for_good};
use giveway_page::inside::{Method, Overlay};
use yew::prelude::*;

use super::agents::Agents;
use super::axis::Axis;
use super::chosen::{ChosenForm, ChosenMarks, ChosenProps};
use super::floor::FloorShapes;
use super::floor_plan;
use super::freedom;
use super::inside::InsideFloor;
use super::marks::Marks;
use super::pills::{Pills, PillsProps};
use super::pointer::Pointer;
use super::rules::{self, Layer};
use super::short_ways;
use super::viewport::Sight;
use super::ways::Ways;
use crate::board::agents::AgentsProps;
use crate::board::axis::AxisProps;
use crate::board::floor::FloorProps;
use crate::board::inside::InsideProps;
use crate::board::marks::MarksProps;
use crate::board::ways::WaysProps;
use crate::part::part;
use crate::same::Same;
use crate::{Shown, glyph};

/// Which of two boards.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// That of the plan on the page.
    Board,
    /// That of another plan, beside it.
    Beside,
}

impl Place {
    /// The scene on it.
    pub(super) fn world(self, state: &Shown) -> &Rc<Draft> {
        match self {
            Self::Board => state.world(),
            Self::Beside => state.world_of(state.beside()),
        }
    }
}

/// The map with all that stands and moves on it, from below to above; agents
/// that are elsewhere in another plan are marked.
pub(super) fn layers(
    state: &Shown,
    place: Place,
    cast: &Rc<Cast>,
    versus: Option<&Rc<Cast>>,
    sight: &Sight,
    overlay: &Overlay,
    pointer: &Rc<Pointer>,
) -> Html {
    let lit = overlay.lit.clone().or_else(|| lit(state));
    let is_proof = state.is_inside() && state.inside.method == Method::Proof;
    let frame = sight.get();
    let detail = frame.detail();
    let selected = state.selected_agent();
    let named = state.named_agent();
    let picked = picked(state, detail, overlay);
    let chosen = picked.map(|agent| ChosenProps {
        cast: Rc::clone(cast),
        agent,
        frame,
    });
    let world = place.world(state);
    let board = (world.grid().width(), world.grid().height());
    // What all best plans share takes the place of the ways of the plan that it is laid over.
    let is_laid_over = place == Place::Board && state.is_laid_over();
    let agents = part::<Agents>(AgentsProps {
        cast: Rc::clone(cast),
        draft: Same::new(Rc::clone(world)),
        versus: versus.cloned(),
        detail,
        selected,
        lit: lit.clone(),
        named,
        sight: Rc::clone(sight),
        still: None,
    });
    let marks = part::<Marks>(MarksProps {
        cast: Rc::clone(cast),
        detail,
        lit,
        but: picked,
        still: None,
    });
    let (below, above) = if detail.covers_marks() {
        (marks, agents)
    } else {
        (agents, marks)
    };
    html! {
        <>
            { part::<FloorShapes>(FloorProps { draft: Rc::clone(world), look: FloorLook::of(frame.cell_px), used_by: state.view.layers.heat.then(|| Rc::clone(cast)) }) }
            if place == Place::Board { { floor_plan::picture(state) } }
            { rules::layer(state, world, Layer::Floor) }
            { part::<InsideFloor>(InsideProps { overlay: overlay.clone() }) }
            if is_laid_over {
                { freedom::overlay(state, detail) }
            } else if state.view.layers.trails && !is_proof {
                { part::<Ways>(WaysProps { cast: Rc::clone(cast), selected, ahead: ahead(state), is_alone: picked.is_some(), still: None }) }
            }
            if place == Place::Board { { short_ways::show(state) } }
            { rules::layer(state, world, Layer::Tabs) }
            { chosen.clone().map(part::<ChosenMarks>) }
            { below }
            { above }
            { rules::layer(state, world, Layer::Tags) }
            { chosen.map(part::<ChosenForm>) }
            { part::<Axis>(AxisProps { frame, board, pointer: Rc::clone(pointer) }) }
            { part::<Pills>(PillsProps { cast: Rc::clone(cast), selected, detail, sight: Rc::clone(sight), pointer: Rc::clone(pointer) }) }
        </>
    }
}

/// The agent that stands out among small ones, which fade: the one selected, unless other agents
/// are lit.
pub(super) fn picked(state: &Shown, detail: Detail, overlay: &Overlay) -> Option<usize> {
    let is_lit = overlay.lit.is_some() || lit(state).is_some();
    let is_free = detail < Detail::All && !is_lit && !state.is_inside() && !state.is_laid_over();
    state.selected_agent().filter(|_| is_free)
}

/// A frame and a triangle on every cell where something is wrong.
pub(super) fn problems(state: &Shown) -> Html {
    let cells = state
        .document
        .draft
        .problems()
        .iter()
        .filter_map(|problem| problem.cell);
    let cells = sorting::set(cells);
    let mark = |cell: Cell| {
        html! {
            <>
                { square("fault", cell, 3) }
                <path class="fault-sign" transform={format!("translate({} {})", 100 * cell.x, 100 * cell.y)}
                    d="M20 7 33 29H7ZM20 14v7M20 25v.1" />
            </>
        }
    };
    html! { <g aria-hidden="true">{ for cells.into_iter().map(mark) }</g> }
}

/// Robots that broke down for good: each an obstacle with its name.
pub(super) fn stopped(state: &Shown) -> Html {
    let one = |own: &Stopped| {
        let (x, y) = (100 * own.cell.x + 50, 100 * own.cell.y + 50);
        html! {
            <g class={classes!("stopped", own.agent.map(glyph::class))} transform={format!("translate({x} {y})")}>
                <g class="body">{ own.agent.map(glyph::form) }</g>
                <path d="M-20-20 20 20M20-20-20 20" />
                <text class="num" y="-52">{ own.name.clone() }</text>
            </g>
        }
    };
    html! { <g aria-hidden="true">{ for broken_down_for_good(state).iter().map(one) }</g> }
}

/// A frame around a cell, some units inside of it.
pub(super) fn square(class: &'static str, cell: Cell, inset: u32) -> Html {
    let side = 100 - 2 * inset;
    html! {
        <rect {class} x={(100 * cell.x + inset).to_string()} y={(100 * cell.y + inset).to_string()}
            width={side.to_string()} height={side.to_string()} rx="15" />
    }
}
