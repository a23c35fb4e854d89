//! The cells as those meet them who do not see the board: a grid of rows, each
//! cell with a name. They lie above the picture and have no look of their own.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Cast, CellNames, Frame, Window};
use giveway_page::{Draft, Selection};
use yew::prelude::*;

use crate::held::use_held;

/// The id of a cell's element on the board of a name.
pub(super) fn id(of: &str, cell: Cell) -> String {
    let of = of.replace(' ', "-");
    format!("{of}-{}-{}", cell.x, cell.y)
}

/// What the cells tell.
#[derive(Clone, Properties)]
pub(super) struct CellsProps {
    /// The name of the board.
    pub(super) of: &'static str,
    pub(super) draft: Rc<Draft>,
    pub(super) cast: Rc<Cast>,
    pub(super) time: u32,
    pub(super) window: Window,
    pub(super) selection: Selection,
    /// What the names of some cells end with.
    #[prop_or_default]
    pub(super) notes: Vec<(Cell, String)>,
}

impl PartialEq for CellsProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.draft, &other.draft)
            && Rc::ptr_eq(&self.cast, &other.cast)
            && self.time == other.time
            && self.window == other.window
            && self.selection == other.selection
            && self.notes == other.notes
    }
}

/// What was in sight of a map of so many cells, with the window there.
type Seen = Option<(Frame, (u32, u32), Window)>;

/// The window around the cursor; the same one as long as the view rests and the cursor is inside.
#[hook]
pub(super) fn use_window(cursor: Cell, frame: Frame, board: (u32, u32)) -> Window {
    let kept = use_held(Seen::default);
    let window = match kept.take() {
        Some((seen, of, window)) if seen == frame && of == board => window.reaching(cursor, board),
        _ => Window::around(cursor, &frame, board),
    };
    kept.set(Some((frame, board, window)));
    window
}

/// The rows in the window.
#[component]
pub(super) fn Cells(props: &CellsProps) -> Html {
    let names = CellNames::new(&props.cast, props.time, props.draft.problems());
    let names = names.ruled(props.draft.scene(), props.time, &props.window);
    let names = names.noting(&props.notes);
    let selected = selected(props);
    let row = |y: u32| {
        let cell = |x: u32| {
            let cell = Cell::new(x, y);
            let name = AttrValue::from(names.name(props.draft.grid(), cell));
            (cell, name, selected.contains(&cell))
        };
        let cells: Vec<_> = props.window.columns().map(cell).collect();
        html! { <Row key={y} of={props.of} {cells} /> }
    };
    html! { { for props.window.rows().map(row) } }
}

/// The cells that are selected: one, or those where the selected agent is.
fn selected(props: &CellsProps) -> Vec<Cell> {
    match props.selection {
        Selection::Nothing => Vec::new(),
        Selection::Cell(cell) => vec![cell],
        Selection::Agent(agent) => {
            let track = props.cast.tracks.get(agent);
            track.map_or_else(Vec::new, |track| track.cells_at(props.time))
        }
    }
}

#[derive(Clone, PartialEq, Properties)]
struct RowProps {
    of: &'static str,
    cells: Vec<(Cell, AttrValue, bool)>,
}

#[component]
fn Row(props: &RowProps) -> Html {
    let row = props.cells.first().map_or(0, |(cell, ..)| cell.y + 1);
    let cell = |(cell, name, is_selected): &(Cell, AttrValue, bool)| {
        html! {
            <rect class="cell" role="gridcell" id={id(props.of, *cell)} aria-label={name}
                aria-colindex={(cell.x + 1).to_string()}
                aria-selected={is_selected.to_string()}
                x={(100 * cell.x).to_string()} y={(100 * cell.y).to_string()}
                width="100" height="100" />
        }
    };
    html! {
        <g role="row" aria-rowindex={row.to_string()}>
            { for props.cells.iter().map(cell) }
        </g>
    }
}
