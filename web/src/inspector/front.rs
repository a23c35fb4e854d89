//! The Pareto front: a plot whose points are plans, and each of them as a button.

use giveway_model::tr;
use giveway_page::front::Plot;
use giveway_page::{Action, SolveAction, State};
use yew::prelude::*;

/// Above the points: room for their halves and the title.
const TOP: u32 = 34;
/// Left of the points: room for their halves, and for a digit of the numbers.
const LEFT: u32 = 24;
const DIGIT: u32 = 8;

/// The front of the scene on the board, where one was found.
#[inline(never)]
pub(super) fn show(state: &State, send: &Callback<Action>) -> Html {
    let Some(front) = state
        .document
        .front()
        .filter(|front| !front.points.is_empty())
    else {
        return Html::default();
    };
    let chosen = state.document.answer.as_ref();
    let chosen = chosen.and_then(|answer| front.place_of(answer));
    let one = |point: usize| {
        let is_chosen = chosen == Some(point);
        html! {
            <li><button type="button" class="choice" aria-pressed={is_chosen.to_string()}
                onclick={send.reform(move |_| Action::Solve(SolveAction::ShowPoint(point)))}>
                <span>{ front.name(point) }</span>
            </button></li>
        }
    };
    html! {
        <section class="front">
            <h3>{ tr!("Pareto front") }</h3>
            { plot(&front.plot(), chosen, send) }
            <ul class="choices" aria-label={tr!("Pareto front")}>{ for (0..front.points.len()).map(one) }</ul>
            <p class="remark">{ front.claim() }</p>
        </section>
    }
}

/// The picture: what its points are is said by the buttons below it.
fn plot(plot: &Plot, chosen: Option<usize>, send: &Callback<Action>) -> Html {
    let (width, height) = Plot::ROOM;
    let [least, most] = plot.across;
    let [low, high] = plot.up;
    let left = LEFT + DIGIT * (high.max(1).ilog10() + 1);
    let (right, bottom) = (left + width, TOP + height);
    let point = |(at, &(x, y)): (usize, &(u32, u32))| {
        let class = classes!("pt", (chosen == Some(at)).then_some("on"));
        html! {
            <circle {class} cx={(left + x).to_string()} cy={(TOP + y).to_string()} r="7"
                onclick={send.reform(move |_| Action::Solve(SolveAction::ShowPoint(at)))} />
        }
    };
    let text = |x: u32, y: u32, anchor: &'static str, text: String| {
        html! { <text x={x.to_string()} y={y.to_string()} text-anchor={anchor}>{ text }</text> }
    };
    html! {
        <svg class="plot" viewBox={format!("0 0 {} {}", right + 20, bottom + 36)} aria-hidden="true">
            <path d={format!("M{0} {TOP}V{1}H{right}", left - 14, bottom + 10)} />
            { text(left - 20, bottom + 4, "end", low.to_string()) }
            if high > low { { text(left - 20, TOP + 4, "end", high.to_string()) } }
            { text(left, bottom + 26, "middle", least.to_string()) }
            if most > least { { text(right, bottom + 26, "middle", most.to_string()) } }
            { text(left + width / 2, bottom + 26, "middle", plot.titles[0].to_owned()) }
            { text(2, TOP - 22, "start", plot.titles[1].to_owned()) }
            { for plot.points.iter().enumerate().map(point) }
        </svg>
    }
}
