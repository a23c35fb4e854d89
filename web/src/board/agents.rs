//! The agents, moving evenly from cell to cell.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Badge, Cast, Detail, Pose};
use giveway_page::form;
use web_sys::Element;
use yew::prelude::*;

use super::motion::{Attribute, children, children_of, use_motion};
use super::units;
use crate::held::Held;

/// The circumference of a battery ring, in units.
const RING: f64 = 226.2;

/// Who, how fine, and which is selected.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct AgentsProps {
    pub(super) cast: Rc<Cast>,
    /// The same agents by another plan: those who are elsewhere in it are marked.
    pub(super) versus: Option<Rc<Cast>>,
    pub(super) detail: Detail,
    pub(super) selected: Option<usize>,
}

/// The capsules of slow moves, and the agents above them.
#[component]
pub(super) fn Agents(props: &AgentsProps) -> Html {
    let (transits, agents) = (use_node_ref(), use_node_ref());
    {
        let (props, transits, agents) = (props.clone(), transits.clone(), agents.clone());
        use_motion(move || {
            let transits = children(&transits).into_iter().map(Transit::new);
            let is_dot = props.detail == Detail::Dots;
            let parts = children(&agents).into_iter();
            let parts = parts.map(|agent| Parts::new(agent, is_dot));
            let moving: Vec<(Transit, Parts)> = transits.zip(parts).collect();
            move |time| {
                for (agent, (transit, parts)) in moving.iter().enumerate() {
                    if let Some(pose) = props.cast.pose(agent, time) {
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
        html! { <rect key={agent} class={classes!("transit", form::class(agent))} rx="42" data-off="" /> }
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
    let class = classes!(
        "agent",
        form::class(agent),
        (!has_battery).then_some("no-battery")
    );
    let selection = html! {
        <>
            if props.versus.is_some() {
                // Around the ring of the selection.
                <circle class="diffring" r={if is_selected { "54" } else { "47" }} />
            }
            if is_selected {
                <circle class="selring" r="47" />
            }
        </>
    };
    let shape = match detail {
        Detail::Dots => html! { <circle class="form" r="38" /> },
        Detail::Forms => html! { <g class="body">{ crate::form(agent) }</g> },
        Detail::Plain | Detail::All => html! {
            <>
                <circle class="halo" r="41" />
                <path class="beak" d="M38-9.5 49 0 38 9.5Z" visibility="hidden" />
                if has_battery {
                    <circle class="ring" r="36" />
                    <circle class="lvl" r="36" transform="rotate(-90)" />
                }
                <g class="body">
                    { crate::form(agent) }
                    { name(&props.cast.agents[agent].name) }
                </g>
                <g class="badge-at">
                    <g class="chbadge"><circle r="17" /><path d="M2.5-10-7 2.5h6l-2 9L8-3.5H1.5Z" /></g>
                    <g class="wbadge"><circle r="17" /><path d="M-4-6V6M4-6V6" /></g>
                </g>
            </>
        },
    };
    html! { <g key={agent} {class}>{ selection }{ shape }</g> }
}

pub(super) fn name(name: &str) -> Html {
    let short = form::short_name(name);
    let is_long = form::is_long(&short);
    html! {
        <text class={classes!("name", is_long.then_some("long"))} y={if is_long { "6.5" } else { "8.6" }} text-anchor="middle">
            { short }
        </text>
    }
}

/// Where an agent is.
enum Place {
    /// Of all of it.
    Shift(Attribute),
    /// Of each circle: without a transform the browser paints all dots as one
    /// piece, which takes it much less time where they are many.
    Middles(Vec<(Attribute, Attribute)>),
}

impl Place {
    fn set(&self, x: f64, y: f64) {
        match self {
            Self::Shift(shift) => shift.set(&format!("translate({x:.1} {y:.1})")),
            Self::Middles(middles) => {
                let (x, y) = (format!("{x:.1}"), format!("{y:.1}"));
                for (across, down) in middles {
                    across.set(&x);
                    down.set(&y);
                }
            }
        }
    }
}

/// What moves of an agent.
struct Parts {
    place: Place,
    gone: Attribute,
    differs: Attribute,
    turn: Option<Attribute>,
    turns: Option<Attribute>,
    ring: Option<Attribute>,
    level: Option<Attribute>,
    charges: Option<Attribute>,
    waits: Option<Attribute>,
    badge: Option<Attribute>,
}

impl Parts {
    fn new(agent: Element, is_dot: bool) -> Self {
        let part = |class, name| Attribute::of_part(&agent, class, name);
        let place = if is_dot {
            let circles = children_of(&agent).into_iter();
            let middles = circles.map(|circle| {
                let across = Attribute::new(circle.clone(), "cx");
                (across, Attribute::new(circle, "cy"))
            });
            Place::Middles(middles.collect())
        } else {
            Place::Shift(Attribute::new(agent.clone(), "transform"))
        };
        Self {
            turn: part("beak", "transform"),
            turns: part("beak", "visibility"),
            ring: part("lvl", "stroke-dasharray"),
            level: part("lvl", "data-level"),
            charges: part("chbadge", "data-on"),
            waits: part("wbadge", "data-on"),
            badge: part("badge-at", "transform"),
            gone: Attribute::new(agent.clone(), "data-gone"),
            differs: Attribute::new(agent, "data-differs"),
            place,
        }
    }

    fn show(&self, pose: &Pose, cast: &Cast) {
        let (x, y) = (units(pose.at.x), units(pose.at.y));
        self.place.set(x, y);
        self.gone.toggle(pose.is_gone);
        if let (Some(turn), Some(turns)) = (&self.turn, &self.turns) {
            if let Some(heading) = pose.heading {
                turn.set(&format!("rotate({heading:.0})"));
                turns.set("visible");
            } else {
                turns.set("hidden");
            }
        }
        if let (Some(ring), Some(level), Some(charge)) = (&self.ring, &self.level, pose.charge) {
            ring.set(&format!("{:.1} {RING}", charge.share * RING));
            level.set(charge.class());
        }
        if let (Some(charges), Some(waits), Some(badge)) = (&self.charges, &self.waits, &self.badge)
        {
            charges.toggle(pose.badge == Some(Badge::Charges));
            waits.toggle(pose.badge == Some(Badge::Waits));
            if pose.badge.is_some() {
                // The flag of a goal has the upper right corner.
                let has_flag = cast.has_goal_at(pose.at);
                badge.set(if has_flag {
                    "translate(29 29)"
                } else {
                    "translate(29 -29)"
                });
            }
        }
    }
}

/// The capsule over both cells of a slow move.
struct Transit {
    element: Element,
    off: Attribute,
    over: Held<Option<(Cell, Cell)>>,
}

impl Transit {
    fn new(element: Element) -> Self {
        let off = Attribute::new(element.clone(), "data-off");
        Self {
            element,
            off,
            over: Held::new(None),
        }
    }

    fn show(&self, over: Option<(Cell, Cell)>) {
        self.off.toggle(over.is_none());
        let Some((from, to)) = over else { return };
        if self.over.get() == over {
            return;
        }
        self.over.set(over);
        let (left, top) = (from.x.min(to.x), from.y.min(to.y));
        let (across, down) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
        let sides = [
            ("x", 100 * left + 8),
            ("y", 100 * top + 8),
            ("width", 100 * across + 84),
            ("height", 100 * down + 84),
        ];
        for (name, value) in sides {
            // The names are valid, so that it cannot fail.
            let _ = self.element.set_attribute(name, &value.to_string());
        }
    }
}
