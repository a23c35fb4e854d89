//! A new scene: its name and its size.

use giveway_model::tr;
use giveway_page::files::blank;
use giveway_page::{Action, FileAction, MAX_SIDE, number};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::frame::Frame;
use crate::field::possible;

/// The size that is proposed: the board shows it whole on a phone, too.
const SIZE: (u32, u32) = (8, 6);
/// The least and the most cells of a side.
const SIDES: (u32, u32) = (1, MAX_SIDE);

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct NewSceneProps {
    /// Takes the scene.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// Asks for the name and the size of a new scene, which is empty.
#[component]
pub(crate) fn NewScene(props: &NewSceneProps) -> Html {
    let NewSceneProps { send, on_close } = props;
    // Kept here: the page may be rendered anew while somebody types.
    let name = use_state_eq(String::new);
    let columns = use_state_eq(|| SIZE.0.to_string());
    let rows = use_state_eq(|| SIZE.1.to_string());
    let side = |typed: &str| number::read(typed, SIDES);
    let size = side(&columns).zip(side(&rows));
    let create = {
        let (send, on_close) = (send.clone(), on_close.clone());
        let name = name.clone();
        Callback::from(move |()| {
            let Some((columns, rows)) = size else { return };
            let scene = blank(&name, columns, rows);
            on_close.emit(());
            send.emit(Action::File(FileAction::Open(Box::new(scene))));
        })
    };
    let enter = {
        let create = create.clone();
        Callback::from(move |event: KeyboardEvent| {
            if event.key() == "Enter" {
                event.prevent_default();
                create.emit(());
            }
        })
    };
    let field = |id: &'static str, label: &'static str, of: &UseStateHandle<String>| {
        html! {
            <div>
                <label for={id}>{ label }</label>
                <input {id} class="field" type="number" inputmode="numeric" min="1"
                    max={SIDES.1.to_string()} value={(**of).clone()}
                    oninput={typing(of)} onkeydown={enter.clone()} />
                if side(of).is_none() { { possible(SIDES) } }
            </div>
        }
    };
    html! {
        <Frame title={tr!("New scene")} narrow=true on_close={on_close.clone()}>
            <p>{ tr!("An empty floor. What is on the board now comes back with Undo.") }</p>
            <div class="new-scene">
                <div class="new-name">
                    <label for="new-name">{ tr!("Name") }</label>
                    <input id="new-name" class="field" type="text" maxlength="60" placeholder={tr!("Untitled")}
                        value={(*name).clone()} oninput={typing(&name)} onkeydown={enter.clone()} autofocus=true />
                </div>
                { field("new-columns", tr!("Columns"), &columns) }
                { field("new-rows", tr!("Rows"), &rows) }
            </div>
            <div class="dialog-foot">
                <button type="button" class="btn outline" onclick={on_close.reform(|_| ())}>{ tr!("Back") }</button>
                <button type="button" class="btn primary" disabled={size.is_none()} onclick={create.reform(|_| ())}>{ tr!("Create") }</button>
            </div>
        </Frame>
    }
}

fn typing(of: &UseStateHandle<String>) -> Callback<InputEvent> {
    let of = of.clone();
    Callback::from(move |event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        of.set(input.value());
    })
}
