//! What stays proved when rules are added to a scene.

use std::collections::BTreeMap;

use giveway_model::{Cost, Scene};

use crate::{Answer, Document};

/// The least that every plan of the scene on the board costs, by the proof of a plan that stood
/// before rules were added. A rule takes plans away and adds none, so the bound of the first cost
/// of the objective stays; that of a later one holds only where the earlier ones are as before.
pub(super) fn bounds(document: &Document) -> BTreeMap<Cost, u32> {
    let first = document.draft.scene().objective.costs().first();
    let known = document.answer.as_deref().filter(|answer| {
        let reach = answer.proved_here();
        let is_complete = reach.is_some_and(giveway_solve::Reach::is_complete);
        is_complete && only_adds_rules(answer, document.draft.scene())
    });
    let least = known.and_then(|answer| {
        let &first = first?;
        Some((first, answer.solved.costs?.get(first)))
    });
    least.into_iter().collect()
}

/// Whether a scene is that of an answer, but for rules that it has beside those of the answer's.
fn only_adds_rules(answer: &Answer, scene: &Scene) -> bool {
    let before = answer.draft.scene();
    let rules = scene.constraints.iter().filter(|rule| !rule.off);
    let mut rules: Vec<_> = rules.collect();
    let mut kept = before.constraints.iter().filter(|rule| !rule.off);
    let keeps_rules = kept.all(|rule| {
        let place = rules.iter().position(|it| *it == rule);
        place.map(|place| rules.swap_remove(place)).is_some()
    });
    // Zones mean nothing but in rules, and one that a rule names must be the same.
    let has_zones = before.zones.iter().all(|zone| scene.zones.contains(zone));
    let like_before = Scene {
        constraints: scene.constraints.clone(),
        zones: scene.zones.clone(),
        ..before.clone()
    };
    keeps_rules && has_zones && like_before == *scene
}
