//! The board on paper: all of the map with its numbers, at any size, in light colours.

use std::rc::Rc;

use giveway_page::audit::ahead;
use giveway_page::board;
use giveway_page::board::{Cast, Detail, FloorLook, Frame};
use yew::prelude::*;

use super::agents::Agents;
use super::floor::FloorShapes;
use super::layers::problems;
use super::marks::Marks;
use super::reasons::ReasonMarks;
use super::rules::Layer;
use super::viewport::use_sight;
use super::ways::Ways;
use super::{LETTERS_PX, freedom, rules, view_box};
use crate::Shown;
use crate::board::agents::AgentsProps;
use crate::board::floor::FloorProps;
use crate::board::marks::MarksProps;
use crate::board::reasons::ReasonsProps;
use crate::board::ways::WaysProps;
use crate::part::part;
use crate::same::Same;

/// The room of a board on paper, in pixels: A4 and letter have this beside their margins.
const ROOM: (f64, f64) = (640.0, 620.0);
/// The largest cell, in pixels.
const LARGEST_PX: f64 = 60.0;
/// The smallest cell in which names are drawn: print is finer than a screen.
const NAMED_PX: f64 = 13.0;
/// The size of the numbers, in pixels.
const NUMBER_PX: f64 = 10.0;
/// The room of the numbers left and above, in pixels, and a rim right and below.
const AXIS_PX: f64 = 24.0;
const RIM_PX: f64 = 3.0;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct PaperBoardProps {
    pub(crate) state: Shown,
    pub(crate) cast: Rc<Cast>,
}

/// The board, as large as its room on paper allows.
#[component]
pub(crate) fn PaperBoard(props: &PaperBoardProps) -> Html {
    let PaperBoardProps { state, cast } = props;
    let world = state.world();
    let size = (world.grid().width(), world.grid().height());
    let frame = frame(size);
    let sight = use_sight(frame);
    let detail = detail(&frame);
    let selected = state.selected_agent();
    let still = Some(f64::from(state.view.playback.time));
    let (width, height) = (frame.width, frame.height);
    let px = |units: f64| (units * frame.cell_px / 100.0).to_string();
    let agents = part::<Agents>(AgentsProps {
        cast: Rc::clone(cast),
        draft: Same::new(Rc::clone(world)),
        versus: None::<Rc<Cast>>,
        detail,
        selected: None::<usize>,
        lit: None::<Vec<usize>>,
        named: None::<usize>,
        sight,
        still,
    });
    let marks = part::<Marks>(MarksProps {
        cast: Rc::clone(cast),
        detail,
        lit: None::<Vec<usize>>,
        but: None::<usize>,
        still,
    });
    let (below, above) = if detail.covers_marks() {
        (marks, agents)
    } else {
        (agents, marks)
    };
    html! {
        <svg class={classes!("map", detail.class())} viewBox={view_box(&frame)} width={px(width)} height={px(height)} font-size={format!("{:.1}", frame.units(LETTERS_PX))} aria-hidden="true">
            { part::<FloorShapes>(FloorProps { draft: Rc::clone(world), look: FloorLook::of(frame.cell_px), used_by: state.view.layers.heat.then(|| Rc::clone(cast)) }) }
            { rules::on_paper(state, Layer::Floor) }
            if state.is_laid_over() {
                { freedom::overlay(state, detail) }
            } else if state.view.layers.trails {
                { part::<Ways>(WaysProps { cast: Rc::clone(cast), selected, ahead: ahead(state), is_alone: false, still }) }
            }
            { rules::on_paper(state, Layer::Tabs) }
            { below }
            { above }
            { rules::on_paper(state, Layer::Tags) }
            { part::<ReasonMarks>(ReasonsProps { reasons: board::reasons(state), cell_px: frame.cell_px }) }
            { problems(state) }
            { axis(&frame, size) }
        </svg>
    }
}

/// The numbers of columns and rows, beside the map. Where they have no room, only every
/// fifth stands there.
fn axis(frame: &Frame, (columns, rows): (u32, u32)) -> Html {
    let every = |px: f64| if frame.cell_px < px { 5 } else { 1 };
    let size = frame.units(NUMBER_PX);
    let middle = |index: u32| f64::from(index) * 100.0 + 50.0;
    let number = |number: u32, x: f64, y: f64| {
        html! { <text x={format!("{x:.1}")} y={format!("{y:.1}")}>{ number }</text> }
    };
    let across = (0..columns).filter(|x| x % every(2.0 * NUMBER_PX) == 0);
    let down = (0..rows).filter(|y| y % every(1.2 * NUMBER_PX) == 0);
    html! {
        <g class="axis" font-size={format!("{size:.1}")}>
            { for across.map(|x| number(x, middle(x), -frame.units(6.0))) }
            { for down.map(|y| number(y, -frame.units(13.0), middle(y) + size * 0.36)) }
        </g>
    }
}

/// All of the map, with room for the numbers.
fn frame((columns, rows): (u32, u32)) -> Frame {
    let side = |room: f64, cells: u32| (room - AXIS_PX - RIM_PX) / f64::from(cells.max(1));
    let cell_px = side(ROOM.0, columns)
        .min(side(ROOM.1, rows))
        .min(LARGEST_PX);
    let units = |px: f64| px * 100.0 / cell_px;
    Frame {
        x: -units(AXIS_PX),
        y: -units(AXIS_PX),
        width: f64::from(columns) * 100.0 + units(AXIS_PX + RIM_PX),
        height: f64::from(rows) * 100.0 + units(AXIS_PX + RIM_PX),
        cell_px,
    }
}

fn detail(frame: &Frame) -> Detail {
    if frame.cell_px >= NAMED_PX {
        Detail::All
    } else {
        frame.detail()
    }
}
