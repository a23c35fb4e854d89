//! Whether a plan is a plan of a scene with other rules, too.

use std::rc::Rc;

use giveway_model::check::check;
use giveway_model::{Constraint, Instance, Scene};
use giveway_solve::SolveRequest;

use super::zone_of;
use crate::course::Course;
use crate::{Answer, Draft};

/// The answer in another scene, which has the same robots on the same map, where its plan is a
/// plan there and all that was proved of it holds: each rule that is in force here is in force
/// there, too, and the plan keeps those that came. `None` elsewhere. No claim is about units.
pub(crate) fn kept(answer: &Answer, draft: &Rc<Draft>) -> Option<Answer> {
    if !keeps(answer, draft.scene()) {
        return None;
    }
    // A zone alone forbids nothing, and what was proved of fewer rules holds for more.
    let request = Rc::new(SolveRequest {
        scene: draft.scene().clone(),
        ..(*answer.request).clone()
    });
    // The worlds of a course are told in the units of its scene.
    let course = answer.course.as_deref().map(|course| {
        let plan = answer.plan()?;
        let (changes, steps) = (course.changes.clone(), course.steps.clone());
        Course::new(draft.instance().ok()?, draft.scene(), changes, steps, plan).ok()
    });
    let course = match course {
        Some(course) => Some(Rc::new(course?)),
        None => None,
    };
    Some(Answer {
        draft: Rc::clone(draft),
        request,
        course,
        ..answer.clone()
    })
}

fn keeps(answer: &Answer, scene: &Scene) -> bool {
    let before = answer.draft.scene();
    let measured = Scene {
        units: before.units,
        ..scene.clone()
    };
    if measured == *before {
        return true;
    }
    let rest = Scene {
        zones: before.zones.clone(),
        constraints: before.constraints.clone(),
        ..measured
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
