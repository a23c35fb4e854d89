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
            { for lesson.sealed.iter().map(|&cell| seal(cell)) }
        </g>
    }
}

fn seal(cell: Cell) -> Html {
    let (x, y) = (cell.x * 100 + 50, cell.y * 100 + 50);
    html! {
        <g class="seal" transform={format!("translate({x} {y})")}>
            <circle r="34" />
            <path d="M-13 1 -4 10 14-9" />
        </g>
    }
}
