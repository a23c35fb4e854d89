//! What sets of robots alone need, as a table: the robots in it can be pressed.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::ask::{Tight, TightRow};
use yew::prelude::*;

use super::pays::piece;

/// The sets, the one that needs most first.
#[inline(never)]
pub(super) fn how_tight(tight: &Tight, send: &Callback<Action>) -> Html {
    let row = |row: &TightRow| {
        html! {
            <tr class={classes!(row.is_all.then_some("sum"))}>
                <th scope="row">{ for row.robots.iter().map(|it| piece(it, send)) }</th>
                <td>{ row.need }</td><td class="d">{ row.beside.clone() }</td>
            </tr>
        }
    };
    html! {
        <section>
            <h3>{ tr!("How tight") }</h3>
            <table class="compare tight" aria-label={tr!("How tight")}>
                <thead><tr>
                    <th scope="col">{ tr!("These alone, all others gone") }</th>
                    <th scope="col">{ tight.counted.clone() }</th>
                    <th scope="col"><span class="vh">{ tr!("Beside the plan") }</span></th>
                </tr></thead>
                <tbody>{ for tight.rows.iter().map(row) }</tbody>
            </table>
        </section>
    }
}
