//! Foreign changes of the page's elements, by a translator or an extension of the browser:
//! `static/guard.js` announces them, and the elements are built anew from the state.

use std::cell::Cell;

use gloo::events::EventListener;
use yew::html::ChildrenProps;
use yew::prelude::*;

/// The event on the window.
const EVENT: &str = "giveway-foreign";

/// Calls back after each foreign change, as long as the listener is kept.
pub(crate) fn listen(changed: Callback<()>) -> EventListener {
    EventListener::new(&gloo::utils::window(), EVENT, move |_| changed.emit(()))
}

/// The number of foreign changes so far: part of the key of what is to be built anew.
#[hook]
pub(crate) fn use_foreign_changes() -> u32 {
    let count = use_state(|| 0);
    let setter = count.setter();
    use_effect_with((), move |()| {
        let seen = Cell::new(0);
        let listener = listen(Callback::from(move |()| {
            seen.set(seen.get() + 1);
            setter.set(seen.get());
        }));
        move || drop(listener)
    });
    *count
}

/// Builds its children anew when its key changes: at the root of a component, Yew heeds the key of a component, but
/// not that of a fragment.
#[component]
pub(crate) fn Anew(props: &ChildrenProps) -> Html {
    props.children.clone()
}
