//! Turns that take a step, out of plans whose robots turn: a rule of the scene, with where
//! each robot faces at first.

use std::collections::BTreeMap;

use super::ForeignPlan;
use crate::Heading;
use giveway_model::constraint::{self, ConstraintKind};
use giveway_model::{Assumption, Constraint, Instance, LeftOutRule};

/// The assumption that turns take no step.
const TURNING: Assumption = Assumption::RuleLeftOut {
    rule: LeftOutRule::Turning,
};

/// Makes turns a rule of the scene, where all plans turn and agree on where robots face at
/// first. Else they are left out, as the assumption says.
pub(super) fn settle(instance: Instance, plans: &[ForeignPlan]) -> Instance {
    if !instance.assumptions().contains(&TURNING) {
        return instance;
    }
    let Some(headings) = headings(plans) else {
        return instance;
    };
    let mut scene = instance.to_scene();
    scene.assumptions.retain(|one| *one != TURNING);
    let mut turning = Vec::new();
    for agent in &mut scene.agents {
        if let Some(&heading) = headings.get(agent.name.as_str()) {
            agent.heading = Some(heading);
            turning.push(agent.name.clone());
        }
    }
    let all = turning.len() == scene.agents.len();
    scene.constraints.push(rule((!all).then_some(turning)));
    Instance::new(scene).unwrap_or(instance)
}

/// A quarter turn takes a step.
fn rule(agents: Option<Vec<String>>) -> Constraint {
    Constraint {
        kind: ConstraintKind::Turns { quarter: 1 },
        agents,
        name: None,
        off: false,
    }
}

/// Where robots face at first; `None` where a plan does not turn, or plans do not agree.
fn headings(plans: &[ForeignPlan]) -> Option<BTreeMap<&str, constraint::Heading>> {
    let mut all = BTreeMap::new();
    for plan in plans {
        if plan.headings.is_empty() {
            return None;
        }
        for (name, looks) in &plan.headings {
            let first = direction(*looks.first()?);
            if *all.entry(name.as_str()).or_insert(first) != first {
                return None;
            }
        }
    }
    (!all.is_empty()).then_some(all)
}

/// A direction as scenes write it: in both `y` grows downwards.
const fn direction(heading: Heading) -> constraint::Heading {
    match heading {
        Heading::East => constraint::Heading::East,
        Heading::South => constraint::Heading::South,
        Heading::West => constraint::Heading::West,
        Heading::North => constraint::Heading::North,
    }
}
