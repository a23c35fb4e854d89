//! The inspector: the agent or cell selected, at the time shown; the plan as a
//! whole where nothing is.

mod agent;
mod answer;
mod area;
mod audit;
mod breakdown;
mod by_hand;
mod cell;
mod change;
mod coming;
mod edit;
mod fleet;
mod floor_plan;
mod freedom;
mod front;
mod groups;
mod grow;
mod inside;
mod ledger;
mod order;
mod pays;
mod planners;
mod prices;
mod proof;
mod questions;
mod rule_card;
mod rules;
mod sizing;
mod slot_editor;
mod steer;
mod tight;
mod units;
mod whole;

use giveway_model::tr;
use giveway_page::{Action, BoardAction, Selection, State, ask, changing, inspect};
use yew::prelude::*;

use crate::part::part;
use crate::{Shown, icon};

/// The state and where actions go.
#[derive(Clone, PartialEq, Properties)]
pub struct InspectorProps {
    /// The state.
    pub state: Shown,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// What is selected, at the time shown.
#[component]
pub fn Inspector(props: &InspectorProps) -> Html {
    let InspectorProps { state, send } = props;
    // Whoever is led is told of from the top, wherever the button was that began it.
    let led = state
        .document
        .mode
        .steering()
        .map_or(0, |own| own.agent + 1);
    // So is what must be so, and a cell that is closed to see what then must be.
    let column = giveway_page::freedom::column(state);
    let column = column.filter(|_| state.view.selection == Selection::Nothing);
    let above = match (state.closed_cell(), &column) {
        (Some(_), _) => "closed",
        (None, Some(_)) => "freedom",
        (None, None) => "",
    };
    let opened = use_state_eq(String::new);
    let elsewhere = giveway_page::audit::facts(state);
    // Another agent or a cell is looked at in between.
    let elsewhere = elsewhere.filter(|_| state.view.selection == Selection::Nothing);
    let step = giveway_page::inside::column(state);
    let step = step.filter(|_| state.view.selection == Selection::Nothing);
    let is_by_hand = state.is_by_hand() && state.view.selection == Selection::Nothing;
    let hand = is_by_hand
        .then(|| giveway_page::inside::by_hand::column(state))
        .flatten();
    let losses = giveway_page::ledger::column(state);
    let losses = losses.filter(|_| state.view.selection == Selection::Nothing);
    let order = giveway_page::order::column(state);
    let order = order.filter(|_| state.view.selection == Selection::Nothing);
    // Without a timeline a phone has no tabs: this place is all there is.
    let alone = (!state.has_timeline()).then_some("alone");
    // What is told of another robot or cell is read from its beginning.
    use_effect_with((state.view.selection, led), |_| to_top());
    html! {
        <aside class={classes!("insp", alone)} id="inspector" aria-label={tr!("Inspector")}>
            if let Some(column) = hand {
                { part::<by_hand::Hand>(by_hand::HandProps { column, send: send.clone() }) }
            } else if let Some(column) = step {
                // Where no button is in it, the keyboard scrolls the place itself.
                <div class="scroll" key={format!("inside {}", column.title)} tabindex={(!column.has_buttons()).then_some("0")}>{ inside::show(&column, state, send) }</div>
                { inside::foot(&column, send) }
            } else if let Some(card) = giveway_page::sizing::card(state) {
                <div class="scroll" key="sizing">{ sizing::show(&card, send) }</div>
                { sizing::foot(&card, send) }
            } else if let Some(card) = giveway_page::fleet::card(state) {
                <div class="scroll" key="fleet">{ fleet::show(&card, send) }</div>
                { fleet::foot(&card, send) }
            } else if let Some(card) = giveway_page::floor_plan::card(state) {
                <div class="scroll" key="floor plan">{ floor_plan::show(&card, send) }</div>
                { floor_plan::foot(&card, send) }
            } else if let Some(card) = giveway_page::grow::card(state) {
                <div class="scroll" key="grow">{ grow::show(&card, send) }</div>
                { grow::foot(&card, send) }
            } else if let Some(card) = giveway_page::area::card(state) {
                <div class="scroll" key="area">{ area::show(&card, state, send) }{ grow::lines(state, send) }</div>
            } else if let Some(card) = giveway_page::rules::card(state) {
                <div class="scroll" key="rule">{ rule_card::show(&card, send) }</div>
                { rule_card::foot(&card, send) }
            } else if let Some(card) = ask::card(state) {
                <div class="scroll">{ answer::show(&card, send) }{ proof::show(state, send) }</div>
                { answer::foot(&card, send) }
            } else if let Some(column) = losses {
                <div class="scroll" key="ledger">{ ledger::show(&column, send) }</div>
                { ledger::foot(&column, send) }
            } else if let Some(column) = order {
                <div class="scroll" key="order">{ order::show(&column, send) }</div>
                { order::foot(&column, send) }
            } else if let Some(facts) = &elsewhere {
                <div class="scroll" key={format!("audit {}", facts.file)}>
                    { audit::show(facts, giveway_page::audit::conflicts(state).as_ref(), &opened, send) }
                    { questions::show(&ask::offers(state), send) }
                </div>
                { audit::foot(facts, state.view.is_wide, send) }
            } else {
                <div class="scroll" key={format!("{led} {above}")}>
                    { content(state, send) }
                    { rules::begin(state, send) }
                    { steer::begin(state, send) }
                    { state.selected_agent().map(|agent| change::breaks_down(state, agent, send)) }
                    { change::begin(state, send) }
                    { questions::show(&questions(state, ask::About::Plan), send) }
                    if let Some(why) = ask::no_offers(state) {
                        <p class="remark">{ why }</p>
                    }
                </div>
                if state.document.mode.changing().is_some() { { change::foot(send) } }
                if state.document.mode.steering().is_some() { { steer::foot(send) } }
            }
        </aside>
    }
}

fn to_top() {
    let scroll = gloo::utils::document().query_selector("#inspector > .scroll");
    if let Ok(Some(scroll)) = scroll {
        scroll.set_scroll_top(0);
    }
}

fn content(state: &Shown, send: &Callback<Action>) -> Html {
    if let Some(facts) = changing::facts(state) {
        return while_changing(state, &facts, send);
    }
    if let Some(led) = steer::show(state, send) {
        return led;
    }
    match state.view.selection {
        Selection::Agent(index) => match inspect::agent(state, index) {
            Some(facts) => html! {
                <>
                    { agent::show(state, &facts, send) }
                    { questions::show(&questions(state, ask::About::Moment), send) }
                    { rules::question(state, send) }
                    { questions::show(&questions(state, ask::About::Selected), send) }
                    { freedom::part(state, send) }
                    { audit::conflicts(giveway_page::audit::conflicts(state).as_ref(), send) }
                    { edit::problems(state, send, |problem| problem.agent == Some(index)) }
                    { edit::agent(state, index, send) }
                </>
            },
            None => whole::show(state, send),
        },
        Selection::Cell(cell) => match inspect::cell(state, cell) {
            Some(facts) => html! {
                <>
                    { cell::show(state, &facts, send) }
                    { rules::question(state, send) }
                    { questions::show(&questions(state, ask::About::Selected), send) }
                    { freedom::part(state, send) }
                    { edit::problems(state, send, |problem| problem.cell == Some(cell)) }
                </>
            },
            None => whole::show(state, send),
        },
        Selection::Nothing => match giveway_page::freedom::column(state) {
            Some(column) => {
                let save = proof::saving(state, send);
                freedom::show(&column, save, state.view.is_wide, send)
            }
            None => whole::show(state, send),
        },
    }
}

/// The questions about that.
fn questions(state: &State, about: ask::About) -> Vec<ask::Group> {
    let mut groups = ask::offers(state);
    groups.retain(|group| group.about == about);
    groups
}

/// While the world changes nothing of the scene itself is edited.
fn while_changing(state: &Shown, facts: &changing::Facts, send: &Callback<Action>) -> Html {
    let all = || change::show(facts, state.settings.methods, send);
    match state.view.selection {
        Selection::Agent(index) => match inspect::agent(state, index) {
            Some(about) => html! {
                <>
                    { agent::show(state, &about, send) }
                    { change::agent(state, index, &facts.breakdowns, send) }
                    { change::meets(facts) }
                </>
            },
            None => all(),
        },
        Selection::Cell(cell) => match inspect::cell(state, cell) {
            Some(about) => cell::show(state, &about, send),
            None => all(),
        },
        Selection::Nothing => all(),
    }
}

/// Brings the list of rules into view, once it is there.
pub(crate) fn show_rules() {
    show_part("rules");
}

/// Brings a part of the inspector into view, once it is there.
fn show_part(id: &'static str) {
    gloo::timers::callback::Timeout::new(0, move || {
        if let Some(part) = gloo::utils::document().get_element_by_id(id) {
            part.scroll_into_view();
        }
    })
    .forget();
}

/// The way back to the plan as a whole.
fn back(send: &Callback<Action>) -> Html {
    html! {
        <button type="button" class="crumb" onclick={send.reform(|_| Action::Board(BoardAction::Select(Selection::Nothing)))}>
            { icon::show("back") }{ tr!("Whole plan") }
        </button>
    }
}

/// The index in the draft of an agent of the answer, which may be of an older
/// draft: agents are the same if their names are.
fn in_draft(state: &State, name: &str) -> Option<usize> {
    let mut agents = state.world().agents().iter();
    agents.position(|agent| agent.name == name)
}
