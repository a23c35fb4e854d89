//! The tabs beside the transport: lanes or how they were found; and of which method.

use giveway_page::inside::{InsideAction, Method};
use giveway_page::{Action, State};
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
    let list = use_node_ref();
    let onkeydown = {
        let (list, choose) = (list.clone(), choose.clone());
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
            let list = list.cast::<HtmlElement>();
            let button = list.and_then(|list| list.children().item(to as u32));
            if let Some(button) =
                button.and_then(|button| wasm_bindgen::JsCast::dyn_into::<HtmlElement>(button).ok())
            {
                let _ = button.focus();
            }
        }
    };
    let one = |(index, name): (usize, &&'static str)| {
        let is_chosen = index == *chosen;
        html! {
            <button type="button" role="tab" aria-selected={is_chosen.to_string()}
                tabindex={if is_chosen { "0" } else { "-1" }} onclick={choose.reform(move |_| index)}>{ *name }</button>
        }
    };
    html! {
        <div class={classes!("seg", *class)} role="tablist" aria-label={*label} ref={list} {onkeydown}>
            { for names.iter().enumerate().map(one) }
        </div>
    }
}

/// The lanes, or how they were found.
pub(in crate::timeline) fn places(state: &State, send: &Callback<Action>) -> Html {
    if !state.can_look_inside() {
        return html! {};
    }
    let choose = send.reform(|index| Action::Inside(InsideAction::Show(index == 1)));
    html! {
        <Switch class="dtabs" label="What stands below the board" names={vec!["Timeline", "How it was proved"]}
            chosen={usize::from(state.is_inside())} {choose} />
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
        <Switch class="mtabs" label="Method" names={Method::ALL.map(Method::title).to_vec()}
            chosen={chosen.unwrap_or(0)} {choose} />
    }
}
