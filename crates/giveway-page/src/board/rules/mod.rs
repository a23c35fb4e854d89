//! The rules of the scene's own on the board: zones with signs, lanes, tags at robots and goals.

mod tab;
mod tags;
#[cfg(test)]
mod tests;

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Scene};

use super::shade::outline;
use crate::rules::{Lit, zone_of};
use crate::steering::Steering;
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
}

/// What of the rules changes with the time shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RulesNow {
    /// Which rules hold.
    pub holds: Vec<bool>,
    /// Which rules are broken, by their indices.
    pub broken: Vec<usize>,
    /// Where a robot makes a stay that a rule asks for, with how many steps of it are left.
    pub stays: Vec<(Cell, u32)>,
}

/// What of the rules is so at the time shown.
pub fn rules_now(state: &State) -> RulesNow {
    let (scene, time) = (state.world().scene(), state.view.playback.time);
    let broken = crate::rules::broken(state).filter(|violation| Steering::is_now(violation, time));
    let broken = broken.filter_map(|violation| Some(violation.broken.as_ref()?.index as usize));
    RulesNow {
        holds: now(scene, time),
        broken: broken.collect(),
        stays: stays(state, time),
    }
}

/// The stays that are made at a time.
fn stays(state: &State, time: u32) -> Vec<(Cell, u32)> {
    let Some(plan) = state.plan() else {
        return Vec::new();
    };
    let scene = state.world().scene();
    let rules = scene.constraints.iter().filter(|rule| !rule.off);
    let made = rules.flat_map(|rule| {
        let ConstraintKind::Visit { cell, stay, times } = &rule.kind else {
            return Vec::new();
        };
        let names = rule.agents.as_ref();
        let agents = scene.agents.iter();
        let bound = agents.filter(|agent| names.is_none_or(|names| names.contains(&agent.name)));
        let left = |agent: &giveway_model::Agent| {
            let path = plan.path(&agent.name);
            let end = first_stay(path, *cell, *stay, *times)? + stay;
            (time <= end && time + stay >= end).then_some((*cell, end - time))
        };
        bound
            .filter_map(left)
            .filter(|(_, left)| *left > 0)
            .collect()
    });
    made.collect()
}

/// When the first stay of so many steps begins at a cell that lies within some times.
fn first_stay(path: &[Option<Cell>], cell: Cell, stay: u32, times: Times) -> Option<u32> {
    let mut begun = None;
    for (at, time) in path.iter().zip(0_u32..) {
        if *at != Some(cell) || !times.contains(time) {
            begun = None;
            continue;
        }
        let first = *begun.get_or_insert(time);
        if time - first >= stay {
            return Some(first);
        }
    }
    // It rests there: the path ends, the stay goes on.
    begun.filter(|_| path.last() == Some(&Some(cell)))
}

/// Which rules hold at a time.
pub(super) fn now(scene: &Scene, time: u32) -> Vec<bool> {
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

/// What the rules of a draft put on the board; what is so of them now, and which is lit.
pub fn rule_shapes(draft: &Draft, now: &RulesNow, lit: Option<&Lit>) -> RuleShapes {
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
            is_it && now.holds.get(index).copied().unwrap_or(false)
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
            is_broken: rules().any(|(index, _)| now.broken.contains(&index)),
        });
    }
    for (index, rule) in scene.constraints.iter().enumerate() {
        let is_lit = lit == Some(&Lit::Rule(index));
        if !rule.off || is_lit {
            place(
                draft,
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
        });
    }
    shapes
}
