//! The rules of the scene's own on the board: zones with signs, lanes, tags at robots and goals.

mod tab;
mod tags;
#[cfg(test)]
mod tests;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Scene};

use super::shade::outline;
use crate::rules::{Lit, zone_of};
use crate::{Draft, State};
use tab::{Spot, folded, tab, times};
use tags::place;

/// How far an outline stays inside of its cells, and that of a zone around others, in units.
const INSET: i64 = 5;
const AROUND: i64 = 3;

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
#[derive(Clone, Debug, PartialEq)]
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
}

/// Which rules hold at a time.
pub fn now(scene: &Scene, time: u32) -> Vec<bool> {
    let holds = |rule: &Constraint| {
        let mut kind = rule.kind.clone();
        let times = crate::rules::parts(&mut kind).times.map(|times| *times);
        !rule.off && times.is_none_or(|times| times.contains(time))
    };
    scene.constraints.iter().map(holds).collect()
}

/// Which signs of rules are on the board: zones, limits, closed zones, lanes.
pub(super) fn signs(state: &State) -> [bool; 4] {
    let scene = state.world().scene();
    let holds = now(scene, state.view.playback.time);
    let rules = || scene.constraints.iter().zip(&holds);
    let has = |is: fn(&Constraint, bool) -> bool| rules().any(|(rule, &holds)| is(rule, holds));
    let most = has(|rule, _| !rule.off && matches!(rule.kind, ConstraintKind::Capacity { .. }));
    let closed = has(|rule, holds| holds && matches!(rule.kind, ConstraintKind::Closed { .. }));
    let lane =
        rules().any(|(rule, _)| !rule.off && matches!(rule.kind, ConstraintKind::OneWay { .. }));
    [!scene.zones.is_empty(), most, closed, lane]
}

/// What the rules of a draft put on the board; which of them hold now, and which is lit.
pub fn rule_shapes(draft: &Draft, holds: &[bool], lit: Option<&Lit>) -> RuleShapes {
    let scene = draft.scene();
    let mut shapes = RuleShapes::default();
    let mut taken: Vec<Spot> = Vec::new();
    for zone in &scene.zones {
        let cells = zone.cell_set();
        let is_around = scene.zones.iter().any(|other| {
            other.name != zone.name && other.cells().all(|cell| cells.contains(&cell))
        });
        let rules = || {
            let rules = scene.constraints.iter().enumerate();
            rules.filter(|(_, rule)| zone_of(&rule.kind) == Some(&zone.name))
        };
        let is_closed = rules().any(|(index, rule)| {
            let is_it = matches!(rule.kind, ConstraintKind::Closed { .. });
            is_it && holds.get(index).copied().unwrap_or(false)
        });
        let tab = tab(draft, zone, &cells, &taken);
        taken.push(tab);
        shapes.zones.push(ZoneShape {
            name: zone.name.clone(),
            path: outline(&cells, if is_around { AROUND } else { INSET }),
            tab: tab.at,
            signs: folded(rules().map(|(_, rule)| rule)),
            times: rules().find_map(|(_, rule)| times(rule)),
            is_closed,
            is_lit: rules().any(|(index, _)| lit == Some(&Lit::Rule(index)))
                || lit == Some(&Lit::Zone(zone.name.clone())),
        });
    }
    for (index, rule) in scene.constraints.iter().enumerate() {
        let is_lit = lit == Some(&Lit::Rule(index));
        if !rule.off || is_lit {
            place(draft, rule, is_lit, &mut shapes);
        }
    }
    shapes
}
