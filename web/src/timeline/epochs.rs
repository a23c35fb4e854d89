//! Where the world changed: a line over the lanes at each time, and the past
//! hatched while it changes.

use giveway_model::tr;
use giveway_page::State;
use giveway_page::course::Course;
use giveway_page::timeline::Axis;
use yew::prelude::*;

/// The lines where the world of the plan that is shown changed, or changes; nothing
/// where it did not.
pub(super) fn show(state: &State, axis: Axis) -> Html {
    let course = state.shown().and_then(|answer| answer.course.as_deref());
    let mut times = course.map_or_else(Vec::new, Course::times);
    // Up to now all is settled.
    let frozen = state.document.mode.changing().map(|changing| changing.at);
    times.extend(frozen.filter(|at| !times.contains(at)));
    if times.is_empty() {
        return Html::default();
    }
    let line = |time: &u32| {
        let x = axis.x(f64::from(*time)).to_string();
        html! {
            <g key={*time}>
                <line x1={x.clone()} x2={x.clone()} y1="0" y2="100%" />
                <circle cx={x} cy="20" r="3.5" />
            </g>
        }
    };
    let list: Vec<String> = times.iter().map(ToString::to_string).collect();
    let label = tr!("The world changed at {times}", times = list.join(", "));
    html! {
        <svg class="epochs" width={axis.width().to_string()} role="img" aria-label={label}>
            if let Some(at) = frozen {
                <defs>
                    <pattern id="past" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
                        <path d="M4 0V8" />
                    </pattern>
                </defs>
                <rect class="past" width={axis.x(f64::from(at)).to_string()} height="100%" />
            }
            { for times.iter().map(line) }
        </svg>
    }
}
