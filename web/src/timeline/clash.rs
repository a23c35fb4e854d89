//! Where rules leave no plan: when each of them holds, in the place of the lanes.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::rules::{ClashRow, ClashTimes, Lit, RuleAction};
use yew::prelude::*;

use crate::glyph;

/// About so many numbers stand on the axis.
const NUMBERS: u32 = 20;

/// The times of the rules that leave no plan.
pub(super) fn show(times: &ClashTimes, send: &Callback<Action>) -> Html {
    let columns = times.last + 1;
    let every = columns.div_ceil(NUMBERS).max(1);
    let percent = move |time: f64| format!("{:.3}%", time * 100.0 / f64::from(columns));
    let number = |time: u32| {
        html! { <text x={percent(f64::from(time) + 0.5)} y="13" text-anchor="middle">{ time }</text> }
    };
    let numbers = (0..columns).filter(|time| time % every == 0).map(number);
    html! {
        <div class="clash" id="lanes" role="group" aria-label={tr!("When the rules that leave no plan hold")}>
            <div class="clash-row ruler"><span class="lab">{ tr!("Time") }</span>
                <svg aria-hidden="true"><defs>
                    <pattern id="clash-shut" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><path d="M4 0V8" /></pattern>
                </defs>{ for numbers }</svg>
            </div>
            { for times.rows.iter().map(|of| row(of, times.last, &percent, send)) }
        </div>
    }
}

fn row(of: &ClashRow, last: u32, percent: &dyn Fn(f64) -> String, send: &Callback<Action>) -> Html {
    let rule = of.rule;
    let light =
        move |is_lit: bool| Action::Rules(RuleAction::Light(is_lit.then_some(Lit::Rule(rule))));
    let bar = of.times.map(|(from, to)| {
        let (from, to) = (from.min(last), to.min(last));
        let class = if of.agent.is_some() || of.ends.is_some() {
            "can"
        } else {
            "shut"
        };
        let width = percent(f64::from(to + 1 - from));
        html! { <rect {class} x={percent(f64::from(from))} y="4" {width} height="18" rx="4" /> }
    });
    let end = of.ends.map(|time| {
        let x = percent(f64::from(time.min(last) + 1));
        html! { <line class="end" x1={x.clone()} x2={x} y1="2" y2="24" /> }
    });
    // The note stands on the side that has room.
    let note = of.note.as_ref().map(|note| {
        let first = of.times.map_or(of.ends.unwrap_or(0), |times| times.0);
        let is_left = first * 2 > last;
        let after = of
            .times
            .map_or(first, |times| times.1)
            .max(of.ends.unwrap_or(0));
        let (x, dx, anchor) = if is_left {
            (percent(f64::from(first)), "-8", "end")
        } else {
            (percent(f64::from(after.min(last)) + 1.0), "8", "start")
        };
        html! { <text {x} {dx} y="17" text-anchor={anchor}>{ note.clone() }</text> }
    });
    let class = classes!(
        "clash-row",
        of.is_lit.then_some("lit"),
        of.agent.map(glyph::class)
    );
    html! {
        <div key={of.number} {class} onmouseenter={send.reform(move |_| light(true))} onmouseleave={send.reform(move |_| light(false))}>
            <button type="button" class="lab" aria-label={format!("{} {} {}: {}", of.number, of.title, of.what, of.label)}
                onfocus={send.reform(move |_| light(true))} onblur={send.reform(move |_| light(false))}
                onclick={send.reform(move |_| Action::Rules(RuleAction::Show(rule)))}>
                <b class="no">{ of.number }</b>{ " " }
                <span><b>{ of.title.clone() }</b>{ " " }<small>{ of.what }</small></span>
            </button>
            <svg aria-hidden="true">{ for bar }{ for end }{ for note }</svg>
        </div>
    }
}
