//! The agents, moving evenly from cell to cell.

mod fixed;
mod parts;
mod transit;

use std::cell::Cell;
use std::rc::Rc;

use giveway_page::board::{Badge, Cast, Detail, Side, TurnSide, sides};
use giveway_page::{Draft, Point, form};
use giveway_picture::whole;
use web_sys::Element;
use yew::prelude::*;

use super::motion::{Attribute, children, use_motion};
use super::viewport::Sight;
use crate::same::Same;
use crate::{Clock, glyph};
use fixed::Fixed;
use parts::Parts;
use transit::Transit;

/// Who, how fine, and which is selected.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct AgentsProps {
    pub(super) cast: Rc<Cast>,
    /// The map that they are on.
    pub(super) draft: Same<Draft>,
    /// The same agents by another plan: those who are elsewhere in it are marked.
    pub(super) versus: Option<Rc<Cast>>,
    pub(super) detail: Detail,
    pub(super) selected: Option<usize>,
    /// Whom a step is about: the others are faint.
    pub(super) lit: Option<Vec<usize>>,
    /// Whom a text names just now.
    pub(super) named: Option<usize>,
    /// What is in sight.
    pub(super) sight: Sight,
    /// The time at which they are drawn at once, on paper: nothing moves them there.
    #[prop_or_default]
    pub(super) still: Option<f64>,
}

/// Where an agent was drawn last. While it plays, it stays there as long as neither
/// that nor where it is now is in sight: most of a large crowd, seen from near.
type Drawn = Cell<Option<Point>>;

/// The capsules of slow moves, and the agents above them.
#[component]
pub(super) fn Agents(props: &AgentsProps) -> Html {
    let (transits, agents) = (use_node_ref(), use_node_ref());
    let clock = use_context::<Clock>();
    {
        let (props, transits, agents) = (props.clone(), transits.clone(), agents.clone());
        use_motion(move || {
            let transits = children(&transits).into_iter().map(Transit::new);
            let parts = children(&agents).into_iter();
            let parts = parts.map(|agent| Parts::new(agent, props.detail));
            let moving: Vec<(Transit, Parts, Drawn)> = transits
                .zip(parts)
                .map(|(transit, parts)| (transit, parts, Drawn::default()))
                .collect();
            let sides = Sides::new(&agents, &props);
            move |time| {
                sides.show(&props, time);
                let frame = props.sight.get();
                // Where it rests, all have to be where they are: whatever comes
                // into sight then comes without another frame.
                let plays = clock.as_ref().is_some_and(Clock::plays);
                for (agent, (transit, parts, drawn)) in moving.iter().enumerate() {
                    if let Some(pose) = props.cast.pose(agent, time) {
                        let seen = |at: Point| frame.shows(at);
                        if plays && !seen(pose.at) && !drawn.get().is_none_or(seen) {
                            continue;
                        }
                        drawn.set(Some(pose.at));
                        transit.show(pose.transit);
                        parts.show(&pose, &props.cast);
                        let versus = props.versus.as_ref();
                        let other = versus.and_then(|versus| versus.pose(agent, time));
                        parts
                            .differs
                            .toggle(other.is_some_and(|other| pose.is_elsewhere(&other)));
                    }
                }
            }
        });
    }
    let transit = |agent: usize| {
        html! { <rect key={agent} class={classes!("transit", glyph::class(agent))} rx="42" data-off="" /> }
    };
    let count = props.cast.agents.len();
    html! {
        <g aria-hidden="true">
            <g ref={transits}>{ for (0..count).map(transit) }</g>
            // Dots are moved in another way than what is larger.
            <g key={if props.detail == Detail::Dots { "dots" } else { "agents" }} ref={agents}>{ for (0..count).map(|agent| agent_shape(props, agent)) }</g>
        </g>
    }
}

fn agent_shape(props: &AgentsProps, agent: usize) -> Html {
    let detail = props.detail;
    let has_battery = props.cast.agents[agent].battery.is_some();
    let is_selected = props.selected == Some(agent);
    let lit = props.lit.as_ref().map(|lit| lit.contains(&agent));
    let class = classes!(
        "agent",
        glyph::class(agent),
        is_selected.then_some("me"),
        (lit == Some(false)).then_some("dim"),
        (!has_battery).then_some("no-battery")
    );
    let selection = html! {
        <>
            if props.versus.is_some() {
                // Around the ring of the selection.
                <circle class="diffring" r={if is_selected { "54" } else { "47" }} />
            }
            if lit == Some(true) && !is_selected {
                <circle class="litring" r="46" />
            }
            if is_selected {
                <circle class="selring" r="47" />
            }
            if props.named == Some(agent) {
                <circle class="named" r="54" />
            }
        </>
    };
    let fixed = props
        .still
        .and_then(|time| props.cast.pose(agent, time))
        .map(|pose| Fixed::of(&pose, &props.cast))
        .unwrap_or_default();
    let shape = match detail {
        Detail::Dots => html! { <circle class="form" r="38" /> },
        Detail::Forms => html! {
            <>
                <g class="body">{ crate::form(agent) }</g>
                <text class="num beside" dy="0.36em">{ props.cast.numbers[agent].clone() }</text>
            </>
        },
        Detail::Numbers => named_form(agent, &props.cast.numbers[agent], "num"),
        Detail::Plain => html! {
            <>
                { named_form(agent, &props.cast.badges[agent], "num name") }
                { badges(&fixed) }
            </>
        },
        Detail::All => html! {
            <>
                <circle class="halo" r="41" />
                <path class="beak" d="M38-9.5 49 0 38 9.5Z" transform={fixed.turn.clone()}
                    visibility={if fixed.turn.is_some() { "visible" } else { "hidden" }} />
                <path class="beak aim" d="M38-9.5 49 0 38 9.5Z" transform={fixed.aim.clone()}
                    visibility={if fixed.aim.is_some() { "visible" } else { "hidden" }} />
                if has_battery {
                    <circle class="ring" r="36" />
                    <circle class="lvl" r="36" transform="rotate(-90)" stroke-dasharray={fixed.level.clone()} data-level={fixed.reserve} />
                }
                <g class="body">
                    { crate::form(agent) }
                    { name(&props.cast.badges[agent]) }
                </g>
                { badges(&fixed) }
            </>
        },
    };
    html! { <g key={agent} {class} transform={fixed.place.clone()} data-gone={fixed.is_gone.then_some("")}>{ selection }{ shape }</g> }
}

/// A form with a text in it that keeps its size.
fn named_form(agent: usize, text: &str, class: &'static str) -> Html {
    let is_long = form::is_long(text);
    html! {
        <>
            <g class="body">{ crate::form(agent) }</g>
            <text class={classes!(class, is_long.then_some("long"))} dy="0.36em">{ text.to_owned() }</text>
        </>
    }
}

/// What an agent does, where its motion does not show it.
fn badges(fixed: &Fixed) -> Html {
    let does = |badge: Badge| (fixed.does == Some(badge)).then_some("");
    html! {
        <g class="badge-at" transform={fixed.badge.clone()}>
            <g class="chbadge" data-on={does(Badge::Charges)}><circle r="17" /><path d="M2.5-10-7 2.5h6l-2 9L8-3.5H1.5Z" /></g>
            <g class="brbadge" data-on={does(Badge::Broken)}><circle r="17" /><path d="M-6-6 6 6M6-6-6 6" /></g>
            { for TurnSide::ALL.iter().map(|&side| html! {
                <g class={classes!("tbadge", side_class(side))} data-on={does(Badge::Turns(side))}><circle r="17" /><path d={side.arrow()} /></g>
            }) }
            <g class="wbadge" data-on={does(Badge::Waits)}><circle r="17" /><path d="M-4-6V6M4-6V6" /></g>
        </g>
    }
}

/// The class of the badge of a turn.
pub(super) const fn side_class(side: TurnSide) -> &'static str {
    match side {
        TurnSide::Left => "t-left",
        TurnSide::Right => "t-right",
        TurnSide::Back => "t-back",
    }
}

/// The sides on which numbers stand beside their forms; they change with the whole time.
struct Sides {
    numbers: Vec<Attribute>,
    time: Cell<Option<u32>>,
}

impl Sides {
    fn new(agents: &NodeRef, props: &AgentsProps) -> Self {
        let is_beside = props.detail == Detail::Forms;
        let agents = if is_beside {
            children(agents)
        } else {
            Vec::new()
        };
        let number = |agent: &Element| Attribute::of_part(agent, "beside", "data-side");
        Self {
            numbers: agents.iter().filter_map(number).collect(),
            time: Cell::new(None),
        }
    }

    fn show(&self, props: &AgentsProps, time: f64) {
        let time = whole(time);
        if self.numbers.is_empty() || self.time.replace(Some(time)) == Some(time) {
            return;
        }
        let sides = sides(&props.cast, props.draft.grid(), time);
        for (number, side) in self.numbers.iter().zip(sides) {
            number.set(side.map_or("none", Side::class));
        }
    }
}

/// What stands on a form.
pub(super) fn name(short: &str) -> Html {
    let is_long = form::is_long(short);
    html! {
        <text class={classes!("name", is_long.then_some("long"))} y={if is_long { "6.5" } else { "8.6" }} text-anchor="middle">
            { short.to_owned() }
        </text>
    }
}
