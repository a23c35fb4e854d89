//! Whether a plan is a plan of a scene with other rules, too.

use giveway_model::check::check;
use giveway_model::{Constraint, Instance, Scene};

use super::zone_of;
use crate::Answer;

/// Whether the plan of an answer is a plan of another scene, which has the same robots on the
/// same map, and whether all that was proved of it holds there: each rule that is in force
/// here is in force there, too, and the plan keeps those that came.
pub(crate) fn keeps(answer: &Answer, scene: &Scene) -> bool {
    let before = answer.draft.scene();
    let rest = Scene {
        zones: before.zones.clone(),
        constraints: before.constraints.clone(),
        // No claim is about them.
        units: before.units,
        ..scene.clone()
    };
    let (Some(plan), true) = (answer.plan(), rest == *before) else {
        return false;
    };
    if answer.course.is_some() || answer.by.is_some() {
        return false;
    }
    let cells = |scene: &Scene, name: &str| {
        let zone = scene.zones.iter().find(|zone| zone.name == name)?;
        Some(zone.cell_set())
    };
    let mut came: Vec<&Constraint> = scene.constraints.iter().filter(|rule| !rule.off).collect();
    for rule in before.constraints.iter().filter(|rule| !rule.off) {
        let is_it = |other: &&Constraint| other.kind == rule.kind && other.agents == rule.agents;
        let Some(place) = came.iter().position(is_it) else {
            return false;
        };
        let zone = zone_of(&rule.kind);
        if zone.is_some_and(|zone| cells(before, zone) != cells(scene, zone)) {
            return false;
        }
        came.swap_remove(place);
    }
    let has_penalty = came.iter().any(|rule| rule.is_penalty());
    let is_valid = |instance: &Instance| check(instance, plan).is_valid();
    !has_penalty && Instance::new(scene.clone()).is_ok_and(|instance| is_valid(&instance))
}
