//! The rules of a scene's own as shapes: zones with signs, lanes, tags at robots and goals.

mod kept;
mod kind;
mod stays;
mod tab;
mod tab_parts;
mod tags;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Grid, Instance, Zone};

use crate::outline::around;
use tab::{Spot, folded, tab, times};
use tags::place;

pub use kept::{KeptShape, kept};
pub use kind::{in_force, zone_of};
pub use stays::{Stay, first_stay, stays};
pub use tab_parts::{TabParts, TabWords, tab_parts};

/// How far an outline stays inside of its cells, and that of a zone around others, in units.
const INSET: i64 = 5;
const AROUND: i64 = 3;

/// A map with the rules on it.
#[derive(Clone, Copy, Debug)]
pub struct RuledMap<'a> {
    /// The map.
    pub grid: &'a Grid,
    /// The zones.
    pub zones: &'a [Zone],
    /// The rules.
    pub rules: &'a [Constraint],
    /// The agents.
    pub agents: &'a [Agent],
}

impl<'a> RuledMap<'a> {
    /// That of an instance.
    pub fn of(instance: &'a Instance) -> Self {
        Self {
            grid: instance.grid(),
            zones: instance.zones(),
            rules: instance.constraints(),
            agents: instance.agents(),
        }
    }
}

/// What rules put on the board.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RuleShapes {
    /// The zones.
    pub zones: Vec<ZoneShape>,
    /// The one-way lanes.
    pub lanes: Vec<LaneShape>,
    /// The tags of deadlines, starts, stops.
    pub tags: Vec<TagShape>,
}

/// A zone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ZoneShape {
    /// Its name.
    pub name: String,
    /// Its outline.
    pub path: String,
    /// Where its tab begins, in units.
    pub tab: (f64, f64),
    /// The signs on its tab.
    pub signs: Vec<SignKind>,
    /// The times of its rules, where one has some: `12–15`.
    pub times: Option<String>,
    /// Whether it is closed at the time shown.
    pub is_closed: bool,
    /// Whether it is lit.
    pub is_lit: bool,
    /// Whether one of its rules is broken at the time shown.
    pub is_broken: bool,
}

/// A sign of a zone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SignKind {
    /// A ring with a number: at most so many.
    Ring(String),
    /// A ring with a bar: no entry; full while that is in force.
    Bar,
    /// A ring with a struck pause: no waiting.
    Pause,
    /// A triangle with a number: better not.
    Triangle(String),
    /// No rule of the zone is in force.
    Dot,
}

/// A one-way lane.
#[derive(Clone, Debug, PartialEq)]
pub struct LaneShape {
    /// The middle of each border that it crosses, in units, and where it leads: degrees from
    /// east, clockwise.
    pub borders: Vec<(u32, u32, u32)>,
    /// Whether it is lit.
    pub is_lit: bool,
    /// Whether it is broken at the time shown.
    pub is_broken: bool,
}

/// A tag at a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TagShape {
    /// The cell.
    pub cell: Cell,
    /// What stands on it: `by 12`.
    pub text: String,
    /// At which end its bar is: not later (`late`), not before (`early`); or `order`, `stay`.
    pub class: &'static str,
    /// Whether it stands above the middle of the cell; else below.
    pub is_above: bool,
    /// Whether its rule is broken at the time shown, or one of those that leave no plan.
    pub is_broken: bool,
}

impl TagShape {
    /// Where its middle is in its cell, in units: the number of a stop has a corner of its
    /// own, the others stand at an edge.
    pub fn place(&self) -> (f64, f64) {
        match (self.class, self.is_above) {
            ("order", true) => (17.0, 18.0),
            ("order", false) => (17.0, 82.0),
            (_, true) => (50.0, 14.0),
            (_, false) => (50.0, 88.0),
        }
    }

    /// How wide its words are set, in units.
    pub fn words_width(&self) -> f64 {
        self.text.chars().count() as f64 * 11.0
    }
}

/// What of the rules changes with the time shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RulesNow {
    /// Which rules hold.
    pub holds: Vec<bool>,
    /// Which rules are broken, or leave no plan, by their indices.
    pub broken: Vec<usize>,
    /// Where a robot makes a stay that a rule asks for, with how many steps of it are left.
    pub stays: Vec<(Cell, u32)>,
}

/// The rule or the zone that is lit.
#[derive(Clone, Copy, Debug, Default)]
pub struct LitRule<'a> {
    /// The rule, by its index in the scene.
    pub rule: Option<usize>,
    /// The zone, by its name.
    pub zone: Option<&'a str>,
}

/// The shapes of rules; what is so of them now, and which is lit.
pub fn rule_shapes(map: RuledMap<'_>, now: &RulesNow, lit: LitRule<'_>) -> RuleShapes {
    let mut shapes = RuleShapes::default();
    let mut taken: Vec<Spot> = Vec::new();
    for zone in map.zones {
        let cells = zone.cell_set();
        let is_around = map.zones.iter().any(|other| {
            other.name != zone.name && other.cells().all(|cell| cells.contains(&cell))
        });
        let rules = || {
            let rules = map.rules.iter().enumerate();
            rules.filter(|(_, rule)| zone_of(&rule.kind) == Some(&zone.name))
        };
        let is_closed = rules().any(|(index, rule)| {
            let is_it = matches!(rule.kind, ConstraintKind::Closed { .. });
            is_it && now.holds.get(index).copied().unwrap_or(false)
        });
        let tab = tab(map, zone, &cells, &taken);
        taken.push(tab);
        shapes.zones.push(ZoneShape {
            name: zone.name.clone(),
            path: around(&cells, if is_around { AROUND } else { INSET }),
            tab: tab.at,
            signs: folded(rules().map(|(_, rule)| rule)),
            times: rules().find_map(|(_, rule)| times(rule)),
            is_closed,
            is_lit: rules().any(|(index, _)| lit.rule == Some(index))
                || lit.zone == Some(zone.name.as_str()),
            is_broken: rules().any(|(index, _)| now.broken.contains(&index)),
        });
    }
    for (index, rule) in map.rules.iter().enumerate() {
        let is_lit = lit.rule == Some(index);
        if !rule.off || is_lit {
            place(
                map,
                rule,
                [is_lit, now.broken.contains(&index)],
                &mut shapes,
            );
        }
    }
    for &(cell, left) in &now.stays {
        // It counts down in the place of what is asked for.
        shapes
            .tags
            .retain(|tag| tag.class != "stay" || tag.cell != cell);
        shapes.tags.push(TagShape {
            cell,
            text: left.to_string(),
            class: "stay now",
            is_above: true,
            is_broken: false,
        });
    }
    shapes
}
