//! A robot is found by its name: a field, and the list of those that fit.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::find::{FindAction, Match, found};
use wasm_bindgen::JsCast as _;
use web_sys::{HtmlDialogElement, HtmlElement, HtmlInputElement};
use yew::prelude::*;

use super::frame::Frame;
use crate::{Shown, glyph};

/// The names of the list and of its rows, for the field that they belong to.
const LIST: &str = "found";

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct FindProps {
    /// The state, in which a robot is looked for.
    pub(crate) state: Shown,
    /// Takes actions.
    pub(crate) send: Callback<Action>,
}

/// The field keeps the focus: arrows choose in the list, Enter takes.
#[component]
pub(crate) fn FindRobot(props: &FindProps) -> Html {
    let FindProps { state, send } = props;
    let field = use_node_ref();
    let act = send.reform(Action::Find);
    {
        let field = field.clone();
        // After the dialog has opened, which gives the focus to its first button.
        use_effect_with((), move |()| {
            let focus = gloo::timers::callback::Timeout::new(0, move || focus(field.cast()));
            move || drop(focus)
        });
    }
    let Some(found) = found(state) else {
        return html! {};
    };
    let take = {
        let (field, act) = (field.clone(), act.clone());
        Callback::from(move |place: Option<usize>| {
            leave(&field);
            act.emit(FindAction::Take(place));
        })
    };
    let oninput = act.reform(|event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        FindAction::Type(input.value())
    });
    let onkeydown = {
        let (act, take, is_none) = (act.clone(), take.clone(), found.matches.is_empty());
        move |event: KeyboardEvent| {
            match event.key().as_str() {
                "ArrowDown" => act.emit(FindAction::Step { down: true }),
                "ArrowUp" => act.emit(FindAction::Step { down: false }),
                "Enter" if !is_none && !event.is_composing() => take.emit(None),
                _ => return,
            }
            event.prevent_default();
        }
    };
    let row = |(place, one): (usize, &Match)| {
        let onclick = take.reform(move |_: MouseEvent| Some(place));
        html! {
            <li key={one.agent} id={id(place)} class={classes!("choice", one.is_chosen.then_some("on"))} role="option"
                aria-selected={one.is_chosen.to_string()} {onclick}>
                { glyph::show(one.agent, "choice-glyph") }
                <span><b>{ one.name.clone() }</b><small>{ one.place.clone() }</small></span>
            </li>
        }
    };
    let chosen = found.matches.iter().position(|one| one.is_chosen).map(id);
    html! {
        <Frame title={tr!("Find a robot")} narrow=true on_close={act.reform(|()| FindAction::Close)}>
            <input ref={field} class="field" type="text" role="combobox" aria-label={tr!("Name of the robot")} autocomplete="off"
                autocapitalize="off" spellcheck="false" aria-autocomplete="list" aria-expanded={(!found.matches.is_empty()).to_string()}
                aria-controls={LIST} aria-activedescendant={chosen} value={found.typed.clone()} {oninput} {onkeydown} />
            <p class="hint" role="status">{ found.sentence.clone() }</p>
            <ul id={LIST} class="choices" role="listbox" aria-label={tr!("Robots")}>{ for found.matches.iter().enumerate().map(row) }</ul>
        </Frame>
    }
}

fn id(place: usize) -> String {
    format!("{LIST}-{place}")
}

/// Closes the dialog, and goes to the board: its cell of the keyboard will be the robot's.
fn leave(field: &NodeRef) {
    let dialog = field.cast::<HtmlElement>();
    let dialog = dialog.and_then(|field| field.closest("dialog").ok().flatten());
    if let Some(dialog) = dialog.and_then(|dialog| dialog.dyn_into::<HtmlDialogElement>().ok()) {
        dialog.close();
    }
    let board = gloo::utils::document().query_selector(".map[role=grid]");
    focus(
        board
            .ok()
            .flatten()
            .map(wasm_bindgen::JsCast::unchecked_into),
    );
}

fn focus(element: Option<HtmlElement>) {
    if let Some(element) = element {
        // What cannot take it leaves it where it is.
        let _ = element.focus();
    }
}
