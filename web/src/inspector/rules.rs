//! The rules: those of the problem as sentences, those of the scene with price and switch.

use giveway_model::tr;
use giveway_page::rules::{
    Lit, LooserPart, LooserRow, Piece, ProblemRule, Row, RuleAction, Tag, list,
};
use giveway_page::{Action, Selection, State};
use yew::prelude::*;

use super::prices::{ask, costs_of};
use crate::icon;
use crate::keys::is_in;
use crate::turning::turning;

/// The section; nothing while something else is done with the scene.
pub(super) fn show(state: &State, send: &Callback<Action>) -> Html {
    let Some(list) = list(state) else {
        return Html::default();
    };
    let of_problem = |rule: &ProblemRule| {
        let change = rule.change.clone().map(|edit| {
            let onclick = send.reform(move |_: MouseEvent| Action::Edit(edit.clone()));
            let label = tr!("{rule}: change", rule = rule.sentence);
            html! { <button type="button" class="link" aria-label={label} {onclick}>{ tr!("Change") }</button> }
        });
        html! { <li>{ icon::show(rule.icon) }<span>{ rule.sentence.clone() }</span>{ for change }</li> }
    };
    let begin = act(send, || RuleAction::Begin);
    let own = |zone: &(String, bool)| zone_button(&zone.0, zone.1, send);
    html! {
        <section class="rules" id="rules" aria-labelledby="rules-title">
            <div class="rules-head">
                <h3 id="rules-title">{ tr!("Rules") }</h3><small>{ list.count.clone() }</small>
                <button type="button" class="btn ghost round" title={tr!("Add a rule")} aria-label={tr!("Add a rule")} onclick={begin}>{ icon::show("plus") }</button>
            </div>
            <details class="of-problem" open={list.rows.is_empty()}>
                <summary>{ tr!("Of the problem") }</summary>
                <ul>{ for list.problem.iter().map(of_problem) }</ul>
            </details>
            if list.rows.is_empty() {
                <p class="remark">{ tr!("To limit a place, pick the tool Zone and mark its cells. To lead robots one way, pick One-way.") }</p>
            } else {
                <ul class="own-rules" aria-label={tr!("Of this scene")}>{ for list.rows.iter().map(|row| rule(row, send)) }</ul>
            }
            if !list.changed.is_empty() {
                <ul class="changed-rules" aria-label={tr!("Since the world changed")}>{ for list.changed.iter().map(|rule| html! { <li>{ icon::show("clock") }<span>{ rule.clone() }</span></li> }) }</ul>
            }
            if !list.zones.is_empty() {
                <p class="zones">{ tr!("Zones") }{ " " }{ for list.zones.iter().map(own) }</p>
            }
            if let Some(why) = &list.left_open { <p class="remark">{ why.clone() }</p> }
            if list.can_ask || list.asking.is_some() { { ask(list.asking, list.left_open.is_some(), list.longer, send) } }
            if let Some(summary) = &list.summary { <p class="remark" aria-hidden="true">{ summary.clone() }</p> }
            <p class="vh" role="status">{ list.told.clone() }</p>
        </section>
    }
}

/// The button that begins a rule about the robot or the cell that is selected.
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    let words = match state.view.selection {
        Selection::Agent(_) => tr!("A rule about this robot"),
        Selection::Cell(_) => tr!("A rule about this cell"),
        Selection::Nothing => return Html::default(),
    };
    if list(state).is_none() {
        return Html::default();
    }
    html! {
        <button type="button" class="btn outline more" onclick={act(send, || RuleAction::Begin)}>{ icon::show("plus") }{ words }</button>
    }
}

/// A callback that sends what is done to rules.
pub(super) fn act(
    send: &Callback<Action>,
    action: impl Fn() -> RuleAction + 'static,
) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Rules(action()))
}

/// A zone by its name, with an outline as on the board; pressing it opens it.
pub(super) fn zone_button(name: &str, is_lit: bool, send: &Callback<Action>) -> Html {
    let zone = name.to_owned();
    let over = {
        let (send, zone) = (send.clone(), zone.clone());
        move |is_over| send.emit(Action::Rules(RuleAction::OverZone(zone.clone(), is_over)))
    };
    let [(entered, left), (focused, blurred)] =
        [over.clone(), over].map(|over| (over.clone(), over));
    html! {
        <button type="button" class={classes!("zone-name", is_lit.then_some("on"))} aria-label={tr!("Zone {name}", name)}
            onmouseenter={move |_| entered(true)} onmouseleave={move |_| left(false)}
            onfocus={move |_| focused(true)} onblur={move |_| blurred(false)}
            onclick={act(send, move || RuleAction::OfZone(zone.clone()))}>{ name.to_owned() }</button>
    }
}

fn rule(row: &Row, send: &Callback<Action>) -> Html {
    let index = row.index;
    let light =
        move |is_lit: bool| Action::Rules(RuleAction::Light(is_lit.then_some(Lit::Rule(index))));
    let piece = |piece: &Piece| match piece {
        Piece::Text(text) => html! { { text.clone() } },
        Piece::Slot(_, zone) => zone_button(zone, row.is_lit, send),
    };
    let switch = tr!("{rule}: in force", rule = row.sentence);
    // With the mouse the whole sentence opens it, but for the zone in it, which opens itself.
    let opens = {
        let open = act(send, move || RuleAction::Open(index));
        Callback::from(move |event: MouseEvent| {
            if !is_in(&event, "button") {
                open.emit(event);
            }
        })
    };
    let class = classes!(
        "rule",
        row.broken.as_ref().map(|_| "broken"),
        row.is_lit.then_some("lit"),
        (!row.is_on).then_some("off")
    );
    html! {
        <li key={index}><div {class} role="group" aria-label={row.label()}
            onmouseenter={send.reform(move |_| light(true))} onfocusin={send.reform(move |_| light(true))}
            onmouseleave={send.reform(move |_| light(false))}>
            <button type="button" class="rule-icon" aria-expanded={row.is_open.to_string()} aria-label={tr!("{rule}: show and open", rule = row.sentence)}
                onclick={act(send, move || RuleAction::Open(index))}>{ icon::show(row.icon) }</button>
            <p class="rule-text" onclick={opens.clone()}>{ for row.pieces.iter().map(piece) }
                if let Some(name) = &row.name { <small>{ name.clone() }</small> }
            </p>
            <label class="switch" title={tr!("In force")}>
                <input type="checkbox" role="switch" aria-label={switch} checked={row.is_on}
                    onchange={send.reform(move |_: Event| Action::Rules(RuleAction::Switch(index)))} /><i></i>
            </label>
            <p class="rule-price">
                { for row.price.as_ref().map(|price| tag(price, opens.clone())) }
                if let Some(broken) = &row.broken {
                    <span class="rule-tag broken">{ icon::show("collision") }{ broken.clone() }</span>
                }
            </p>
            if row.is_open { { open(row, send) } }
        </div></li>
    }
}

/// The price; with the mouse it opens the row, as its sentence does.
fn tag(price: &Tag, onclick: Callback<MouseEvent>) -> Html {
    let icon = match price.class {
        "busy" => Some("clock"),
        "some" => Some("search"),
        _ => price.is_proved.then_some("proved"),
    };
    html! {
        <span class={classes!("rule-tag", price.class)} {onclick}>
            if let Some(icon) = icon { { icon::show(icon) } }{ price.text.clone() }
        </span>
    }
}

/// What an open row tells, and what can be done to its rule.
fn open(row: &Row, send: &Callback<Action>) -> Html {
    let index = row.index;
    let costs = row.price.as_ref().filter(|price| !price.costs.is_empty());
    html! {
        <div class="rule-more">
            { button("edit", tr!("Edit"), None, act(send, move || RuleAction::Edit(index))) }
            { loosen(row, send) }
            if !row.is_on { { button("question", tr!("What would it cost?"), None, act(send, move || RuleAction::AskAbout(index))) } }
            { button("erase", tr!("Remove"), None, act(send, move || RuleAction::Remove(index))) }
            // What comes with its price comes last: nothing else moves under the finger that asked for it.
            if row.price.as_ref().is_some_and(|price| price.has_plan) {
                { button("compare", tr!("Show the plan without it"), Some(row.is_beside), {
                    let beside = row.is_beside;
                    act(send, move || RuleAction::Without((!beside).then_some(index)))
                }) }
            }
            { for costs.map(|price| costs_of(&price.costs)) }
        </div>
    }
}

fn button(
    icon: &'static str,
    words: impl Into<AttrValue>,
    is_on: Option<bool>,
    onclick: Callback<MouseEvent>,
) -> Html {
    let pressed = is_on.map(|is_on| is_on.to_string());
    html! { <button type="button" class="btn outline" aria-pressed={pressed} {onclick}>{ icon::show(icon) }{ words.into() }</button> }
}

/// A button whose word changes when a search ends.
fn changing(icon: &'static str, word: &'static str, onclick: Callback<MouseEvent>) -> Html {
    let content = html! { <>{ icon::show(icon) }{ word }</> };
    turning("outline", word, content, onclick)
}

/// The button that looks for the least that helps, and what came of it.
fn loosen(row: &Row, send: &Callback<Action>) -> Html {
    let index = row.index;
    let is_looking = row.looser.as_ref().is_some_and(|part| part.is_looking);
    let press = act(send, move || RuleAction::Loosen(index));
    let found = |part: &LooserPart| {
        let one = |(place, looser): (usize, &LooserRow)| {
            html! {
                <li><button type="button" class="repair" title={tr!("Put this rule in its place")} onclick={act(send, move || RuleAction::TakeLooser(place))}>
                    { icon::show("loosen") }
                    <span>{ looser.sentence.clone() }<small>{ looser.costs.clone() }
                        if let Some(open) = looser.open { { " " }{ open } }
                        if looser.is_proved { { icon::show("proved") } }
                    </small></span>
                    if let Some(saves) = &looser.saves { <em class="better">{ saves.clone() }</em> }
                </button></li>
            }
        };
        html! {
            <div class="looser" role="status">
                if part.is_looking && part.looser.is_empty() { <p>{ tr!("Looking for the least that helps …") }</p> }
                if !part.looser.is_empty() {
                    <p>{ tr!("The least that helps") }</p>
                    <ul class="repairs">{ for part.looser.iter().enumerate().map(one) }</ul>
                }
                if let Some(nothing) = part.nothing { <p>{ nothing }</p> }
            </div>
        }
    };
    html! {
        <>
            if is_looking {
                { changing("stop", tr!("Stop looking"), press) }
            } else if row.can_loosen {
                { changing("loosen", tr!("Loosen"), press) }
            }
            { for row.looser.as_ref().map(found) }
        </>
    }
}

/// The entry `Why not a plan in which ...?`, below the questions about a plan.
pub(super) fn question(state: &State, send: &Callback<Action>) -> Html {
    if list(state).is_none() || state.document.plan().is_none() {
        return Html::default();
    }
    html! {
        <ul class="asks"><li><button type="button" class="ask" onclick={act(send, || RuleAction::Question)}>
            { icon::show("question") }<span>{ tr!("Why not a plan in which …?") }</span>{ icon::at_end("chevron") }
        </button></li></ul>
    }
}
