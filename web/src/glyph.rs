//! An agent's form with its name, on the board and beside its name elsewhere.

use giveway_page::form;
use yew::prelude::*;

/// An agent's form around `(0, 0)`, radius 27, for use inside an SVG whose class
/// sets the agent's colours; `agent` is its index in the scene.
pub fn form(agent: usize) -> Html {
    let form = form::of(agent);
    html! {
        <>
            <path class={classes!("form", form.is_padded.then_some("padded"))} d={form.body} />
            if let Some(rim) = form.rim {
                <path class="rim" d={rim} />
            }
        </>
    }
}

/// A small picture of an agent, by its index in the scene; `class` sets its size. It
/// is silent: its name stands beside it.
pub(crate) fn show(agent: usize, class: &'static str) -> Html {
    draw(agent, html! {}, class)
}

/// The picture above the facts about an agent, with its name on the form.
pub(crate) fn named(agent: usize, name: &str) -> Html {
    let short = form::short_name(name);
    let is_long = form::is_long(&short);
    let name = html! {
        <text class={classes!("gname", is_long.then_some("long"))} y={if is_long { "6.5" } else { "8.5" }} text-anchor="middle">{ short }</text>
    };
    draw(agent, name, "insp-glyph")
}

#[inline(never)]
fn draw(agent: usize, name: Html, class: &'static str) -> Html {
    html! {
        <svg class={classes!("glyph", form::class(agent), class)} viewBox="-32 -32 64 64" aria-hidden="true">
            { form(agent) }
            { name }
        </svg>
    }
}
