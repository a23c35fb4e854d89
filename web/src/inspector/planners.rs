//! Planners side by side: a row for each that planned the scene on the board.

use giveway_model::tr;
use giveway_page::planners::{Place, Proved, Row, table};
use giveway_page::{Action, SolveAction, State};
use yew::prelude::*;

use crate::icon;

/// The table; nothing where no planner planned this scene.
#[inline(never)]
pub(super) fn show(state: &State, send: &Callback<Action>) -> Html {
    let Some(table) = table(state) else {
        return Html::default();
    };
    let row = |row: &Row| show_row(row, state.view.is_wide, send);
    html! {
        <section>
            <h3>{ tr!("Planners") }</h3>
            <table class="costs planners" aria-label={tr!("Planners")}>
                <thead><tr>
                    { for [tr!("Planner"), tr!("Costs"), tr!("At least"), tr!("Time"), tr!("Steps")].map(|name| html! { <th scope="col">{ name }</th> }) }
                </tr></thead>
                <tbody>{ for table.rows.iter().map(row) }</tbody>
            </table>
            <p class="remark">{ table.remark }</p>
        </section>
    }
}

fn show_row(row: &Row, is_wide: bool, send: &Callback<Action>) -> Html {
    let by = row.by;
    let plan = match &row.plan {
        Ok(plan) => plan,
        Err(why) => {
            return html! {
                <tr><th scope="row">{ row.title }</th><td class="why" colspan="4">{ why.clone() }</td></tr>
            };
        }
    };
    let press = send.reform(move |_: MouseEvent| Action::Solve(SolveAction::ShowPlan(by)));
    let beside = send.reform(move |_: MouseEvent| Action::Solve(SolveAction::ShowBeside(by)));
    let is_shown = plan.place == Place::Board;
    let is_beside = plan.place == Place::Beside;
    html! {
        <tr class={classes!(is_shown.then_some("on"))}>
            <th scope="row">
                <button type="button" aria-pressed={is_shown.to_string()} onclick={press}>{ row.title }</button>
                if is_wide && !is_shown {
                    <button type="button" title={tr!("Show beside")} aria-pressed={is_beside.to_string()} onclick={beside}>
                        { icon::show("compare") }<span class="vh">{ tr!("Show {title} beside", title = row.title) }</span>
                    </button>
                }
            </th>
            <td>{ plan.costs.clone() }</td>
            <td>{ bound(plan.proved) }</td>
            <td>{ row.time.clone() }</td>
            <td title={row.what}>{ row.steps.clone() }<span class="vh">{ format!(" {}", row.what) }</span></td>
        </tr>
    }
}

/// The bound of the first cost, or that the plan is best in all of them.
fn bound(proved: Proved) -> Html {
    match proved {
        Proved::Nothing => html! { "\u{2013}" },
        Proved::AtLeast(bound) => html! { bound },
        Proved::Least(bound) => html! {
            <><span class="seal">{ icon::show("proved") }<span class="vh">{ tr!("proved least:") }{ " " }</span></span>{ bound }</>
        },
        Proved::Best => html! { <b class="seal">{ tr!("proved best") }</b> },
    }
}
