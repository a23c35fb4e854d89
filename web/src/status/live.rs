//! The status sentence for those who listen: every change of standing at once,
//! bounds at most once a second.

use giveway_page::words::{Badge, Standing};
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use crate::held::use_held;

/// Milliseconds between two sentences of one solve.
const CALM_MS: u32 = 1000;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct LiveProps {
    /// Where the page stands.
    pub(super) standing: Standing,
}

/// What was said last, and what is to be said.
#[derive(Default)]
struct Pace {
    badge: Option<Badge>,
    next: String,
    /// Runs while nothing is said, after something was.
    calm: Option<Timeout>,
}

/// The live region; read, not seen.
#[component]
pub(super) fn Live(props: &LiveProps) -> Html {
    let said = use_state_eq(|| props.standing.sentence.clone());
    let pace = use_held(Pace::default);
    {
        let said = said.clone();
        use_effect_with(props.standing.clone(), move |standing| {
            let mut now = pace.take();
            now.next.clone_from(&standing.sentence);
            let is_news = now.badge.replace(standing.badge) != Some(standing.badge);
            if !is_news && now.calm.is_some() {
                pace.set(now);
                return;
            }
            said.set(standing.sentence.clone());
            // The first bound of a solve is no repetition.
            now.calm = (!is_news).then(|| {
                let pace = pace.clone();
                Timeout::new(CALM_MS, move || {
                    let now = pace.take();
                    said.set(now.next.clone());
                    pace.set(Pace { calm: None, ..now });
                })
            });
            pace.set(now);
        });
    }
    html! { <p class="vh" role="status">{ (*said).clone() }</p> }
}
