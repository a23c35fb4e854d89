//! The rules of the scene's own on the board: zones with signs, lanes, tags at robots and goals.

use std::collections::BTreeSet;

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Cell, Constraint, Ground, Scene, tr};

use super::shade::outline;
use crate::rules::{Lit, zone_of};
use crate::{Draft, State};

/// So many signs stand beside each other; more fold into one with their number.
const SIGNS: usize = 3;
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
    let mut taken: Vec<(f64, f64)> = Vec::new();
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
        let tab = tab(draft, &cells, &taken);
        taken.push(tab);
        shapes.zones.push(ZoneShape {
            name: zone.name.clone(),
            path: outline(&cells, if is_around { AROUND } else { INSET }),
            tab,
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

/// The signs of the rules of a zone.
fn folded<'a>(rules: impl Iterator<Item = &'a Constraint>) -> Vec<SignKind> {
    let signs: Vec<SignKind> = rules.filter(|rule| !rule.off).filter_map(sign).collect();
    if signs.is_empty() {
        return vec![SignKind::Dot];
    }
    if signs.len() > SIGNS {
        return vec![SignKind::Ring(format!("+{}", signs.len()))];
    }
    signs
}

fn sign(rule: &Constraint) -> Option<SignKind> {
    Some(match &rule.kind {
        ConstraintKind::Capacity { most, .. } => SignKind::Ring(most.to_string()),
        ConstraintKind::Closed { .. } => SignKind::Bar,
        ConstraintKind::NoWaiting { .. } => SignKind::Pause,
        ConstraintKind::Avoid { weight, .. } => SignKind::Triangle(weight.to_string()),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Turns { .. } => return None,
    })
}

/// The times of a rule of a zone, where it does not always hold.
fn times(rule: &Constraint) -> Option<String> {
    let mut kind = rule.kind.clone();
    let times = *crate::rules::parts(&mut kind).times?;
    match (times.first(), meant(times).to) {
        _ if rule.off => None,
        (0, None) => None,
        (from, None) => Some(format!("{from}\u{2013}")),
        (from, Some(to)) => Some(format!("{from}\u{2013}{to}")),
    }
}

/// Where the tab of a zone begins: on an obstacle that touches it or is part of it, where no
/// robot covers it; else on its upper edge, or on its lower one.
fn tab(draft: &Draft, cells: &BTreeSet<Cell>, taken: &[(f64, f64)]) -> (f64, f64) {
    let grid = draft.grid();
    let is_obstacle = |cell: Cell| grid.ground(cell) == Some(Ground::Obstacle);
    let at =
        |x: u32, y: u32, by: (f64, f64)| (f64::from(x) * 100.0 + by.0, f64::from(y) * 100.0 + by.1);
    let mut by_row: Vec<Cell> = cells.iter().copied().collect();
    by_row.sort_by_key(|cell| (cell.y, cell.x));
    let inside = by_row.iter().filter(|&&cell| is_obstacle(cell));
    let beside = by_row.iter().filter(|cell| {
        let right = Cell::new(cell.x + 1, cell.y);
        !cells.contains(&right) && is_obstacle(right)
    });
    let upper = by_row.first().filter(|cell| cell.y > 0);
    let places = inside
        .map(|cell| at(cell.x, cell.y, (22.0, 32.0)))
        .chain(beside.map(|cell| at(cell.x + 1, cell.y, (3.0, 28.0))))
        .chain(upper.map(|cell| at(cell.x, cell.y, (22.0, -20.0))))
        .chain(
            by_row
                .last()
                .map(|cell| at(cell.x, cell.y + 1, (22.0, -5.0))),
        );
    let is_free = |place: &(f64, f64)| {
        taken
            .iter()
            .all(|other| (other.0 - place.0).abs() > 180.0 || (other.1 - place.1).abs() > 40.0)
    };
    let places: Vec<(f64, f64)> = places.collect();
    let free = places.iter().copied().find(is_free);
    free.or(places.first().copied()).unwrap_or((0.0, 0.0))
}

/// Puts the lane or the tags of a rule on the board.
fn place(draft: &Draft, rule: &Constraint, is_lit: bool, shapes: &mut RuleShapes) {
    let scene = draft.scene();
    let bound = || {
        let names = rule.agents.as_deref();
        let agents = scene.agents.iter();
        agents.filter(move |agent| names.is_none_or(|names| names.contains(&agent.name)))
    };
    let tag = |cell, text: String, class, is_above| TagShape {
        cell,
        text,
        class,
        is_above,
    };
    match &rule.kind {
        ConstraintKind::OneWay { lane } => shapes.lanes.push(LaneShape {
            borders: lane.windows(2).filter_map(border).collect(),
            is_lit,
        }),
        ConstraintKind::Arrive { times } => {
            let Some((text, class)) = arrival(*times) else {
                return;
            };
            let goals = bound().filter_map(|agent| agent.goal);
            shapes
                .tags
                .extend(goals.map(|goal| tag(goal, text.clone(), class, false)));
        }
        ConstraintKind::Late { by, .. } => {
            let text = tr!("a tag on the board" => "by {time}", time = by);
            let goals = bound().filter_map(|agent| agent.goal);
            shapes
                .tags
                .extend(goals.map(|goal| tag(goal, text.clone(), "late", false)));
        }
        ConstraintKind::Depart { from } => {
            let text = tr!("a tag on the board" => "from {time}", time = from);
            let starts = bound().map(|agent| agent.start);
            shapes
                .tags
                .extend(starts.map(|start| tag(start, text.clone(), "early", false)));
        }
        ConstraintKind::Sequence { cells, .. } => {
            let numbered = cells.iter().zip(1_u32..);
            shapes
                .tags
                .extend(numbered.map(|(&cell, n)| tag(cell, n.to_string(), "order", true)));
        }
        ConstraintKind::Visit { cell, stay, .. } => {
            let text = tr!("a tag on the board" => "stay {steps}", steps = stay);
            shapes.tags.push(tag(*cell, text, "stay", true));
        }
        ConstraintKind::Before { first, second } if is_lit => {
            shapes.tags.extend([
                tag(first.cell, "1".to_owned(), "order", true),
                tag(second.cell, "2".to_owned(), "order", false),
            ]);
        }
        // Zones have signs; the others show nothing on the map.
        ConstraintKind::Before { .. }
        | ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => {}
    }
}

fn arrival(times: Times) -> Option<(String, &'static str)> {
    match (times.from, meant(times).to) {
        (Some(from), Some(by)) => Some((format!("{from}\u{2013}{by}"), "late")),
        (None, Some(by)) => Some((tr!("a tag on the board" => "by {time}", time = by), "late")),
        (Some(from), None) => Some((
            tr!("a tag on the board" => "from {time}", time = from),
            "early",
        )),
        (None, None) => None,
    }
}

/// The middle of the border between two cells, and the direction over it.
fn border(step: &[Cell]) -> Option<(u32, u32, u32)> {
    let [from, to] = step else { return None };
    let degrees = match (to.x.cmp(&from.x), to.y.cmp(&from.y)) {
        (std::cmp::Ordering::Greater, _) => 0,
        (_, std::cmp::Ordering::Greater) => 90,
        (std::cmp::Ordering::Less, _) => 180,
        (_, _) => 270,
    };
    let middle = |a: u32, b: u32| 50 * (a + b + 1);
    Some((middle(from.x, to.x), middle(from.y, to.y), degrees))
}
