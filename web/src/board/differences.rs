//! The row under two boards: which difference, of how many, and who; the next one.

use giveway_model::tr;
use giveway_page::beside::{Steps, steps};
use giveway_page::{Action, PlayAction, State};
use yew::prelude::*;

use crate::{glyph, icon};

/// The row; nothing where there are not two plans.
pub(super) fn row(state: &State, send: &Callback<Action>) -> Option<Html> {
    let Steps {
        text,
        agents,
        has_previous,
        has_next,
    } = steps(state)?;
    let step = |is_forward: bool| {
        send.reform(move |_: MouseEvent| Action::Play(PlayAction::Difference(is_forward)))
    };
    let who = |(agent, name): &(usize, String)| {
        html! { <span class="whom">{ glyph::show(*agent, "cost-glyph") }<bdi>{ name.clone() }</bdi></span> }
    };
    Some(html! {
        <div class="dnav" role="group" aria-label={tr!("Differences")}>
            <button type="button" class="btn outline" title={tr!("Previous difference (Shift n)")} aria-label={tr!("Previous difference")}
                aria-disabled={(!has_previous).then_some("true")} onclick={step(false)}>{ icon::show("back") }</button>
            <p aria-live="polite">{ text }{ " " }{ for agents.iter().map(who) }</p>
            <button type="button" class="btn outline" title={tr!("Next difference (n)")}
                aria-disabled={(!has_next).then_some("true")} onclick={step(true)}>
                { icon::show("compare") }<span>{ tr!("Next difference") }</span>
            </button>
        </div>
    })
}
