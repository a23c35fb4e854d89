//! What a lesson marks on the board: the cell that its text names, and those that solved
//! a task.

use giveway_model::Cell;
use giveway_page::State;
use yew::prelude::*;

use super::square;

/// The marks of a lesson, over the map.
pub(super) fn marks(state: &State) -> Html {
    let Some(lesson) = state.lesson() else {
        return Html::default();
    };
    html! {
        <g class="lesson-marks" aria-hidden="true">
            if let Some(cell) = state.named_cell() { { square("named", cell, 3) } }
            { for lesson.sealed.iter().map(|&cell| seal(state, cell)) }
        </g>
    }
}

/// In the middle of an obstacle; in the corner of a cell where robots pass.
fn seal(state: &State, cell: Cell) -> Html {
    let (aside, scale) = if state.world().grid().is_vertex(cell) {
        (82, 0.45)
    } else {
        (50, 1.0)
    };
    let (x, y) = (cell.x * 100 + aside, cell.y * 100 + aside);
    html! {
        <g transform={format!("translate({x} {y}) scale({scale})")}>
            <g class="seal">
                <circle r="34" />
                <path d="M-13 1 -4 10 14-9" />
            </g>
        </g>
    }
}
