//! The field below the board in which a robot is found by its name.

use giveway_model::tr;
use giveway_page::find::{FindAction, found};
use giveway_page::{Action, ViewAction};
use web_sys::{HtmlElement, HtmlInputElement};
use yew::prelude::*;

use crate::{Shown, icon};

#[derive(Clone, PartialEq, Properties)]
pub(super) struct FindProps {
    pub(super) state: Shown,
    pub(super) send: Callback<Action>,
}

/// The field, which has the focus: Enter selects the next robot, Escape closes it.
#[component]
pub(super) fn FindField(props: &FindProps) -> Html {
    let FindProps { state, send } = props;
    let field = use_node_ref();
    {
        let field = field.clone();
        use_effect_with((), move |()| focus(field.cast()));
    }
    let Some(found) = found(state) else {
        return html! {};
    };
    let act = send.reform(Action::Find);
    let oninput = act.reform(|event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        FindAction::Type(input.value())
    });
    let close = {
        let act = act.clone();
        move || {
            act.emit(FindAction::Close);
            let board = gloo::utils::document().query_selector(".map[role=grid]");
            focus(
                board
                    .ok()
                    .flatten()
                    .map(wasm_bindgen::JsCast::unchecked_into),
            );
        }
    };
    let onkeydown = {
        let close = close.clone();
        move |event: KeyboardEvent| {
            match event.key().as_str() {
                "Enter" if !event.is_composing() => act.emit(FindAction::Step {
                    on: !event.shift_key(),
                }),
                "ArrowDown" => act.emit(FindAction::Step { on: true }),
                "ArrowUp" => act.emit(FindAction::Step { on: false }),
                "Escape" => close(),
                _ => return,
            }
            event.prevent_default();
            event.stop_propagation();
        }
    };
    let is_on = state.view.follow;
    let follow = send.reform(move |_: MouseEvent| Action::View(ViewAction::Follow(!is_on)));
    let can_follow = found.agent.is_some() && state.last_time() > 0;
    html! {
        <div class="find" role="search">
            { icon::show("search") }
            <input ref={field} type="text" aria-label={tr!("Name of the robot")} placeholder={tr!("Name")} autocomplete="off"
                autocapitalize="off" spellcheck="false" enterkeyhint="next" value={found.typed.clone()} {oninput} {onkeydown} />
            <small role="status">{ found.place.clone() }</small>
            if can_follow {
                <button type="button" class="chip" aria-pressed={is_on.to_string()} title={tr!("Follow (f)")} onclick={follow}>
                    { icon::show("follow") }{ tr!("Follow") }
                </button>
            }
            <button type="button" class="btn ghost round" aria-label={tr!("Close")} title={tr!("Close")} onclick={move |_: MouseEvent| close()}>{ icon::show("cancel") }</button>
        </div>
    }
}

fn focus(element: Option<HtmlElement>) {
    if let Some(element) = element {
        // What cannot take it leaves it where it is.
        let _ = element.focus();
    }
}
