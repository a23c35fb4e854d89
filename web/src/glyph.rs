//! An agent's form with its name, on the board and beside its name elsewhere.

use std::cell::Cell;

use giveway_page::timeline::ShownName;
use giveway_page::{State, board, form};
use yew::prelude::*;

thread_local! {
    /// The look of each agent on the page, as the language of the page is one for all of
    /// it. A program without any shows agents in their order.
    static LOOKS: Cell<Vec<usize>> = const { Cell::new(Vec::new()) };
}

/// From now on agents have these looks.
pub(crate) fn set_looks(looks: Vec<usize>) {
    LOOKS.set(looks);
}

/// The look of an agent, by its index on the board.
pub(crate) fn look(agent: usize) -> usize {
    let looks = LOOKS.take();
    let look = looks.get(agent).copied().unwrap_or(agent);
    LOOKS.set(looks);
    look
}

/// The class that sets an agent's colours, by its index on the board.
pub(crate) fn class(agent: usize) -> &'static str {
    form::class(look(agent))
}

/// An agent's form around `(0, 0)`, radius 27, for use inside an SVG whose class
/// sets the agent's colours; `agent` is its index on the board.
pub fn form(agent: usize) -> Html {
    of_look(look(agent))
}

/// The form of a look.
pub(crate) fn of_look(look: usize) -> Html {
    let form = form::of(look);
    html! {
        <>
            <path class={classes!("form", form.is_padded.then_some("padded"))} d={form.body} />
            if let Some(rim) = form.rim {
                <path class="rim" d={rim} />
            }
            if let Some(cut) = form.cut {
                <path class="cut" d={cut} />
            }
        </>
    }
}

/// A small picture of an agent, by its index in the scene; `class` sets its size. It
/// is silent: its name stands beside it.
pub(crate) fn show(agent: usize, class: &'static str) -> Html {
    draw(agent, html! {}, class)
}

/// The picture above the facts about an agent, with what stands on its form on the board.
pub(crate) fn named(state: &State, agent: usize) -> Html {
    let badges = board::badges(state.world().agents());
    let short = badges.get(agent).cloned().unwrap_or_default();
    let is_long = form::is_long(&short);
    let name = html! {
        <text class={classes!("gname", is_long.then_some("long"))} y={if is_long { "6.5" } else { "8.5" }} text-anchor="middle">{ short }</text>
    };
    draw(agent, name, "insp-glyph")
}

#[inline(never)]
fn draw(agent: usize, name: Html, class: &'static str) -> Html {
    html! {
        <svg class={classes!("glyph", self::class(agent), class)} viewBox="-32 -32 64 64" aria-hidden="true">
            { form(agent) }
            { name }
        </svg>
    }
}

/// The name of an agent in a narrow column: of a long one the beginning and the end are seen,
/// and all of it is read aloud. Where even that has no room, the style sheet shows the short name.
pub(crate) fn narrow_name(name: &str, shown: &ShownName) -> Html {
    let ShownName { cut, short } = shown;
    let class = match cut.chars().count() {
        ..5 => return html! { <bdi>{ cut.clone() }</bdi> },
        5..8 => "l5",
        8..11 => "l8",
        _ => "l11",
    };
    html! {
        <span {class}>
            if cut == name {
                <bdi class="cut">{ cut.clone() }</bdi>
            } else {
                <span class="vh">{ name.to_owned() }</span><bdi class="cut" aria-hidden="true">{ cut.clone() }</bdi>
            }
            <bdi class="short">{ short.clone() }</bdi>
        </span>
    }
}
