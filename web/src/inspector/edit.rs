//! What is edited beside the board: an agent, or the scene as a whole.

use giveway_model::constraint::Heading;
use giveway_model::words::Later;
use giveway_model::{Agent, Battery, tr};
use giveway_page::board::quarter;
use giveway_page::grow::GrowAction;
use giveway_page::robots::RobotsAction;
use giveway_page::{
    Action, BoardAction, COLOURS, DENSEST, Edit, Fill, Fold, MAX_AGENTS, MAX_SIDE, Phase, Problem,
    Selection, ViewAction,
};
use web_sys::Element;
use yew::prelude::*;

use super::floor_plan;
use super::units::units;
use crate::field::FieldProps;
use crate::field::{Field, number};
use crate::part::part;
use crate::{Shown, glyph, icon};

/// The largest battery that can be set, in steps.
const CAPACITY: u32 = 100_000;
/// The battery that an agent gets at first.
const BATTERY: Battery = Battery {
    capacity: 20,
    initial: 20,
};

/// What can be edited of an agent.
pub(super) fn agent(state: &Shown, index: usize, send: &Callback<Action>) -> Html {
    let Some(agent) = state.document.draft.agents().get(index) else {
        return Html::default();
    };
    let edit = |make: fn(usize, String) -> Edit| {
        send.reform(move |text: String| Action::Edit(make(index, text)))
    };
    let waypoint = |&cell: &giveway_model::Cell| {
        let name = format!("({}, {})", cell.x, cell.y);
        let press = send.reform(move |_: MouseEvent| Action::Edit(Edit::DropWaypoint(index, cell)));
        html! {
            <li>{ &name }<button type="button" class="btn ghost round" onclick={press}
                aria-label={tr!("Remove waypoint {name}", name)} title={tr!("Remove")}>
                { icon::show("cancel") }
            </button></li>
        }
    };
    let remove = send.reform(move |_: MouseEvent| Action::Edit(Edit::RemoveAgent(index)));
    let body = html! {
        <>
            { part::<Field>(FieldProps { label: (tr!("Name")).into(), value: (agent.name.clone()).into(), on_change: edit(Edit::Rename), empty: None, range: None, is_measure: false }) }
            { colour(state, index, send) }
            { faces(state, agent, index, send) }
            { battery(agent, index, send) }
            if !agent.waypoints.is_empty() {
                <ul class="removable" aria-label={tr!("Waypoints")}>
                    { for agent.waypoints.iter().map(waypoint) }
                </ul>
            }
            <button type="button" class="btn outline" onclick={remove}>{ tr!("Delete robot") }</button>
        </>
    };
    section(state, Fold::Robot, tr!("Edit robot"), body, send)
}

/// The colours to choose from; the form stays, so that no two look the same.
fn colour(state: &Shown, index: usize, send: &Callback<Action>) -> Html {
    let chosen = state.document.colours.of(glyph::look(index));
    let swatch = |(colour, name): (usize, &Later)| {
        let name = name.text();
        let choose = send.reform(move |_: Event| Action::Edit(Edit::Recolour(index, colour)));
        html! {
            <label key={colour} title={name}>
                <input type="radio" name="colour" aria-label={name} checked={colour == chosen} onchange={choose} /><i></i>
            </label>
        }
    };
    html! {
        <div class="swatches" role="radiogroup" aria-label={tr!("Colour")}>
            { for COLOURS.iter().enumerate().map(swatch) }
        </div>
    }
}

/// Where it faces at its start, where turns take time.
fn faces(state: &Shown, agent: &Agent, index: usize, send: &Callback<Action>) -> Html {
    if quarter(state.document.draft.scene(), agent) == 0 {
        return Html::default();
    }
    let button = |name: &'static str, heading: Option<Heading>| {
        let press = send.reform(move |_: MouseEvent| Action::Edit(Edit::Face(index, heading)));
        let is_on = agent.heading == heading;
        html! { <button type="button" aria-pressed={is_on.to_string()} onclick={press}>{ name }</button> }
    };
    html! {
        <>
            <p class="label" id="faces">{ tr!("Faces at its start") }</p>
            <div class="seg full" role="group" aria-labelledby="faces">
                { button(tr!("a robot faces" => "Any"), None) }
                { button(tr!("Up"), Some(Heading::North)) }
                { button(tr!("Right"), Some(Heading::East)) }
                { button(tr!("Down"), Some(Heading::South)) }
                { button(tr!("Left"), Some(Heading::West)) }
            </div>
        </>
    }
}

fn battery(agent: &Agent, index: usize, send: &Callback<Action>) -> Html {
    let set = {
        let send = send.clone();
        move |battery| send.emit(Action::Edit(Edit::SetBattery(index, battery)))
    };
    let kind = |name: &'static str, battery: Option<Battery>| {
        let set = set.clone();
        let is_on = battery.is_some() == agent.battery.is_some();
        let press = Callback::from(move |_: MouseEvent| {
            if !is_on {
                set(battery);
            }
        });
        html! { <button type="button" aria-pressed={is_on.to_string()} onclick={press}>{ name }</button> }
    };
    html! {
        <>
            <div class="seg full" role="group" aria-label={tr!("Battery")}>
                { kind(tr!("No battery limit"), None) }
                { kind(tr!("Battery"), Some(BATTERY)) }
            </div>
            if let Some(battery) = agent.battery {
                <div class="fields">
                    { number(tr!("Capacity, steps"), Some(battery.capacity), (0, CAPACITY), None, &{
                        let set = set.clone();
                        Callback::from(move |n: Option<u32>| {
                            set(Some(Battery { capacity: n.unwrap_or(0), ..battery }));
                        })
                    }) }
                    { number(tr!("At the start"), Some(battery.initial), (0, battery.capacity), None, &{
                        let set = set.clone();
                        Callback::from(move |n: Option<u32>| {
                            set(Some(Battery { initial: n.unwrap_or(0), ..battery }));
                        })
                    }) }
                </div>
            }
        </>
    }
}

/// What can be edited of the scene as a whole.
pub(super) fn whole(state: &Shown, send: &Callback<Action>) -> Html {
    let grid = state.document.draft.grid();
    let (width, height) = (grid.width(), grid.height());
    let side = |make: fn(u32, u32, u32) -> GrowAction| {
        send.reform(move |n: Option<u32>| Action::Grow(make(n.unwrap_or(1), width, height)))
    };
    let open = send.reform(|_: MouseEvent| Action::Grow(GrowAction::Open));
    let fill = state.settings.fill;
    let set = |make: fn(u32, Fill) -> Fill| {
        send.reform(move |n: Option<u32>| {
            Action::View(ViewAction::SetFill(make(n.unwrap_or(0), fill)))
        })
    };
    let rename = send.reform(|name| Action::Edit(Edit::Name(name)));
    let strew = send.reform(move |_: MouseEvent| Action::Edit(Edit::Fill(fill)));
    let clear = send.reform(|_: MouseEvent| Action::Edit(Edit::Clear));
    let sides = (1, MAX_SIDE);
    let most = MAX_AGENTS as u32;
    let body = html! {
        <>
            { part::<Field>(FieldProps { label: (tr!("Name")).into(), value: (state.document.draft.scene().name.clone()).into(), on_change: rename, empty: None, range: None, is_measure: false }) }
            <div class="fields">
                { number(tr!("Width, cells"), Some(width), sides, None, &side(|n, _, height| GrowAction::To(n, height))) }
                { number(tr!("Height, cells"), Some(height), sides, None, &side(|n, width, _| GrowAction::To(width, n))) }
            </div>
            { units(state, send) }
            { floor_plan::beside(state, send) }
            if state.can_grow() {
                <button type="button" class="btn outline" onclick={open}>{ icon::show("grow") }{ tr!("Rows and columns at any side") }</button>
            }
            if state.can_show_robots() && !state.shows_robots() {
                <button type="button" class="btn outline" onclick={send.reform(|_: MouseEvent| Action::Robots(RobotsAction::Show(true)))}>{ icon::show("table") }{ tr!("Robots as a table") }</button>
            }
            <h3>{ tr!("Random scene") }</h3>
            <div class="fields">
                { number(tr!("Obstacles, %"), Some(fill.obstacles), (0, DENSEST), None, &set(|obstacles, fill| Fill { obstacles, ..fill })) }
                { number(tr!("Robots"), Some(fill.agents), (0, most), None, &set(|agents, fill| Fill { agents, ..fill })) }
                { number(tr!("Seed"), Some(fill.seed), (0, u32::MAX), None, &set(|seed, fill| Fill { seed, ..fill })) }
            </div>
            <div class="pair">
                <button type="button" class="btn outline" onclick={strew}>{ tr!("Random scene") }</button>
                <button type="button" class="btn outline" onclick={clear}>{ tr!("Clear") }</button>
            </div>
        </>
    };
    section(state, Fold::Scene, tr!("Edit scene"), body, send)
}

/// Open while a scene without a plan is edited, else a line that opens it. Once open it stays so
/// until a person folds it: nothing moves when something beside it changes the scene.
fn section(
    state: &Shown,
    fold: Fold,
    title: &'static str,
    body: Html,
    send: &Callback<Action>,
) -> Html {
    let is_new = state.phase() == Phase::Editing && state.document.answer.is_none();
    let is_open = state.view.folds.of(fold).unwrap_or(is_new);
    // The browser folds by itself, too, when words in it are looked for.
    let send = send.clone();
    let ontoggle = move |event: Event| {
        let details = event.target_dyn_into::<Element>();
        let now = details.is_some_and(|details| details.has_attribute("open"));
        if now != is_open || is_new {
            send.emit(Action::View(ViewAction::Unfold(fold, now)));
        }
    };
    html! {
        <details class="edit" open={is_open} {ontoggle}>
            <summary>{ title }</summary>
            <div class="edit-body">{ body }</div>
        </details>
    }
}

/// What is wrong, of all that a function takes; pressing one shows its cell.
pub(super) fn problems(
    state: &Shown,
    send: &Callback<Action>,
    takes: impl Fn(&Problem) -> bool,
) -> Html {
    let problems: Vec<&Problem> = state
        .document
        .draft
        .problems()
        .iter()
        .filter(|p| takes(p))
        .collect();
    if problems.is_empty() {
        return Html::default();
    }
    let one = |problem: &&Problem| {
        let text = html! { <>{ icon::show("warning") }<span>{ problem.sentence() }</span></> };
        match problem.cell {
            Some(cell) => {
                let show = send.reform(move |_: MouseEvent| {
                    Action::Board(BoardAction::Select(Selection::Cell(cell)))
                });
                html! { <li><button type="button" class="problem" onclick={show}>{ text }</button></li> }
            }
            None => html! { <li class="problem">{ text }</li> },
        }
    };
    html! {
        <section>
            <h3>{ tr!("Problems") }{ " " }<span class="count">{ problems.len() }</span></h3>
            <ul class="problems">{ for problems.iter().take(MOST).map(one) }</ul>
        </section>
    }
}

/// So many problems are told at once.
const MOST: usize = 20;
