//! The proof: its chart, and its steps as a list.

use std::ops::Range;
use std::rc::Rc;

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::inside::{InsideAction, Kind, ProofRow, chart, rows};
use giveway_picture::whole;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, HtmlElement, ResizeObserver};
use yew::prelude::*;

use super::chart::ChartSlider;
use super::waiting;
use crate::held::{Held, use_held};
use crate::icon;
use crate::part::part;
use crate::timeline::DockProps;
use crate::timeline::inside::chart::ChartProps;

/// The height of a row, in pixels: where there is room for a line, and where there is
/// not. As in the style sheet.
const ROW: (f64, f64) = (30.0, 52.0);
/// The list is narrow up to this width, in pixels.
const NARROW: f64 = 420.0;
/// Rows drawn beyond those that are seen, on each side.
const MORE: usize = 6;

/// What is seen: the room of the chart, and of the list with what it was scrolled by.
#[derive(Clone, Copy, Default, PartialEq)]
struct Sight {
    chart: (f64, f64),
    list: (f64, f64),
    top: f64,
}

impl Sight {
    fn row(&self) -> f64 {
        if self.list.0 <= NARROW { ROW.1 } else { ROW.0 }
    }

    fn rows(&self) -> Range<usize> {
        let first = whole(self.top / self.row()) as usize;
        let last = whole((self.top + self.list.1) / self.row()) as usize + 1;
        first.saturating_sub(MORE)..last + MORE
    }
}

/// Chart and list.
#[component]
pub(super) fn Proof(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let (place, list) = (use_node_ref(), use_node_ref());
    let sight = use_state_eq(Sight::default);
    let look = {
        let (place, list, setter) = (place.clone(), list.clone(), sight.setter());
        use_memo((), move |()| {
            let look: Rc<dyn Fn()> = Rc::new(move || {
                let size = |at: &NodeRef| {
                    let at = at.cast::<Element>();
                    at.map_or((0.0, 0.0), |at| {
                        (f64::from(at.client_width()), f64::from(at.client_height()))
                    })
                };
                let top = list.cast::<Element>().map_or(0, |list| list.scroll_top());
                setter.set(Sight {
                    chart: size(&place),
                    list: size(&list),
                    top: f64::from(top),
                });
            });
            look
        })
    };
    let look: Rc<dyn Fn()> = (*look).clone();
    let (shown, count) = rows(state, &sight.rows());
    {
        let (look, places) = (Rc::clone(&look), [place.clone(), list.clone()]);
        use_effect_with(count == 0, move |_| {
            look();
            let resized = Closure::<dyn FnMut()>::new(move || look());
            let observer = ResizeObserver::new(resized.as_ref().unchecked_ref()).ok();
            if let Some(observer) = &observer {
                for place in places.iter().filter_map(NodeRef::cast::<Element>) {
                    observer.observe(&place);
                }
            }
            move || {
                if let Some(observer) = observer {
                    observer.disconnect();
                }
                drop(resized);
            }
        });
    }
    let drawn = chart(state, sight.chart).filter(|_| sight.chart.0 > 0.0);
    let chosen = drawn.as_ref().map(|chart| chart.head.1);
    let focus = use_held(|| false);
    {
        let (list, row) = (list.clone(), sight.row());
        // Whoever scrolled away from the end is left there while more steps come.
        let follows = use_held(|| (None::<usize>, 0_usize));
        use_effect_with((chosen, count, row.to_bits()), move |_| {
            let (before, rows) = follows.get();
            follows.set((chosen, count));
            let Some((at, list)) = chosen.zip(list.cast::<Element>()) else {
                return;
            };
            let (top, high) = (
                f64::from(list.scroll_top()),
                f64::from(list.client_height()),
            );
            let is_at_end = top + high + row * 2.0 >= rows as f64 * row;
            if before == Some(at) || (count != rows && !is_at_end && before.is_some()) {
                return;
            }
            let y = at as f64 * row;
            if y < top || y + row > top + high {
                list.set_scroll_top((y + row - high).max(y.min(top)).ceil() as i32);
            }
        });
    }
    {
        let (list, focus) = (list.clone(), Rc::clone(&focus));
        use_effect(move || {
            if focus.take()
                && let Some(list) = list.cast::<Element>()
                && let Ok(Some(button)) = list.query_selector("[aria-current]")
                && let Ok(button) = button.dyn_into::<HtmlElement>()
            {
                let _ = button.focus();
            }
        });
    }
    if count == 0 {
        return waiting(state, send);
    }
    let row = sight.row();
    let above = shown.first().map_or(0, |first| first.number);
    let below = count.saturating_sub(above + shown.len());
    let spacer = |rows: usize| {
        (rows > 0).then(|| {
            let height = (rows as f64 * row).to_string();
            html! { <li aria-hidden="true"><svg class="spacer" width="1" {height} /></li> }
        })
    };
    let onscroll = {
        let look = Rc::clone(&look);
        move |_: Event| look()
    };
    let narrow = (row > ROW.0).then_some("tall");
    html! {
        <div class={classes!("proof", "lanes")} id="lanes">
            <div class="chart-at" ref={place}>
                if let Some(drawn) = drawn { { part::<ChartSlider>(ChartProps { chart: drawn, count, send: send.clone() }) } }
            </div>
            <ol class={classes!("plist", narrow)} aria-label={tr!("Steps")} ref={list} {onscroll} onkeydown={keys(&focus, send)}>
                { spacer(above) }
                { for shown.iter().map(|row| show_row(row, count, send)) }
                { spacer(below) }
            </ol>
        </div>
    }
}

/// Arrow keys go from step to step.
fn keys(focus: &Rc<Held<bool>>, send: &Callback<Action>) -> Callback<KeyboardEvent> {
    let (focus, send) = (Rc::clone(focus), send.clone());
    Callback::from(move |event: KeyboardEvent| {
        let action = match event.key().as_str() {
            "ArrowDown" => InsideAction::Next,
            "ArrowUp" => InsideAction::Back,
            _ => return,
        };
        event.prevent_default();
        event.stop_propagation();
        focus.set(true);
        send.emit(Action::Inside(action));
    })
}

fn show_row(row: &ProofRow, count: usize, send: &Callback<Action>) -> Html {
    let number = row.number;
    let class = match row.kind {
        Kind::Bound => "",
        Kind::Plan => "found",
        Kind::Aside => "aside",
        Kind::Head => "head-row",
        Kind::End | Kind::Stopped => "fin",
    };
    html! {
        <li key={number} aria-posinset={(number + 1).to_string()} aria-setsize={count.to_string()}>
            <button type="button" {class} aria-current={row.is_chosen.then_some("step")} title={row.text.clone()}
                onclick={send.reform(move |_| Action::Inside(InsideAction::Step(number)))}>
                <span class="k">
                    { match row.kind {
                        Kind::End => icon::show("proved"),
                        Kind::Stopped => icon::show("clock"),
                        _ => html! { number },
                    } }
                </span>
                <span class="said">{ row.text.clone() }</span>
                if let Some((words, figure)) = &row.figure {
                    <em>{ *words }{ " " }<b>{ figure.clone() }</b></em>
                }
            </button>
        </li>
    }
}
