//! The verdict of an answer, and the costs of two plans side by side.

use giveway_model::tr;
use giveway_page::ask::{CostRow, CouldRow, Held, Piece, VerdictPart, WhoPays};
use giveway_page::{Action, AskAction, Lit};
use yew::prelude::*;

use super::coming::rows;
use crate::{glyph, icon};

/// The title, the verdict in a word with how far it is proved, and the sentence.
pub(super) fn verdict_card(verdict: &VerdictPart, send: &Callback<Action>) -> Html {
    let VerdictPart {
        badge,
        title,
        claim,
        sentence,
        pieces,
    } = verdict;
    let is_titled = title != badge.word && !badge.word.is_empty();
    html! {
        <div class={classes!("verdict", badge.class)}>
            <div class="vb">
                { icon::show(badge.icon) }<h3>{ title.clone() }</h3>
                if is_titled || claim.is_some() {
                    <span class="vh">{ ". " }</span>
                    <em>
                        if is_titled { <span>{ badge.word }</span> }
                        if is_titled && claim.is_some() { { ", " } }
                        { claim.clone() }
                    </em>
                    <span class="vh">{ ". " }</span>
                }
            </div>
            <p class="vs">
                if pieces.is_empty() { { sentence.clone() } }
                { for pieces.iter().map(|it| piece(it, send)) }
            </p>
        </div>
    }
}

/// A piece of a sentence: a robot lights up, a cell is gone to.
pub(super) fn piece(piece: &Piece, send: &Callback<Action>) -> Html {
    match piece {
        Piece::Text(text) => html! { <>{ text.clone() }</> },
        Piece::Robot(agent, name) => {
            let lit = Some(Lit::Robot(*agent));
            html! {
                <button type="button" class="named" title={tr!("Show {name} on the board", name)}
                    onclick={send.reform(move |_| Action::Ask(AskAction::Light(lit)))}>
                    { glyph::show(*agent, "cost-glyph") }{ name.clone() }
                </button>
            }
        }
        Piece::Cell(cell) => {
            let at = *cell;
            html! {
                <button type="button" class="named" title={tr!("Show {cell} on the board", cell)}
                    onclick={send.reform(move |_| Action::Ask(AskAction::GoTo(at)))}>{ cell.to_string() }</button>
            }
        }
    }
}

/// What could be done instead: pressing a row makes it the other plan.
pub(super) fn it_could(could: &[CouldRow], held: Html, send: &Callback<Action>) -> Html {
    let row = |row: &CouldRow| {
        let chosen = row.index.filter(|_| !row.is_chosen);
        html! {
            <li><button type="button" class={classes!("could", row.is_chosen.then_some("on"))} aria-pressed={row.is_chosen.to_string()}
                onclick={send.reform(move |_| Action::Ask(AskAction::Choose(chosen)))}>
                { icon::show(row.icon) }
                <span>{ row.text.clone() }<small>{ row.detail.clone() }</small></span>
                <em class={classes!(row.is_costlier.then_some("worse"))}>{ row.difference.clone() }</em>
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ tr!("It could") }</h3>
            <ul class="repairs">{ for could.iter().map(row) }{ held }</ul>
        </section>
    }
}

/// The costs of both plans, then a row for each robot that differs: pressing one lights it.
pub(super) fn who_pays(pays: &WhoPays, held: Held, send: &Callback<Action>) -> Html {
    let cost = |row: &CostRow| {
        html! {
            <tr class="sum">
                <th scope="row">{ row.title.clone() }</th>
                <td>{ row.this }</td><td>{ row.other }</td>{ difference(row) }
            </tr>
        }
    };
    let robot = |row: &CostRow| {
        let is_lit = row.agent.is_some() && pays.lit == row.agent;
        let lit = row.agent.filter(|_| !is_lit).map(Lit::Robot);
        let onclick = send.reform(move |_| Action::Ask(AskAction::Light(lit)));
        html! {
            <tr class={classes!("robot", is_lit.then_some("on"))}>
                <th scope="row"><button type="button" aria-pressed={is_lit.to_string()} aria-label={row.aloud()} {onclick}>
                    if let Some(agent) = row.agent { { glyph::show(agent, "cost-glyph") } }
                    { row.title.clone() }
                </button></th>
                <td>{ row.this }</td><td>{ row.other }</td>{ difference(row) }
            </tr>
        }
    };
    html! {
        <section>
            <h3>{ tr!("Who pays") }if let Some(summary) = &pays.summary { { " " }<small>{ summary.clone() }</small> }</h3>
            <table class="compare pays" aria-label={tr!("Who pays")}>
                { head([tr!("This"), tr!("Other")]) }
                <tbody>{ for pays.costs.iter().map(cost) }{ for pays.robots.iter().map(robot) }{ rows(held) }</tbody>
            </table>
            if pays.hidden > 0 {
                <button type="button" class="link unfold" onclick={send.reform(|_| Action::Ask(AskAction::Unfold))}>
                    { tr!("Show {n} more" | "Show {n} more" % pays.hidden) }
                </button>
            }
            if let Some(rest) = &pays.rest { <p class="remark">{ rest.clone() }</p> }
        </section>
    }
}

/// The table before anybody is known to pay.
pub(super) fn nobody_yet(held: Held) -> Html {
    html! {
        <section aria-hidden="true">
            <h3>{ tr!("Who pays") }</h3>
            <table class="compare pays">{ head([tr!("This"), tr!("Other")]) }<tbody>{ rows(held) }</tbody></table>
        </section>
    }
}

/// Costs of two plans side by side, under a heading each.
pub(super) fn costs(
    rows: &[CostRow],
    name: &'static str,
    [this, other]: [&'static str; 2],
) -> Html {
    let row = |row: &CostRow| {
        html! {
            <tr>
                <th scope="row">
                    if let Some(agent) = row.agent { { glyph::show(agent, "cost-glyph") } }
                    { row.title.clone() }
                </th>
                <td>{ row.this }</td><td>{ row.other }</td>{ difference(row) }
            </tr>
        }
    };
    html! {
        <table class="compare" aria-label={name}>
            { head([this, other]) }
            <tbody>{ for rows.iter().map(row) }</tbody>
        </table>
    }
}

/// The headings of a table of two plans.
fn head([this, other]: [&'static str; 2]) -> Html {
    html! {
        <thead><tr>
            <th scope="col"><span class="vh">{ tr!("Cost") }</span></th>
            <th scope="col">{ this }</th><th scope="col">{ other }</th>
            <th scope="col"><span class="vh">{ tr!("Difference") }</span></th>
        </tr></thead>
    }
}

/// The difference of a cost: amber where it grows, green where it falls.
fn difference(row: &CostRow) -> Html {
    let class = match row.other.cmp(&row.this) {
        std::cmp::Ordering::Less => "d better",
        std::cmp::Ordering::Equal => "d same",
        std::cmp::Ordering::Greater => "d worse",
    };
    html! { <td {class}>{ row.difference() }</td> }
}
