//! What stands below the board: the legend, or what the page has to say in its place,
//! and how near the map is.

use giveway_model::tr;
use giveway_page::board::Kind;
use giveway_page::find::FindAction;
use giveway_page::inside::Sign;
use giveway_page::{Action, ViewAction};
use yew::prelude::*;

use super::differences;
use super::find::{FindField, FindProps};
use super::options::options;
use super::viewport::Look;
use crate::part::part;
use crate::{Shown, glyph, icon, slot};

/// By how much a button or key enlarges.
pub(super) const ZOOM: f64 = 1.5;
/// From so many agents on there is a button to find one.
const MANY: usize = 12;

/// What to explain, and how the view can change.
pub(super) struct Under<'a> {
    pub(super) kinds: Vec<Kind>,
    /// What is explained instead.
    pub(super) signs: Option<Vec<Sign>>,
    pub(super) look: &'a Callback<Look>,
    pub(super) is_fit: bool,
    pub(super) is_nearest: bool,
    /// Whether cells are small, or only a part of them is in sight: a phone has the buttons then,
    /// too.
    pub(super) is_small: bool,
    /// The agent that the camera can go with, and whether it does.
    pub(super) follow: Option<(AttrValue, bool)>,
    pub(super) send: &'a Callback<Action>,
    pub(super) state: &'a Shown,
}

/// The legend and the buttons of the view.
pub(super) fn under(props: &Under<'_>) -> Html {
    let kind = |kind: &Kind| html! { <li><i class={kind.class()}></i>{ kind.words() }</li> };
    let button = |name: &'static str, icon: &'static str, key: char, is_off: bool, look: Look| {
        let onclick = props.look.reform(move |_| look);
        html! {
            <button class="btn ghost round" title={format!("{name} ({key})")} aria-label={name}
                aria-disabled={is_off.then_some("true")} {onclick}>
                { icon::show(icon) }
            </button>
        }
    };
    let sign = |sign: &Sign| {
        let class = classes!(sign.class, sign.agent.map(glyph::class));
        html! { <li><i {class}></i>{ sign.words.clone() }</li> }
    };
    let signs: Html = match &props.signs {
        Some(signs) => signs.iter().map(sign).collect(),
        None => props.kinds.iter().map(kind).collect(),
    };
    let said = slot::said(props.state);
    let differences = differences::row(props.state, props.send).filter(|_| said.is_none());
    let options =
        options(props.state, props.send).filter(|_| said.is_none() && differences.is_none());
    let finds = props.state.view.find.is_some();
    let is_covered = said.is_some() || differences.is_some() || options.is_some();
    html! {
        <div class={classes!("under", props.is_small.then_some("small"), finds.then_some("finds"))}>
            { slot::show(props.state, said.as_ref(), props.send) }
            <ul class="legend" aria-label={tr!("Legend")} hidden={is_covered}>{ signs }</ul>
            { differences }
            { options }
            <div class="zoom" role="group" aria-label={tr!("View")}>
                { find(props) }
                if !finds { { follow(props) } }
                { button(tr!("Zoom out"), "minus", '-', props.is_fit, Look::Zoom(1.0 / ZOOM, None)) }
                { button(tr!("Fit"), "fit", '0', props.is_fit, Look::Fit) }
                { button(tr!("Zoom in"), "plus", '+', props.is_nearest, Look::Zoom(ZOOM, None)) }
            </div>
        </div>
    }
}

/// The button that finds a robot, where they are not seen at one glance.
fn find(props: &Under<'_>) -> Html {
    if props.state.view.find.is_some() {
        let (state, send) = (props.state.clone(), props.send.clone());
        return part::<FindField>(FindProps { state, send });
    }
    if props.state.world().agents().len() < MANY {
        return html! {};
    }
    let onclick = props.send.reform(|_| Action::Find(FindAction::Open));
    html! {
        <button class="btn ghost round" title={tr!("Find a robot (/)")} aria-label={tr!("Find a robot")} {onclick}>{ icon::show("search") }</button>
    }
}

/// The button that lets the camera go with the agent selected.
fn follow(props: &Under<'_>) -> Html {
    let Some((name, on)) = props.follow.clone() else {
        return html! {};
    };
    let onclick = props
        .send
        .reform(move |_| Action::View(ViewAction::Follow(!on)));
    html! {
        <button class="btn ghost round" title={tr!("Follow {name} (f)", name)} aria-label={tr!("Follow {name}", name)}
            aria-pressed={on.to_string()} {onclick}>
            { icon::show("follow") }
        </button>
    }
}
