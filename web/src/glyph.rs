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

/// Which agent.
#[derive(Clone, PartialEq, Eq, Properties)]
pub struct GlyphProps {
    /// Its index in the scene.
    pub agent: usize,
    /// Its name, where it is to stand on the form.
    #[prop_or_default]
    pub name: Option<AttrValue>,
    /// More classes: they set the size.
    #[prop_or_default]
    pub class: Classes,
}

/// A small picture of an agent. It is silent: its name stands beside it.
#[component]
pub fn Glyph(props: &GlyphProps) -> Html {
    let short = props.name.as_deref().map(form::short_name);
    html! {
        <svg class={classes!("glyph", form::class(props.agent), props.class.clone())} viewBox="-32 -32 64 64" aria-hidden="true">
            { form(props.agent) }
            if let Some(short) = short {
                <text class={classes!("gname", form::is_long(&short).then_some("long"))} y={if form::is_long(&short) { "6.5" } else { "8.5" }} text-anchor="middle">{ short }</text>
            }
        </svg>
    }
}
