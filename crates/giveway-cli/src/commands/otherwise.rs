//! By which other rule of the problem an illegal plan is legal.

use giveway_model::{AtGoal, Instance, Plan, check::check};
use giveway_solve::Refusal;

use super::refused;
use crate::failure::Failure;

/// That a plan which breaks a rule is legal by another rule about robots at their goals, or with
/// a lower battery floor, a sentence.
pub(super) fn otherwise(instance: &Instance, plan: &Plan) -> Option<String> {
    let is_legal = |change: &dyn Fn(&mut giveway_model::Rules)| {
        let mut scene = instance.to_scene();
        change(&mut scene.rules);
        Instance::new(scene).is_ok_and(|instance| check(&instance, plan).is_valid())
    };
    let (other, sentence) = match instance.rules().at_goal {
        AtGoal::Stay => (
            AtGoal::Vanish,
            "The plan is legal where robots vanish at their goals: --at-goal vanish judges it so.",
        ),
        AtGoal::Vanish => (
            AtGoal::Stay,
            "The plan is legal where robots stay at their goals: --at-goal stay judges it so.",
        ),
    };
    if is_legal(&|rules| rules.at_goal = other) {
        return Some(sentence.to_owned());
    }
    let floor = instance.rules().battery_floor;
    let legal_at = |floor: u32| is_legal(&|rules| rules.battery_floor = floor);
    if floor == 0 || !legal_at(0) {
        return None;
    }
    // A plan is legal with every floor below one with which it is legal.
    let (mut low, mut high) = (0, floor);
    while low + 1 < high {
        let middle = low + (high - low) / 2;
        if legal_at(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(format!(
        "The plan is legal with a battery floor of {low} or less, and the floor is {floor} here: --floor {low} judges it so."
    ))
}

/// A refusal of the service, with the rule by which the plan would have been legal.
pub(super) fn refused_plan(
    refusal: Refusal,
    file: &std::path::Path,
    (instance, plan): (&Instance, Option<&Plan>),
) -> Failure {
    let hint = plan
        .filter(|_| matches!(refusal, Refusal::Plan { .. }))
        .and_then(|plan| otherwise(instance, plan));
    match (refused(refusal, file), hint) {
        (Failure::Refused(mut sentences), Some(hint)) => {
            sentences.insert(0, hint);
            Failure::Refused(sentences)
        }
        (failure, _) => failure,
    }
}
