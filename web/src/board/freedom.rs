//! What all best plans share, over the map: the ways of all best plans, what closing cells costs,
//! and where a press closes one for a look.

use giveway_page::board::Detail;
use giveway_page::freedom::{self, Lines, Number, Weight};
use giveway_page::{State, Tool};
use yew::prelude::*;

use crate::glyph;
use crate::part::part;

/// What is drawn, and how fine.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct OverlayProps {
    lines: Vec<Lines>,
    numbers: Vec<Number>,
    detail: Detail,
    /// The robot selected: the lines of the others are paler.
    selected: Option<usize>,
}

/// What lies on the ways, below robots and flags.
pub(super) fn overlay(state: &State, detail: Detail) -> Html {
    if !state.is_laid_over() {
        return Html::default();
    }
    let (lines, numbers) = (freedom::lines(state), freedom::numbers(state));
    let selected = state.selected_agent();
    html! { { part::<Overlay>(OverlayProps { lines, numbers, detail, selected }) } }
}

/// Lines and numbers; drawn anew where more became known.
#[component]
fn Overlay(props: &OverlayProps) -> Html {
    let OverlayProps {
        lines,
        numbers,
        detail,
        selected,
    } = props;
    let is_pale = |agent: usize| selected.is_some_and(|selected| selected != agent);
    // What is in every best plan lies on what is not.
    let layer = |class: [&'static str; 2], path: fn(&Lines) -> &str| {
        let line = |line: &Lines| {
            let d = path(line);
            (!d.is_empty()).then(|| {
                html! {
                    <g key={line.agent} class={classes!(glyph::class(line.agent), is_pale(line.agent).then_some("pale"))}>
                        <path class={class[0]} d={d.to_owned()} /><path class={class[1]} d={d.to_owned()} />
                    </g>
                }
            })
        };
        html! { <>{ for lines.iter().filter_map(line) }</> }
    };
    let number = |number: &Number| match detail {
        Detail::All | Detail::Plain => Some(sign(number)),
        Detail::Numbers | Detail::Forms | Detail::Dots => {
            (number.weight == Weight::NoPlan).then(|| corner(number))
        }
    };
    html! {
        <g class="freedom" aria-hidden="true">
            { layer(["may-halo", "may"], |line| &line.may) }
            { layer(["may-halo", "unsure"], |line| &line.open) }
            { layer(["may-halo", "only"], |line| &line.only) }
            { layer(["must-halo", "must"], |line| &line.must) }
            { for numbers.iter().filter_map(number) }
        </g>
    }
}

/// What closing a cell costs, on it.
fn sign(number: &Number) -> Html {
    let class = match number.weight {
        Weight::Costs => None,
        Weight::NoPlan => Some("no-plan"),
        Weight::Open => Some("open"),
    };
    let (x, y) = place(number);
    let width = number.width();
    let tight = number.is_tight().then(|| (width - 10.0).to_string());
    html! {
        <g class={classes!("price", class)} transform={format!("translate({x} {y})")}>
            <rect width={width.to_string()} height={Number::HEIGHT.to_string()} rx="7" />
            <text x={(width / 2.0).to_string()} y="18.5" textLength={tight.clone()}
                lengthAdjust={tight.map(|_| "spacingAndGlyphs")}>{ number.text.clone() }</text>
        </g>
    }
}

/// A cell without which there is no plan, where numbers are too small to be read.
fn corner(number: &Number) -> Html {
    let (x, y) = (100 * number.cell.x, 100 * number.cell.y);
    html! { <path class="price-corner" d={format!("M{} {}v34h-34z", x + 3, y + 63)} /> }
}

fn place(number: &Number) -> (f64, f64) {
    let at = |cell: u32| 100.0 * f64::from(cell);
    (
        at(number.cell.x) + Number::LEFT,
        at(number.cell.y) + Number::TOP,
    )
}

/// Where a press closes a cell for a look: above the cells, and seen by the pointer alone.
pub(super) fn presses(state: &State, detail: Detail) -> Html {
    let is_selecting = state.view.tool == Tool::Select;
    if !state.is_laid_over() || !is_selecting || !reads_numbers(detail) {
        return Html::default();
    }
    let press = |number: &Number| {
        let title = number.title.clone()?;
        let (x, y) = place(number);
        Some(html! {
            <rect class="price-press" x={x.to_string()} y={y.to_string()} width={number.width().to_string()}
                height={Number::HEIGHT.to_string()} rx="7"><title>{ title }</title></rect>
        })
    };
    html! { <g aria-hidden="true">{ for freedom::numbers(state).iter().filter_map(press) }</g> }
}

/// Whether numbers are large enough to be read, and so to be pressed.
pub(super) const fn reads_numbers(detail: Detail) -> bool {
    matches!(detail, Detail::All | Detail::Plain)
}
