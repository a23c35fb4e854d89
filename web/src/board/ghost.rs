//! Agents that are being placed: where each will start, and the way to its goal.

use giveway_model::{Agent, Cell};
use giveway_page::{Placing, State};
use yew::prelude::*;

use super::marks::{FLAG_CLOTH, FLAG_POLE};
use super::{agents, units};
use crate::glyph;

/// What is seen of it, if there is one.
pub(super) fn show(state: &State) -> Html {
    let first = state.world().agents().len();
    let fleet = state.fleet_agents();
    if !fleet.is_empty() {
        return (first..)
            .zip(&fleet)
            .map(|(index, agent)| robot(index, agent))
            .collect();
    }
    let Some(Placing { start, goal, .. }) = state.placing() else {
        return Html::default();
    };
    let goal = Some(goal).filter(|&goal| goal != start);
    let name = state.next_name();
    let agent = Agent {
        name,
        start,
        goal,
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    robot(first, &agent)
}

/// A robot as it will stand there, by its index in the scene, with the way to its goal.
fn robot(index: usize, agent: &Agent) -> Html {
    let start = agent.start;
    let goal = agent.goal.unwrap_or(start);
    let (from, to) = (
        (units(start.x.into()), units(start.y.into())),
        (units(goal.x.into()), units(goal.y.into())),
    );
    let waypoint = |cell: &Cell| {
        let (x, y) = (units(cell.x.into()), units(cell.y.into()));
        html! { <circle class="stop" cx={x.to_string()} cy={y.to_string()} r="14" /> }
    };
    html! {
        <g class={classes!("placing", glyph::class(index))} aria-hidden="true">
            <line x1={from.0.to_string()} y1={from.1.to_string()} x2={to.0.to_string()} y2={to.1.to_string()} />
            <g class="agent no-battery" transform={format!("translate({} {})", from.0, from.1)}>
                <circle class="halo" r="41" />
                <g class="body">{ crate::form(index) }{ agents::name(&agent.name) }</g>
            </g>
            { for agent.waypoints.iter().map(waypoint) }
            if goal != start {
                <g class="flag" transform={format!("translate({} {})", 100 * goal.x, 100 * goal.y)}>
                    <path class="pole" d={FLAG_POLE} /><path class="cloth" d={FLAG_CLOTH} />
                </g>
            }
        </g>
    }
}
