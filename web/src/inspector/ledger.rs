//! Who costs whom: the ledger of delays of the plan on the board.

use giveway_model::tr;
use giveway_page::ledger::{
    Because, CauseRow, Column, LedgerAction, LedgerLit, LossRow, PlaceRow, TITLE, is_offered,
};
use giveway_page::{Action, AskAction, State};
use yew::prelude::*;

use super::pays::verdict_card;
use crate::{glyph, icon};

fn act(action: LedgerAction, send: &Callback<Action>) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Ledger(action))
}

/// The question among those about the plan.
#[inline(never)]
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    if !is_offered(state) {
        return Html::default();
    }
    html! {
        <ul class="asks">
            <li><button type="button" class="ask" onclick={act(LedgerAction::Show(true), send)}>
                { icon::show("question") }
                <span>{ TITLE.text() }<small>{ tr!("steps lost, and because of whom") }</small></span>
                { icon::at_end("chevron") }
            </button></li>
        </ul>
    }
}

/// What scrolls of it.
#[inline(never)]
pub(super) fn show(column: &Column, send: &Callback<Action>) -> Html {
    let turn = |is_turned: bool, title: &'static str| {
        html! {
            <button type="button" aria-pressed={(column.is_turned == is_turned).to_string()}
                onclick={act(LedgerAction::Turn(is_turned), send)}>{ title }</button>
        }
    };
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={act(LedgerAction::Show(false), send)}>
                    { icon::show("back") }{ tr!("Whole plan") }
                </button>
                <h2>{ TITLE.text() }</h2>
                <p class="lead">{ column.lead }</p>
            </header>
            <div class="verdict-at" aria-live="polite">
                if let Some(verdict) = &column.verdict { { verdict_card(verdict, send) } }
            </div>
            if !column.losses.is_empty() {
                <section>
                    <div class="seg full" role="group" aria-label={TITLE.text()}>
                        { turn(false, tr!("Who loses")) }
                        { turn(true, tr!("Who costs others")) }
                    </div>
                    if column.is_turned { { causes(column) } } else { { losses(column, send) } }
                    <p class="remark">{ tr!("“Because of” names the robots and rules on the way that a robot would take if it were alone. They share its delay evenly. It may wait for other robots.") }</p>
                </section>
                <section>
                    <h3>{ tr!("Where most is lost") }</h3>
                    <ul class="places">{ for column.places.iter().map(|row| place(row, send)) }</ul>
                </section>
            }
            if let Some(line) = column.pending { <ul class="pending"><li>{ line }</li></ul> }
        </>
    }
}

/// What stays at the foot of it: the question about the largest loss.
#[inline(never)]
pub(super) fn foot(column: &Column, send: &Callback<Action>) -> Html {
    html! {
        <footer class="foot">
            if let Some(offer) = &column.ask {
                <button type="button" class="btn primary" onclick={
                    let question = offer.question.clone();
                    send.reform(move |_| Action::Ask(AskAction::Ask(question.clone())))
                }>{ icon::show(offer.icon) }{ offer.text.clone() }</button>
            }
            <button type="button" class="btn outline" onclick={act(LedgerAction::Show(false), send)}>{ tr!("Done") }</button>
        </footer>
    }
}

fn named(because: &Because) -> Html {
    html! {
        <span class="whom">
            if let Some(agent) = because.agent { { glyph::show(agent, "cost-glyph") } }
            <bdi>{ because.text.clone() }</bdi>
        </span>
    }
}

/// Who loses how much because of whom. Pressing a robot leaves its cells alone on the map.
fn losses(column: &Column, send: &Callback<Action>) -> Html {
    let row = |row: &LossRow| {
        let lit = row.agent.filter(|_| !row.is_lit).map(LedgerLit::Robot);
        html! {
            <tr class={classes!("robot", row.is_lit.then_some("on"))}>
                <th scope="row"><button type="button" aria-pressed={row.is_lit.to_string()} aria-label={row.aloud.clone()}
                    onclick={act(LedgerAction::Light(lit), send)}>
                    if let Some(agent) = row.agent { { glyph::show(agent, "cost-glyph") } }
                    <bdi>{ row.name.clone() }</bdi>
                </button></th>
                <td>{ row.steps }</td>
                <td class="because">
                    { for row.because.iter().map(named) }
                    if let Some(each) = &row.each { { " " }<em>{ each.clone() }</em> }
                </td>
            </tr>
        }
    };
    html! {
        <table class="compare ledger" aria-label={tr!("Who loses")}>
            { head([tr!("Robot"), tr!("a robot" => "loses"), tr!("steps are lost" => "because of")]) }
            <tbody>
                { for column.losses.iter().map(row) }
                { nobody(column) }
                { all(column) }
            </tbody>
        </table>
    }
}

/// The steps that are lost with nobody in the way, where there are some.
fn nobody(column: &Column) -> Html {
    if column.nobody == "0" {
        return Html::default();
    }
    html! {
        <tr class="quiet"><th scope="row">{ tr!("Nobody") }</th><td>{ column.nobody.clone() }</td><td class="because">{ tr!("steps" => "could be saved") }</td></tr>
    }
}

/// Who costs others how much.
fn causes(column: &Column) -> Html {
    let row = |row: &CauseRow| {
        html! {
            <tr>
                <th scope="row">{ named(&row.cause) }</th>
                <td>{ row.steps.clone() }</td>
                <td class="because">{ for row.losers.iter().map(named) }</td>
            </tr>
        }
    };
    html! {
        <table class="compare ledger" aria-label={tr!("Who costs others")}>
            { head([tr!("Robot"), tr!("a robot" => "costs"), tr!("costs steps" => "whom")]) }
            <tbody>
                { for column.causes.iter().map(row) }
                { nobody(column) }
                { all(column) }
            </tbody>
        </table>
    }
}

fn head([who, steps, because]: [&'static str; 3]) -> Html {
    html! {
        <thead><tr>
            <th scope="col"><span class="vh">{ who }</span></th><th scope="col">{ steps }</th><th scope="col" class="because">{ because }</th>
        </tr></thead>
    }
}

fn all(column: &Column) -> Html {
    html! {
        <tr class="sum"><th scope="row">{ tr!("steps lost" => "All") }</th><td>{ column.all }</td><td class="because">{ if column.is_turned { column.harmless.clone() } else { column.unharmed.clone() } }</td></tr>
    }
}

fn place(row: &PlaceRow, send: &Callback<Action>) -> Html {
    let lit = (!row.is_lit).then_some(LedgerLit::Place(row.number - 1));
    html! {
        <li><button type="button" class={classes!("place", row.is_lit.then_some("on"))} aria-pressed={row.is_lit.to_string()}
            onclick={act(LedgerAction::Light(lit), send)}>
            <span class="no">{ row.number }</span>
            <span>{ row.text.clone() }<small>{ row.who.clone() }</small></span>
            <b>{ row.steps }</b>
        </button></li>
    }
}
