//! How many robots the floor bears: three charts over the number of robots.

use std::fmt::Write as _;

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::sizing::{Chart, Dot, SizingAction, charts, table};
use yew::prelude::*;

use super::{DockProps, clock, places, play_keys};
use crate::{Shown, copy, icon};

/// The room for the dots of a chart, in units, and where it begins.
const ROOM: (f64, f64) = (270.0, 112.0);
const CORNER: (f64, f64) = (34.0, 8.0);
/// The room of a chart with its numbers.
const WHOLE: (f64, f64) = (316.0, 142.0);

/// The charts, with what can be done with all of them above.
#[component]
pub(super) fn Sizing(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let all = charts(state);
    let has_beside = all.iter().any(|chart| !chart.beside.is_empty());
    html! {
        <section class="dock sizing" aria-label={tr!("How many?")}>
            <div class="rhead">
                { places(state, send) }
                if state.playing().is_some() { { play_keys(state, send) }{ clock(state, send) } }
                <span class="grow"></span>
                { tools(state, send) }
            </div>
            if all.is_empty() {
                <div class="nil">{ icon::show("many") }<p><b>{ tr!("Nothing solved yet") }</b>{ tr!("Say how many robots, then solve: three charts come here.") }</p></div>
            } else {
                <div class="sizes" tabindex="0" role="group" aria-label={tr!("Charts")}>{ for all.iter().map(|chart| show(chart, send)) }</div>
                <p class="legend-of-charts">
                    <span><i class="dot proved"></i>{ tr!("a plan is" => "proved") }</span>
                    <span><i class="dot open"></i>{ tr!("best so far; the bar ends at what is proved") }</span>
                    if has_beside { <span><i class="dot other"></i>{ tr!("the floor beside it") }</span> }
                </p>
            }
        </section>
    }
}

fn tools(state: &Shown, send: &Callback<Action>) -> Html {
    let Some(text) = table(state) else {
        return Html::default();
    };
    let copies = {
        let send = send.clone();
        Callback::from(move |_: MouseEvent| copy::table(&text, &send))
    };
    let saves = {
        let state = state.clone();
        Callback::from(move |_: MouseEvent| crate::files::save_sizing(&state))
    };
    html! {
        <>
            <button type="button" class="btn ghost round" aria-label={tr!("Save as a table")} title={tr!("Save as a table")} onclick={saves}>{ icon::show("save") }</button>
            <button type="button" class="btn ghost round" aria-label={tr!("Copy for a spreadsheet")} title={tr!("Copy for a spreadsheet")} onclick={copies}>{ icon::show("copy") }</button>
        </>
    }
}

fn show(chart: &Chart, send: &Callback<Action>) -> Html {
    let line = |tick: &giveway_page::sizing::Tick| {
        let y = at((0.0, tick.at)).1;
        html! {
            <>
                <path class="across" d={format!("M{} {y}H{}", CORNER.0, CORNER.0 + ROOM.0)} />
                <text x={(CORNER.0 - 6.0).to_string()} y={(y + 4.0).to_string()} text-anchor="end">{ tick.text.clone() }</text>
            </>
        }
    };
    let below = |tick: &giveway_page::sizing::Tick| {
        let (x, y) = at((tick.at, 0.0));
        html! { <text x={x.to_string()} y={(y + 17.0).to_string()} text-anchor="middle">{ tick.text.clone() }</text> }
    };
    let other = |dot: &Dot| {
        let (x, y) = at(dot.at);
        html! { <rect class="other" x={(x - 2.5).to_string()} y={(y - 2.5).to_string()} width="5" height="5" /> }
    };
    // Plans that lie close are each pressed at their own place.
    let places: Vec<f64> = chart.dots.iter().flatten().map(|dot| dot.at.0).collect();
    let ways = places.windows(2).map(|pair| pair[1] - pair[0]);
    let half = ways.fold(1.0, f64::min) * ROOM.0 / 2.0;
    let looked = chart.dots.iter().flatten().find(|dot| dot.is_looked);
    html! {
        <figure class="size-chart">
            <figcaption><b>{ chart.title }</b>{ " " }<small>{ chart.unit }</small></figcaption>
            <svg viewBox={format!("0 0 {} {}", WHOLE.0, WHOLE.1)} role="img" aria-label={chart.aloud.clone()}>
                { for chart.lines.iter().map(line) }
                { for chart.robots.iter().map(below) }
                if let Some(dot) = looked {
                    <path class="looked" d={format!("M{} {}V{}", at(dot.at).0, CORNER.1, CORNER.1 + ROOM.1)} />
                }
                <path class="other-line" d={path(&chart.beside)} />
                { for chart.beside.iter().flatten().map(other) }
                <path class="own-line" d={path(&chart.dots)} />
                { for chart.dots.iter().flatten().map(|dot| own(dot, half, send)) }
            </svg>
        </figure>
    }
}

/// A plan: pressing it brings it onto the board. `half` is half the way to the next one.
fn own(dot: &Dot, half: f64, send: &Callback<Action>) -> Html {
    let (x, y) = at(dot.at);
    let low = at((dot.at.0, dot.low)).1;
    let class = classes!(
        "own",
        if dot.is_proved { "proved" } else { "open" },
        dot.is_looked.then_some("on")
    );
    let place = (!dot.is_looked).then_some(dot.place);
    let onclick = send.reform(move |_: MouseEvent| Action::Sizing(SizingAction::Look(place)));
    html! {
        <g {class} {onclick}>
            <title>{ dot.text.clone() }</title>
            if low > y + 1.0 { <path class="low" d={format!("M{x} {y}V{low}M{} {low}h8", x - 4.0)} /> }
            <circle class="hit" cx={x.to_string()} cy={y.to_string()} r={half.min(12.0).to_string()} />
            <circle cx={x.to_string()} cy={y.to_string()} r={half.clamp(2.0, 4.5).to_string()} />
            if dot.is_looked { <text class="value" x={(x - 8.0).to_string()} y={(y - 8.0).max(12.0).to_string()} text-anchor="end">{ dot.text.clone() }</text> }
        </g>
    }
}

/// Where a place from 0 to 1 is in a chart, in units.
fn at((x, y): (f64, f64)) -> (f64, f64) {
    let tenth = |n: f64| (n * 10.0).round() / 10.0;
    (
        tenth(CORNER.0 + x * ROOM.0),
        tenth(CORNER.1 + (1.0 - y) * ROOM.1),
    )
}

/// A line through the plans, with a gap where one was not solved.
fn path(dots: &[Option<Dot>]) -> String {
    let mut path = String::new();
    let mut is_down = false;
    for dot in dots {
        if let Some(dot) = dot {
            let (x, y) = at(dot.at);
            let _ = write!(path, "{}{x} {y}", if is_down { "L" } else { "M" });
        }
        is_down = dot.is_some();
    }
    path
}
