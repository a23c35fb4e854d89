//! What is still to come of an answer: the places that are held, and at the foot the layers with
//! the time that they took.

use giveway_model::tr;
use giveway_model::words::decimal;
use giveway_page::ask::{Coming, Held, LayerStep, Reached};
use gloo::timers::callback::Interval;
use yew::prelude::*;

use crate::part::keyed_part;

/// Milliseconds between two times that are shown.
const TICK_MS: u32 = 100;

#[derive(Clone, PartialEq, Properties)]
struct ProgressProps {
    coming: Coming,
}

/// The layers as bars, what is done now, and the time since it was asked.
pub(super) fn progress(question: &str, coming: &Coming) -> Html {
    let coming = coming.clone();
    keyed_part::<Progress>(question.to_owned(), ProgressProps { coming })
}

#[component]
fn Progress(props: &ProgressProps) -> Html {
    let Coming {
        layers,
        is_looking,
        doing,
        ..
    } = &props.coming;
    let seconds = use_state_eq(|| 0.0_f64);
    {
        let seconds = seconds.clone();
        use_effect_with(*is_looking, move |&is_looking| {
            let begin = js_sys::Date::now();
            // The last time stays where it ended.
            let ticking = is_looking.then(|| {
                Interval::new(TICK_MS, move || {
                    seconds.set((js_sys::Date::now() - begin) / 1000.0);
                })
            });
            move || drop(ticking)
        });
    }
    let bar = |layer: &LayerStep| {
        let (class, state) = match layer.reached {
            Reached::Done => ("done", tr!("a step of a search is" => "done")),
            Reached::Now => ("now", tr!("a step of a search is" => "at work")),
            Reached::Partly => ("partly", tr!("a step of a search is" => "partly done")),
            Reached::Ahead => ("ahead", tr!("a step of a search is" => "open")),
        };
        let now = (layer.reached == Reached::Now).then_some("step");
        html! { <li {class} aria-current={now}><i></i><span>{ layer.name }</span><span class="vh">{ ": " }{ state }</span></li> }
    };
    html! {
        <div class="coming">
            <ol aria-label={tr!("How far the answer is")}>{ for layers.iter().map(bar) }</ol>
            <p>
                <b>{ doing.clone() }</b>
                if *is_looking || *seconds > 0.0 {
                    { " " }<span aria-hidden="true">{ tr!("{seconds} s", seconds = decimal(*seconds, 1)) }</span>
                }
            </p>
        </div>
    }
}

/// Lines where the verdict will stand.
pub(super) fn verdict_place() -> Html {
    html! { <div class="verdict held" aria-hidden="true"><i></i><i></i><i></i></div> }
}

/// Lines where reasons or help will stand, under their heading.
pub(super) fn place(title: &'static str, lines: usize) -> Html {
    html! {
        <section class="held" aria-hidden="true">
            <h3>{ title }</h3>
            { for (0..lines).map(|_| html! { <i></i> }) }
        </section>
    }
}

/// Lines where ways to do without will stand.
pub(super) fn ways(count: u32) -> Html {
    html! { <>{ for (0..count).map(|_| html! { <li class="could held" aria-hidden="true"></li> }) }</> }
}

/// Whether anything is held where the table of who pays will stand.
pub(super) fn rows(held: Held) -> Html {
    let row = |_| html! { <tr class="held"><th></th><td></td><td></td><td></td></tr> };
    html! { <>{ for (0..held.rows).map(row) }</> }
}
