//! What lies on the floor.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::Draft;
use giveway_page::board::{Cast, Detail, floor, heat};
use yew::prelude::*;

/// Which map, and whether its cells are large enough for more than their colour.
#[derive(Clone, Properties)]
pub(super) struct FloorProps {
    pub(super) draft: Rc<Draft>,
    pub(super) is_fine: bool,
    /// Whose use of the cells is shown, if anyone's.
    pub(super) used_by: Option<Rc<Cast>>,
}

impl PartialEq for FloorProps {
    fn eq(&self, other: &Self) -> bool {
        self.is_fine == other.is_fine
            && self.used_by == other.used_by
            && (Rc::ptr_eq(&self.draft, &other.draft)
                || (self.draft.grid() == other.draft.grid()
                    && stars(&self.draft).eq(stars(&other.draft))))
    }
}

/// The cells that agents visit on their way.
fn stars(draft: &Draft) -> impl Iterator<Item = Cell> {
    draft
        .agents()
        .iter()
        .flat_map(|agent| agent.waypoints.iter().copied())
}

/// The hatch of slow zones: once on the page, for all boards.
pub(super) fn hatch() -> Html {
    html! {
        <defs>
            <pattern id="hatch" width="14" height="14" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
                <path class="hatch-l" d="M7 0V14" />
            </pattern>
        </defs>
    }
}

/// Floor, slow zone, lines, obstacles, chargers, edge: from below to above.
#[component]
pub(super) fn FloorShapes(props: &FloorProps) -> Html {
    let grid = props.draft.grid();
    let detail = if props.is_fine {
        Detail::All
    } else {
        Detail::Dots
    };
    let floor = floor(grid, detail, |cell| {
        stars(&props.draft).any(|star| star == cell)
    });
    let (width, height) = (100 * grid.width(), 100 * grid.height());
    let shape = |class: &'static str| move |d: String| html! { <path {class} {d} /> };
    let sheet = |class: &'static str| {
        html! { <rect {class} width={width.to_string()} height={height.to_string()} rx="12" /> }
    };
    html! {
        <g aria-hidden="true">
            { sheet("floor") }
            <g>{ for floor.slow_tint.into_iter().map(shape("slow-t")) }</g>
            <path class="grid" d={floor.lines} />
            <g>{ for floor.slow.into_iter().map(shape("slow")) }</g>
            { props.used_by.as_deref().map(shades) }
            <g>{ for floor.obstacles.into_iter().map(shape("obst")) }</g>
            <path class="chg" d={floor.chargers} />
            <path class="bolt" d={floor.bolts} />
            { sheet("edge") }
        </g>
    }
}

/// A shade for every cell that is used, below what stands there.
fn shades(cast: &Cast) -> Html {
    let shade = |(index, d): (usize, String)| {
        html! { <path class={format!("heat-{}", index + 1)} {d} /> }
    };
    html! { <g class="heat">{ for heat(cast).into_iter().enumerate().map(shade) }</g> }
}
