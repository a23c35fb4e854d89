//! The tabs beside the transport: lanes or how they were found; and of which method.

use crate::part::part;
use giveway_model::tr;
use giveway_page::inside::{InsideAction, Method};
use giveway_page::{Action, State};
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;
use yew::prelude::*;

#[derive(Clone, PartialEq, Properties)]
struct SwitchProps {
    class: &'static str,
    label: &'static str,
    /// The names of the tabs.
    names: Vec<&'static str>,
    /// Which of them is chosen.
    chosen: usize,
    choose: Callback<usize>,
}

/// Tabs side by side: the arrow keys choose among them.
#[component]
fn Switch(props: &SwitchProps) -> Html {
    let SwitchProps {
        class,
        label,
        names,
        chosen,
        choose,
    } = props;
    let label = *label;
    let onkeydown = {
        let choose = choose.clone();
        let (at, count) = (*chosen, names.len());
        move |event: KeyboardEvent| {
            let to = match event.key().as_str() {
                "ArrowRight" => (at + 1) % count,
                "ArrowLeft" => (at + count - 1) % count,
                "Home" => 0,
                "End" => count - 1,
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            choose.emit(to);
            keep_focus(label);
        }
    };
    let choose = {
        let choose = choose.clone();
        Callback::from(move |index: usize| {
            choose.emit(index);
            keep_focus(label);
        })
    };
    let one = |(index, name): (usize, &&'static str)| {
        let is_chosen = index == *chosen;
        html! {
            <button type="button" role="tab" aria-selected={is_chosen.to_string()}
                tabindex={if is_chosen { "0" } else { "-1" }} onclick={choose.reform(move |_| index)}>{ *name }</button>
        }
    };
    html! {
        <div class={classes!("seg", *class)} role="tablist" aria-label={label} {onkeydown}>
            { for names.iter().enumerate().map(one) }
        </div>
    }
}

/// Leaves the focus on the chosen tab of these, though all around it is drawn anew.
fn keep_focus(label: &'static str) {
    let focus = move || {
        let tab = format!("[role=tablist][aria-label=\"{label}\"] [aria-selected=true]");
        let document = gloo::utils::document();
        if let Ok(Some(tab)) = document.query_selector(&tab)
            && let Ok(tab) = tab.dyn_into::<HtmlElement>()
        {
            let _ = tab.focus();
        }
    };
    Timeout::new(0, focus).forget();
}

/// The lanes, or how they were found.
pub(in crate::timeline) fn places(state: &State, send: &Callback<Action>) -> Html {
    if !state.can_look_inside() {
        return html! {};
    }
    let choose = send.reform(|index| Action::Inside(InsideAction::Show(index == 1)));
    html! {
        { part::<Switch>(SwitchProps { class: "dtabs", label: tr!("What stands below the board"), names: vec![tr!("Timeline"), tr!("How it was proved")], chosen: usize::from(state.is_inside()), choose }) }
    }
}

/// The methods.
pub(super) fn methods(state: &State, send: &Callback<Action>) -> Html {
    let chosen = Method::ALL
        .iter()
        .position(|method| *method == state.inside.method);
    let choose = send.reform(|index: usize| {
        let method = Method::ALL.get(index).copied().unwrap_or_default();
        Action::Inside(InsideAction::By(method))
    });
    html! {
        { part::<Switch>(SwitchProps { class: "mtabs", label: tr!("Method"), names: Method::ALL.map(Method::title).to_vec(), chosen: chosen.unwrap_or(0), choose }) }
    }
}
