//! The rules of the scene's own on the board: zones and lanes on the floor, tabs with signs and
//! tags above the ways.

use std::rc::Rc;

use giveway_page::Draft;
use giveway_page::board::{
    KeptShape, LaneShape, RulesNow, SignKind, TabWords, TagShape, ZoneShape, kept_free,
    rule_shapes, rules_at, rules_now, tab_parts,
};
use giveway_page::rules::Lit;
use yew::prelude::*;

use crate::part::part;
use crate::{Shown, glyph};

/// Of which scene, at which time, and what is lit.
#[derive(Clone, Properties)]
struct RulesProps {
    draft: Rc<Draft>,
    now: RulesNow,
    lit: Option<Lit>,
    /// The cells that the rule which is looked at keeps free.
    kept: Vec<KeptShape>,
    layer: Layer,
    /// The id of the hatch of closed zones.
    hatch: &'static str,
}

impl PartialEq for RulesProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.draft, &other.draft)
            && self.now == other.now
            && self.lit == other.lit
            && self.kept == other.kept
            && self.layer == other.layer
            && self.hatch == other.hatch
    }
}

/// What of the rules lies at which height.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layer {
    /// Zones and lanes, on the floor.
    Floor,
    /// The tabs of zones with their signs, above the ways.
    Tabs,
    /// Tags, above robots and flags.
    Tags,
}

/// One of the layers.
pub(super) fn layer(state: &Shown, draft: &Rc<Draft>, layer: Layer) -> Html {
    show(state, draft, layer, "shut")
}

/// One of the layers on paper, with a hatch of its own: a browser takes none from a board that
/// is hidden.
pub(super) fn on_paper(state: &Shown, layer: Layer) -> Html {
    show(state, state.world(), layer, "shut-paper")
}

/// Zones and lanes of a small board, at a time.
pub(super) fn on_small(draft: &Rc<Draft>, time: u32) -> Html {
    let scene = draft.scene();
    if scene.zones.is_empty() && scene.constraints.is_empty() {
        return Html::default();
    }
    let props = RulesProps {
        now: rules_at(draft, time),
        draft: Rc::clone(draft),
        lit: None,
        kept: Vec::new(),
        layer: Layer::Floor,
        hatch: "shut-small",
    };
    html! { { part::<Rules>(props) } }
}

fn show(state: &Shown, draft: &Rc<Draft>, layer: Layer, hatch: &'static str) -> Html {
    let scene = draft.scene();
    if scene.zones.is_empty() && scene.constraints.is_empty() {
        return Html::default();
    }
    let props = RulesProps {
        now: rules_now(state, draft),
        draft: Rc::clone(draft),
        lit: state.lit_rule().cloned(),
        kept: if layer == Layer::Tabs {
            kept_free(state)
        } else {
            Vec::new()
        },
        layer,
        hatch,
    };
    html! { { part::<Rules>(props) } }
}

/// The shapes of one layer.
#[component]
fn Rules(props: &RulesProps) -> Html {
    let shapes = rule_shapes(&props.draft, &props.now, props.lit.as_ref());
    match props.layer {
        Layer::Floor => html! {
            <g class="rules-on" aria-hidden="true">
                <defs><pattern id={props.hatch} width="18" height="18" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><path class="shut-l" d="M9 0V18" /></pattern></defs>
                { for shapes.zones.iter().map(zone) }
                { for shapes.lanes.iter().map(lane) }
            </g>
        },
        Layer::Tabs => {
            html! { <g class="rules-on" aria-hidden="true">{ for props.kept.iter().map(kept) }{ for shapes.zones.iter().map(tab) }</g> }
        }
        Layer::Tags => {
            html! { <g class="rules-on" aria-hidden="true">{ for shapes.tags.iter().map(tag) }</g> }
        }
    }
}

fn class(zone: &ZoneShape) -> Classes {
    classes!(
        "zone",
        zone.is_lit.then_some("lit"),
        zone.is_closed.then_some("force"),
        zone.is_broken.then_some("broken")
    )
}

fn zone(zone: &ZoneShape) -> Html {
    let path =
        |class: &'static str| html! { <path {class} fill-rule="evenodd" d={zone.path.clone()} /> };
    html! {
        <g class={class(zone)}>
            { path("zone-fill") }
            if zone.is_closed { { path("zone-hatch") } }
            { path("zone-halo") }
            { path("zone-line") }
        </g>
    }
}

/// The cells that are kept free behind a robot, or around it.
fn kept(kept: &KeptShape) -> Html {
    html! { <path class={classes!("kept-free", glyph::class(kept.agent))} d={kept.path.clone()} /> }
}

fn lane(lane: &LaneShape) -> Html {
    let chevron = |&(x, y, degrees): &(u32, u32, u32)| {
        html! {
            <g transform={format!("translate({x} {y}) rotate({degrees})")}>
                <path class="chevron-halo" d="M-15-39 9-11M-15 39 9 11" /><path class="chevron" d="M-15-39 9-11M-15 39 9 11" />
            </g>
        }
    };
    html! { <g class={classes!("one-way", lane.is_lit.then_some("lit"), lane.is_broken.then_some("broken"))}>{ for lane.borders.iter().map(chevron) }</g> }
}

/// The room of a clock in a tag, in units.
const CLOCK: f64 = 26.0;

fn tab(zone: &ZoneShape) -> Html {
    let (x, y) = zone.tab;
    let parts = tab_parts(zone);
    let width = parts.end.to_string();
    let words = |class: Option<&'static str>, at: TabWords, words: &str| {
        let (x, width) = (at.middle.to_string(), at.width.to_string());
        html! { <text {class} {x} y="8.5" text-anchor="middle" textLength={width} lengthAdjust="spacingAndGlyphs">{ words.to_owned() }</text> }
    };
    let at = |sign: (usize, &SignKind)| {
        let by = parts.apart * sign.0 as f64;
        html! { <g transform={format!("translate({by} 0)")}>{ show_sign(sign.1) }</g> }
    };
    html! {
        <g class={class(zone)} transform={format!("translate({x} {y})")}>
            <g class="zone-tab">
                <rect x="0" y="-19.5" {width} height="39" rx="12" />
                { words(None, parts.name, &zone.name) }
                { for zone.times.as_deref().zip(parts.times).map(|(times, at)| words(Some("zone-times"), at, times)) }
            </g>
            <g class="signs">{ for zone.signs.iter().enumerate().map(at) }</g>
        </g>
    }
}

fn show_sign(sign: &SignKind) -> Html {
    let ring = |inner: Html| html! { <><circle class="sign-ring" r="17" />{ inner }</> };
    match sign {
        SignKind::Ring(number) => ring(
            html! { <text class="sign-text" y="7.5" text-anchor="middle">{ number.clone() }</text> },
        ),
        SignKind::Bar => ring(html! { <path class="sign-bar" d="M-8 0H8" /> }),
        SignKind::Pause => {
            ring(html! { <path class="sign-struck" d="M-4-6V6M4-6V6M-12 12 12-12" /> })
        }
        SignKind::Triangle(number) => html! {
            <><path class="sign-ring" d="M-20-16H20L0 18Z" /><text class="sign-text small" y="0" text-anchor="middle">{ number.clone() }</text></>
        },
        SignKind::Dot => html! { <circle class="sign-dot" r="6" /> },
    }
}

fn tag(tag: &TagShape) -> Html {
    let (dx, dy) = tag.place();
    let (x, y) = (
        f64::from(tag.cell.x) * 100.0 + dx,
        f64::from(tag.cell.y) * 100.0 + dy,
    );
    // A clock stands before the steps of a stay.
    let is_stay = tag.class.contains("stay");
    let clock = if is_stay { CLOCK } else { 0.0 };
    let words = tag.words_width();
    let width = words + 12.0 + clock;
    let left = -width / 2.0;
    let bar = match tag.class {
        "late" => Some(width / 2.0),
        "early" => Some(left),
        _ => None,
    };
    html! {
        <g class={classes!("rule-tag-on", tag.is_broken.then_some("broken"), tag.class.split(' ').map(str::to_owned).collect::<Vec<_>>())} transform={format!("translate({x} {y})")}><g class="in">
            <rect x={left.to_string()} y="-14" width={width.to_string()} height="28" rx="6" />
            <text x={(clock / 2.0).to_string()} y="6.5" text-anchor="middle" textLength={words.to_string()} lengthAdjust="spacingAndGlyphs">{ tag.text.clone() }</text>
            if is_stay {
                <path class="stay-clock" transform={format!("translate({} 0)", left + CLOCK / 2.0 + 3.0)} d="M0-8a8 8 0 1 0 .01 0M0-4V0l3 2" />
            }
            if let Some(bar) = bar { <path d={format!("M{bar} -15V15")} /> }
        </g></g>
    }
}
