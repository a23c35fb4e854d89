//! The options of a tool that paints, in the place of the legend: its shape, and the measures of
//! that.

use giveway_model::tr;
use giveway_page::draw::{Field, LONGEST, Row, Shape, row};
use giveway_page::{Action, BoardAction, State, number};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::icon;

/// The row; `None` where the tool has no options.
pub(super) fn options(state: &State, send: &Callback<Action>) -> Option<Html> {
    let row = row(state)?;
    let shape = |&shape: &Shape| shape_button(shape, &row, send);
    let field = |field: &Field| measure(field, state.view.drawing.measure(field.measure), send);
    Some(html! {
        <div class="toolopts" role="group" aria-label={tr!("Shape")}>
            <div class="seg">{ for row.shapes.iter().map(shape) }</div>
            <p>{ for row.fields.iter().map(field) }if let Some(remark) = row.remark { <span>{ remark }</span> }</p>
            <output role="status">{ row.drawn.clone() }</output>
        </div>
    })
}

fn shape_button(shape: Shape, row: &Row, send: &Callback<Action>) -> Html {
    let onclick = send.reform(move |_| Action::Board(BoardAction::PickShape(shape)));
    let key = shape.key().to_string();
    html! {
        <button type="button" aria-pressed={(shape == row.shape).to_string()} aria-label={shape.name()}
            aria-keyshortcuts={key.clone()} title={format!("{} ({key})", shape.name())} {onclick}>
            { icon::show(shape.icon()) }<span>{ shape.name() }</span>
        </button>
    }
}

/// A number in the middle of its words; what is not possible is taken back.
fn measure(field: &Field, value: u32, send: &Callback<Action>) -> Html {
    let measure = field.measure;
    let send = send.clone();
    let onchange = Callback::from(move |event: Event| {
        let input: HtmlInputElement = event.target_unchecked_into();
        match number::read(&input.value(), (1, LONGEST)) {
            Some(cells) => send.emit(Action::Board(BoardAction::SetMeasure(measure, cells))),
            None => input.set_value(&value.to_string()),
        }
    });
    html! {
        <>
            { field.before }
            <input class="num1" type="text" inputmode="numeric" autocomplete="off" aria-label={field.name}
                title={number::possible((1, LONGEST))} value={value.to_string()} {onchange} />
            { field.after }
        </>
    }
}
