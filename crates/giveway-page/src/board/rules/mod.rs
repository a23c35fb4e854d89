//! The rules of the scene's own on the board: zones with signs, lanes, tags at robots and goals.

#[cfg(test)]
mod tests;

use std::rc::Rc;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint};
pub use giveway_picture::{
    KeptShape, LaneShape, RuleShapes, RulesNow, SignKind, TagShape, ZoneShape,
};
use giveway_picture::{LitRule, RuledMap, in_force, kept};

use crate::rules::Lit;
use crate::steering::Steering;
use crate::{Draft, State};

/// Which rules of a draft hold at a time.
pub fn rules_at(draft: &Draft, time: u32) -> RulesNow {
    RulesNow {
        holds: in_force(&draft.scene().constraints, time),
        ..RulesNow::default()
    }
}

/// What of the rules is so at the time shown.
pub fn rules_now(state: &State, draft: &Rc<Draft>) -> RulesNow {
    let time = state.view.playback.time;
    let now = rules_at(draft, time);
    if !Rc::ptr_eq(draft, state.world()) {
        // What is broken, and where robots stay, is told of the plan on the other board.
        return now;
    }
    let broken = crate::rules::broken(state).filter(|violation| Steering::is_now(violation, time));
    let broken = broken.filter_map(|violation| Some(violation.broken.as_ref()?.index as usize));
    let mut broken: Vec<usize> = broken.collect();
    broken.extend(crate::rules::in_clash(state));
    RulesNow {
        broken,
        stays: stays(state, time),
        ..now
    }
}

/// The stays that are made at a time.
fn stays(state: &State, time: u32) -> Vec<(Cell, u32)> {
    let Some(plan) = state.plan() else {
        return Vec::new();
    };
    let scene = state.world().scene();
    let made = giveway_picture::stays(&scene.constraints, &scene.agents, plan).into_iter();
    made.filter_map(|stay| Some((stay.cell, stay.left_at(time)?)))
        .collect()
}

/// The cells that the rule which is looked at, or written, keeps free at the time shown: behind
/// robots, or around them.
pub fn kept_free(state: &State) -> Vec<KeptShape> {
    let scene = state.world().scene();
    let written = state.view.rules.writing.as_deref();
    let written = written.filter(|_| state.is_writing_rule());
    let rule = match (written, state.lit_rule()) {
        (Some(writing), _) => Some(&writing.rule),
        (None, Some(Lit::Rule(index))) => scene.constraints.get(*index),
        (None, Some(Lit::Zone(_)) | None) => None,
    };
    let (Some(rule), Some(plan)) = (rule, state.plan()) else {
        return Vec::new();
    };
    let map = (state.world().grid(), scene.agents.as_slice());
    let time = state.view.playback.time;
    kept(
        rule,
        map,
        |agent| scene.rules.at_end_of(agent),
        (plan, time),
    )
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
