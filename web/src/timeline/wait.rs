//! While no plan is there: what is proved, what is found, and the gap between.

use giveway_model::tr;
use giveway_page::timeline::{Gauge, Row, gauge, work_done};
use giveway_page::{Draft, Solving, words};
use giveway_picture::whole;
use gloo::timers::callback::Interval;
use yew::prelude::*;

use crate::held::use_held;

/// The width of the bar on a phone, in pixels.
const NARROWEST: f64 = 290.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct WaitProps {
    /// The number of the job.
    pub id: u64,
    pub run: Solving,
    /// Whether the plan table will be open.
    pub table: bool,
}

/// How far the solve has come, in the room that the lanes will take.
#[component]
pub(super) fn Wait(props: &WaitProps) -> Html {
    let WaitProps { id, run, table } = props;
    let seconds = use_state_eq(|| 0_u32);
    {
        let seconds = seconds.clone();
        use_effect_with(*id, move |_| {
            seconds.set(0);
            let begin = js_sys::Date::now();
            let ticking = Interval::new(1000, move || {
                seconds.set(whole((js_sys::Date::now() - begin) / 1000.0));
            });
            move || drop(ticking)
        });
    }
    let gauge = gauge(run);
    // The bar grows from the left and shrinks from the right, and nothing else:
    // its scale never becomes smaller within a cost.
    let widest = use_held(|| ((0, gauge.cost), 0));
    let scale = {
        let (of, before) = widest.get();
        let scale = if of == (*id, gauge.cost) {
            before.max(gauge.scale())
        } else {
            gauge.scale()
        };
        widest.set(((*id, gauge.cost), scale));
        scale
    };
    let mut work = vec![work_done(run.size)];
    work.push(tr!("{seconds} s", seconds = *seconds));
    work.retain(|part| !part.is_empty());
    html! {
        <>
            { room(&run.draft, *table) }
            <div class="bound">
                <p class="bl">
                    <b>{ words::title(gauge.cost) }</b>
                    if let Some(least) = gauge.at_least {
                        <span>{ tr!("proved: at least") }{ " " }<b>{ least }</b></span>
                    }
                    if let Some(best) = gauge.best {
                        <span>{ tr!("best plan so far") }{ " " }<b>{ best }</b></span>
                    }
                </p>
                { bar(&gauge, scale) }
                <p class="bl"><span>{ gauge.sentence.clone() }</span><span class="grow"></span><span>{ work.join(", ") }</span></p>
            </div>
        </>
    }
}

fn bar(gauge: &Gauge, scale: u32) -> Html {
    let share = |n: u32| f64::from(n.min(scale)) / f64::from(scale) * 100.0;
    let percent = |n: f64| format!("{n:.2}%");
    let least = gauge.at_least.map(share);
    let best = gauge.best.map(share);
    let from = least.unwrap_or(0.0);
    // Two numbers side by side must not touch, on the narrowest bar either.
    let digits = gauge.best.unwrap_or(0).to_string().len() as f64;
    let apart = (digits * 7.5 + 8.0) / NARROWEST * 100.0;
    let both = least
        .zip(best)
        .is_some_and(|(least, best)| best - least < apart);
    let is_met = gauge.at_least.is_some() && gauge.at_least == gauge.best;
    let tick = |at: f64, anchor: &'static str, n: u32| {
        let aside = match anchor {
            "end" => "-3",
            "start" => "3",
            _ => "0",
        };
        html! { <text class="tick" x={percent(at)} dx={aside} y="12" text-anchor={anchor}>{ n }</text> }
    };
    html! {
        <div class="bt" aria-hidden="true">
            <svg class="bt-bar" width="100%" height="14">
                <defs>
                    <pattern id="gap" width="9" height="14" patternUnits="userSpaceOnUse" patternTransform="skewX(-25)">
                        <rect class="gap-a" width="9" height="14" /><rect class="gap-b" width="4" height="14" />
                    </pattern>
                </defs>
                <rect class="bt-floor" width="100%" height="14" />
                if let Some(best) = best {
                    <rect class="bt-gap" x={percent(from)} width={percent((best - from).max(0.0))} height="14" />
                }
                if let Some(least) = least {
                    <rect class="bt-done" width={percent(least)} height="14" />
                }
            </svg>
            <svg class="bt-ticks" width="100%" height="18">
                <text class="tick zero" x="0" y="12">{ "0" }</text>
                if let (Some(n), Some(at)) = (gauge.at_least, least) {
                    { tick(at, if both && !is_met { "end" } else { "middle" }, n) }
                }
                if let (Some(n), Some(at), false) = (gauge.best, best, is_met) {
                    { tick(at, if both { "start" } else { "middle" }, n) }
                }
            </svg>
        </div>
    }
}

/// The room that transport, lanes and table will take: nothing jumps when the
/// plan arrives.
fn room(draft: &Draft, table: bool) -> Html {
    let agents = draft.agents().len();
    let with_battery = draft
        .agents()
        .iter()
        .filter(|agent| agent.battery.is_some());
    let batteries = with_battery.count();
    let row = Row::of(agents, batteries);
    let lanes = 24.0 + agents as f64 * row.height;
    let rows = (agents + batteries) * 22 + 5;
    html! {
        <div class="room" aria-hidden="true">
            <div class="transport"></div>
            <div class={classes!("lanes", row.class())}><svg class="spacer" width="1" height={lanes.to_string()} /></div>
            <div class={classes!("tblwrap", (!table).then_some("closed"))}><svg class="spacer" width="1" height={rows.to_string()} /></div>
        </div>
    }
}
