//! What lies on the floor.

use std::rc::Rc;

use crate::part::part;
use giveway_page::Draft;
use giveway_page::board::{Band, Cast, Floor, FloorLook, Layer, heat, lines};
use yew::prelude::*;

/// Which map, and how it is drawn.
#[derive(Clone, Properties)]
pub(super) struct FloorProps {
    pub(super) draft: Rc<Draft>,
    pub(super) look: FloorLook,
    /// Whose use of the cells is shown, if anyone's.
    pub(super) used_by: Option<Rc<Cast>>,
}

impl PartialEq for FloorProps {
    fn eq(&self, other: &Self) -> bool {
        self.look == other.look
            && same(self.used_by.as_ref(), other.used_by.as_ref())
            && Rc::ptr_eq(&self.draft, &other.draft)
    }
}

fn same(one: Option<&Rc<Cast>>, other: Option<&Rc<Cast>>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => Rc::ptr_eq(one, other),
        _ => false,
    }
}

/// The hatch of slow zones: once on the page, for all boards; on paper another one, since
/// a browser takes none from a board that is hidden.
pub(crate) fn hatch(id: &'static str) -> Html {
    html! {
        <defs>
            <pattern {id} width="14" height="14" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
                <path class="hatch-l" d="M7 0V14" />
            </pattern>
        </defs>
    }
}

/// Floor, slow zone, lines, obstacles, chargers, edge: from below to above.
#[component]
pub(super) fn FloorShapes(props: &FloorProps) -> Html {
    let FloorProps {
        draft,
        look,
        used_by,
    } = props;
    let kept = use_mut_ref(|| None::<Floor>);
    let floor = match kept.take() {
        Some(floor) => floor.renewed(draft, *look),
        None => Floor::new(draft, *look),
    };
    let layer = |layer: Layer| {
        let band = |(row, band): (usize, &Rc<Band>)| {
            html! { <BandShapes key={row} band={Rc::clone(band)} {layer} /> }
        };
        html! { <g>{ for floor.bands().iter().enumerate().map(band) }</g> }
    };
    let (width, height) = (draft.grid().width(), draft.grid().height());
    let shown = html! {
        <g aria-hidden="true">
            { sheet("floor", width, height) }
            { layer(Layer::SlowTint) }
            if look.has_lines {
                { part::<Lines>(LinesProps { class: "grid", width, height, every: 1 }) }
            }
            if look.has_fifths {
                { part::<Lines>(LinesProps { class: "grid fifth", width, height, every: 5 }) }
            }
            { layer(Layer::Slow) }
            { layer(Layer::SlowEdge) }
            if let Some(cast) = used_by {
                { part::<Heat>(HeatProps { cast: Rc::clone(cast) }) }
            }
            { layer(Layer::Obstacle) }
            { layer(Layer::ObstacleEdge) }
            { layer(Layer::Charger) }
            { layer(Layer::Bolt) }
            { sheet("edge", width, height) }
        </g>
    };
    kept.replace(Some(floor));
    shown
}

fn sheet(class: &'static str, width: u32, height: u32) -> Html {
    html! { <rect {class} width={(100 * width).to_string()} height={(100 * height).to_string()} rx="12" /> }
}

/// A layer of a row of tiles.
#[derive(Clone, Properties)]
struct BandProps {
    band: Rc<Band>,
    layer: Layer,
}

impl PartialEq for BandProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.band, &other.band) && self.layer == other.layer
    }
}

#[component]
fn BandShapes(props: &BandProps) -> Html {
    let BandProps { band, layer } = props;
    let shape = |(tile, d): (usize, &Rc<str>)| {
        html! { <path key={tile} class={layer.class()} d={AttrValue::from(Rc::clone(d))} /> }
    };
    html! { { for band.shapes(*layer).map(shape) } }
}

#[derive(Clone, PartialEq, Properties)]
struct LinesProps {
    class: &'static str,
    every: u32,
    width: u32,
    height: u32,
}

/// The lines between cells.
#[component]
fn Lines(props: &LinesProps) -> Html {
    html! { <path class={props.class} d={lines(props.width, props.height, props.every)} /> }
}

#[derive(Clone, Properties)]
struct HeatProps {
    cast: Rc<Cast>,
}

impl PartialEq for HeatProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.cast, &other.cast)
    }
}

/// A shade for every cell that is used, below what stands there.
#[component]
fn Heat(props: &HeatProps) -> Html {
    let shade = |(index, d): (usize, String)| {
        html! { <path class={format!("heat-{}", index + 1)} {d} /> }
    };
    html! { <g class="heat">{ for heat(&props.cast).into_iter().enumerate().map(shade) }</g> }
}
