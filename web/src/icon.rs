//! The icons of the design, by their names in `static/icons.svg`.
//!
//! Plain functions: an icon has no state, and a component would cost more code at
//! each of its many places than it draws.

use yew::prelude::*;

/// An icon, by its name without the `i-` before it. It is silent: the control that
/// holds it has the name.
pub(crate) fn show(name: &str) -> Html {
    draw(name, "icon")
}

/// The same at the end of a line.
pub(crate) fn at_end(name: &str) -> Html {
    draw(name, "icon end")
}

#[inline(never)]
fn draw(name: &str, class: &'static str) -> Html {
    html! {
        <svg {class} aria-hidden="true"><use href={format!("static/icons.svg#i-{name}")} /></svg>
    }
}
