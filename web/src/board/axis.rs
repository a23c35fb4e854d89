//! The numbers of columns and rows. Where the map reaches beyond the screen they
//! stand at its edge.

use std::rc::Rc;

use giveway_page::board::{AxisPlace, Frame};
use yew::prelude::*;

use super::pointer::{Pointer, use_pointed};

/// What is in sight of a map of some cells.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct AxisProps {
    pub(super) frame: Frame,
    pub(super) board: (u32, u32),
    pub(super) pointer: Rc<Pointer>,
}

/// The axis; the numbers of the cell under the pointer stand out.
#[component]
pub(super) fn Axis(props: &AxisProps) -> Html {
    let AxisProps {
        frame,
        board,
        pointer,
    } = props;
    let pointed = use_pointed(pointer).map(|at| at.cell);
    let Some(every) = frame.axis() else {
        return html! {};
    };
    let (columns, rows) = frame.cells(*board);
    let AxisPlace { size, top, left } = frame.axis_place();
    let number = |number: u32, x: f64, y: f64, hot: Option<u32>| {
        let class = (hot == Some(number)).then_some("hot");
        html! { <text {class} x={format!("{x:.1}")} y={format!("{y:.1}")}>{ number }</text> }
    };
    let middle = |index: u32| super::units(f64::from(index));
    // Where both edges are inside of the map its corner would be written twice.
    let is_clear = |y: f64| top < 0.0 || y - size > top + frame.units(6.0);
    let (column, row) = (pointed.map(|cell| cell.x), pointed.map(|cell| cell.y));
    let shown = |(first, last): (u32, u32), hot: Option<u32>| {
        // The number that stands out needs room.
        let room = frame.units(20.0);
        let is_near = move |at: u32| {
            hot.is_some_and(|hot| hot != at && f64::from(hot.abs_diff(at)) * 100.0 < room)
        };
        (first..=last).filter(move |&at| hot == Some(at) || (at % every == 0 && !is_near(at)))
    };
    html! {
        <g class="axis" aria-hidden="true" font-size={format!("{size:.1}")}>
            { for shown(columns, column).map(|x| number(x, middle(x), top, column)) }
            { for shown(rows, row).filter(|&y| is_clear(middle(y))).map(|y| number(y, left, middle(y) + size * 0.36, row)) }
        </g>
    }
}
