//! An agent that is being placed: where it will start, and the way to its goal.

use giveway_page::{Placing, State};
use yew::prelude::*;

use super::marks::{FLAG_CLOTH, FLAG_POLE};
use super::{agents, units};
use crate::glyph;

/// What is seen of it, if there is one.
pub(super) fn show(state: &State) -> Html {
    let Some(Placing { start, goal, .. }) = state.placing() else {
        return Html::default();
    };
    let agent = state.world().agents().len();
    let (from, to) = (
        (units(start.x.into()), units(start.y.into())),
        (units(goal.x.into()), units(goal.y.into())),
    );
    html! {
        <g class={classes!("placing", glyph::class(agent))} aria-hidden="true">
            <line x1={from.0.to_string()} y1={from.1.to_string()} x2={to.0.to_string()} y2={to.1.to_string()} />
            <g class="agent no-battery" transform={format!("translate({} {})", from.0, from.1)}>
                <circle class="halo" r="41" />
                <g class="body">{ crate::form(agent) }{ agents::name(&state.next_name()) }</g>
            </g>
            if goal != start {
                <g class="flag" transform={format!("translate({} {})", 100 * goal.x, 100 * goal.y)}>
                    <path class="pole" d={FLAG_POLE} /><path class="cloth" d={FLAG_CLOTH} />
                </g>
            }
        </g>
    }
}
