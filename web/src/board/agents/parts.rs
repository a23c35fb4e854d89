//! What moves of an agent: its place, where it looks, its battery, its badges.

use giveway_page::board::{Badge, CELL, Cast, Detail, Pose, TurnSide, of_badge};
use web_sys::Element;

use super::side_class;
use crate::board::motion::{Attribute, children_of};
use crate::board::units;

/// The circumference of a battery ring, in units.
pub(super) const RING: f64 = 226.2;

/// Where an agent is.
enum Place {
    /// Of all of it.
    Shift(Attribute),
    /// Of each circle: without a transform the browser paints all dots as one
    /// piece, which takes it much less time where they are many.
    Middles(Vec<(Attribute, Attribute)>),
}

impl Place {
    fn set(&self, x: f64, y: f64, scale: Option<f64>) {
        match self {
            Self::Shift(place) => place.set(&shift(x, y, scale)),
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

/// The place of an agent as a transform.
pub(super) fn shift(x: f64, y: f64, scale: Option<f64>) -> String {
    match scale {
        None => format!("translate({x:.1} {y:.1})"),
        Some(scale) => format!("translate({x:.1} {y:.1}) scale({scale:.2})"),
    }
}

/// What moves of an agent.
pub(super) struct Parts {
    place: Place,
    gone: Attribute,
    pub(super) differs: Attribute,
    turn: Option<Attribute>,
    turns: Option<Attribute>,
    aim: Option<[Attribute; 2]>,
    turning: Vec<(TurnSide, Attribute)>,
    ring: Option<Attribute>,
    level: Option<Attribute>,
    charges: Option<Attribute>,
    waits: Option<Attribute>,
    broken: Option<Attribute>,
    badge: Option<Attribute>,
}

impl Parts {
    pub(super) fn new(agent: Element, detail: Detail) -> Self {
        // Small agents have none of these; to look for them takes long where there are many.
        let has_parts = detail >= Detail::Plain;
        let part = |class, name| {
            let part = has_parts.then(|| Attribute::of_part(&agent, class, name));
            part.flatten()
        };
        let place = if detail == Detail::Dots {
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
            aim: part("aim", "transform")
                .zip(part("aim", "visibility"))
                .map(|(turn, shows)| [turn, shows]),
            turning: TurnSide::ALL
                .into_iter()
                .filter_map(|side| Some((side, part(side_class(side), "data-on")?)))
                .collect(),
            ring: part("lvl", "stroke-dasharray"),
            level: part("lvl", "data-level"),
            charges: part("chbadge", "data-on"),
            waits: part("wbadge", "data-on"),
            broken: part("brbadge", "data-on"),
            badge: part("badge-at", "transform"),
            gone: Attribute::new(agent.clone(), "data-gone"),
            differs: Attribute::new(agent, "data-differs"),
            place,
        }
    }

    pub(super) fn show(&self, pose: &Pose, cast: &Cast) {
        let (x, y) = (units(pose.at.x), units(pose.at.y));
        // Two on one cell stand side by side.
        let by = pose.aside.map_or(0.0, |(by, _)| by * CELL);
        self.place
            .set(x + by, y, pose.aside.map(|(_, scale)| scale));
        self.gone.toggle(pose.is_gone);
        if let (Some(turn), Some(turns)) = (&self.turn, &self.turns) {
            if let Some(heading) = pose.heading {
                turn.set(&format!("rotate({heading:.0})"));
                turns.set("visible");
            } else {
                turns.set("hidden");
            }
        }
        if let Some([turn, shows]) = &self.aim {
            if let Some(to) = pose.turns_to {
                turn.set(&format!("rotate({to:.0})"));
            }
            shows.set(if pose.turns_to.is_some() {
                "visible"
            } else {
                "hidden"
            });
        }
        for (side, badge) in &self.turning {
            badge.toggle(pose.badge == Some(Badge::Turns(*side)));
        }
        if let (Some(ring), Some(level), Some(charge)) = (&self.ring, &self.level, pose.charge) {
            ring.set(&format!("{:.1} {RING}", charge.share * RING));
            level.set(charge.class());
        }
        if let (Some(charges), Some(waits), Some(broken), Some(badge)) =
            (&self.charges, &self.waits, &self.broken, &self.badge)
        {
            broken.toggle(pose.badge == Some(Badge::Broken));
            charges.toggle(pose.badge == Some(Badge::Charges));
            waits.toggle(pose.badge == Some(Badge::Waits));
            if pose.badge.is_some() {
                // The flag of a goal has the upper right corner.
                let has_flag = cast.has_goal_at(pose.at);
                badge.set(&of_badge(has_flag));
            }
        }
    }
}
