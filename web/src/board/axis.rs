//! The numbers of columns and rows. Where the map reaches beyond the screen they
//! stand at its edge.

use giveway_page::board::Frame;
use yew::prelude::*;

/// What is in sight of a map of some cells.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct AxisProps {
    pub(super) frame: Frame,
    pub(super) board: (u32, u32),
}

/// The axis.
#[component]
pub(super) fn Axis(props: &AxisProps) -> Html {
    let AxisProps { frame, board } = props;
    let (columns, rows) = frame.cells(*board);
    // As large as a sixth of a cell, but always to be read and never loud.
    let size = 17.0_f64.clamp(frame.units(11.0), frame.units(15.0));
    let top = (frame.y + frame.units(14.0)).max(-12.0);
    let left = (frame.x + frame.units(13.0)).max(-18.0);
    let number = |number: u32, x: f64, y: f64| {
        html! { <text x={format!("{x:.1}")} y={format!("{y:.1}")}>{ number }</text> }
    };
    let middle = |index: u32| super::units(f64::from(index));
    // Where both edges are inside of the map its corner would be written twice.
    let is_clear = |y: f64| top < 0.0 || y - size > top + frame.units(6.0);
    html! {
        <g class="axis" aria-hidden="true" font-size={format!("{size:.1}")}>
            { for (columns.0..=columns.1).map(|x| number(x, middle(x), top)) }
            { for (rows.0..=rows.1).filter(|&y| is_clear(middle(y))).map(|y| number(y, left, middle(y) + size * 0.36)) }
        </g>
    }
}
