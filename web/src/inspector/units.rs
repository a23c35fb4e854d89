//! The units of a scene: how wide a cell is, and how long a step takes.

use giveway_model::{Measure, Units, tr};
use giveway_page::{Action, Edit, State, number};
use yew::prelude::*;

use crate::field::{Field, FieldProps};
use crate::part::part;

/// Whether the scene has units, and the two fields for them.
pub(super) fn units(state: &State, send: &Callback<Action>) -> Html {
    let units = state.document.draft.scene().units;
    let kind = |name: &'static str, has: bool| {
        let is_on = units.is_some() == has;
        let one = Measure::from_thousandths(1000).filter(|_| has);
        let new = one.map(|one| Units {
            cell: one,
            step: one,
        });
        let send = send.clone();
        let press = Callback::from(move |_: MouseEvent| {
            if !is_on {
                send.emit(Action::Edit(Edit::Units(new)));
            }
        });
        html! { <button type="button" aria-pressed={is_on.to_string()} onclick={press}>{ name }</button> }
    };
    let field = |label: &'static str, value: Measure, with: fn(Units, Measure) -> Units| {
        let send = send.clone();
        let on_change = Callback::from(move |typed: String| {
            if let (Some(units), Some(new)) = (units, number::measure(&typed)) {
                send.emit(Action::Edit(Edit::Units(Some(with(units, new)))));
            }
        });
        html! { { part::<Field>(FieldProps { label: label.into(), value: value.to_string().into(), on_change, empty: None, range: None, is_measure: true }) } }
    };
    html! {
        <>
            <div class="seg full wraps" role="group" aria-label={tr!("Units")}>
                { kind(tr!("Cells and steps"), false) }
                { kind(tr!("Metres and seconds"), true) }
            </div>
            if let Some(now) = units {
                <div class="fields">
                    { field(tr!("Metres a cell"), now.cell, |units, cell| Units { cell, ..units }) }
                    { field(tr!("Seconds a step"), now.step, |units, step| Units { step, ..units }) }
                </div>
            }
        </>
    }
}
