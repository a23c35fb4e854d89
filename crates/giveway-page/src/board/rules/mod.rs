//! The rules of the scene's own on the board: zones with signs, lanes, tags at robots and goals.

#[cfg(test)]
mod tests;

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint};
pub use giveway_picture::{LaneShape, RuleShapes, RulesNow, SignKind, TagShape, ZoneShape};
use giveway_picture::{LitRule, RuledMap, in_force};

use crate::rules::Lit;
use crate::steering::Steering;
use crate::{Draft, State};

/// What of the rules is so at the time shown.
pub fn rules_now(state: &State) -> RulesNow {
    let (scene, time) = (state.world().scene(), state.view.playback.time);
    let broken = crate::rules::broken(state).filter(|violation| Steering::is_now(violation, time));
    let broken = broken.filter_map(|violation| Some(violation.broken.as_ref()?.index as usize));
    RulesNow {
        holds: in_force(&scene.constraints, time),
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

/// Which signs of rules are on the board: zones, limits, closed zones, lanes.
pub(super) fn signs(state: &State) -> [bool; 4] {
    let scene = state.world().scene();
    let holds = in_force(&scene.constraints, state.view.playback.time);
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
    let map = RuledMap {
        grid: draft.grid(),
        zones: &scene.zones,
        rules: &scene.constraints,
        agents: &scene.agents,
    };
    let lit = match lit {
        None => LitRule::default(),
        Some(Lit::Rule(index)) => LitRule {
            rule: Some(*index),
            zone: None,
        },
        Some(Lit::Zone(name)) => LitRule {
            rule: None,
            zone: Some(name),
        },
    };
    giveway_picture::rule_shapes(map, now, lit)
}
