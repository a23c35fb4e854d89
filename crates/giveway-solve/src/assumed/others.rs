//! The same for changes, planners, questions and what all best plans share.
//!
//! These answers hold for the scene as it is posed, which stands beside each of them
//! (`giveway_model::assumption::sentences`); for the problem of the file, nothing is claimed at every
//! horizon.

use giveway_model::{Assumption, Objective, Scene};

use super::{has_chosen, has_left_out, has_unknown, unknown, weaken};
use crate::{
    Reach, Reason,
    change::{ChangeAnswer, Methods},
    delays::DelaysAnswer,
    explain::ExplainAnswer,
    freedom::FreedomAnswer,
    plan::{PlanAnswer, PlanEnd},
    price::PriceAnswer,
};

/// Whether the file's problem may have other plans, or fewer, than the scene.
fn is_other_problem(assumptions: &[Assumption]) -> bool {
    assumptions.iter().any(|one| match one {
        Assumption::GoalsChosen
        | Assumption::RuleLeftOut { .. }
        | Assumption::UnknownKey { .. } => true,
        Assumption::MovingObstacle { .. } => false,
    })
}

/// Weakens the answer to a question.
pub(crate) fn weaken_explained(scene: &Scene, answer: &mut ExplainAnswer) {
    if is_other_problem(&scene.assumptions) {
        answer.reach = Reach::default();
        answer.alone.clear();
        for core in answer.core.iter_mut().flat_map(|core| {
            let further = core.further.iter_mut();
            further.map(|core| &mut core.reach).chain([&mut core.reach])
        }) {
            *core = Reach::default();
        }
    }
}

/// Weakens what is said of all best plans.
pub(crate) fn weaken_freedom(scene: &Scene, answer: &mut FreedomAnswer) {
    if is_other_problem(&scene.assumptions) {
        answer.reach = Reach::default();
    }
}

/// Weakens what every plan is said to lose: a plan of the file's problem may lose less.
pub(crate) fn weaken_delays(scene: &Scene, answer: &mut DelaysAnswer) {
    if is_other_problem(&scene.assumptions) {
        answer.prove_nothing();
    }
}

/// Weakens the prices of rules: with the rules of the file's problem they may be others.
pub(crate) fn weaken_priced(scene: &Scene, answer: &mut PriceAnswer) {
    if is_other_problem(&scene.assumptions) {
        answer.reach = Reach::default();
        for price in &mut answer.prices {
            price.exact = false;
        }
    }
}

/// Weakens what methods make of a change, each as a search for a plan.
pub(crate) fn weaken_changed(scene: &Scene, objective: &Objective, answer: &mut ChangeAnswer) {
    let weaken_all = |methods: &mut Methods| {
        for (_, method) in &mut methods.0 {
            weaken((&scene.assumptions, objective), &mut method.result);
        }
    };
    for step in &mut answer.history {
        weaken_all(&mut step.methods);
    }
    weaken_all(&mut answer.methods);
}

/// Weakens what a planner came to.
pub(crate) fn weaken_planned(scene: &Scene, answer: &mut PlanAnswer) {
    let assumptions = &scene.assumptions;
    let is_unknown = has_unknown(assumptions);
    match answer.ended {
        PlanEnd::Best { .. } if is_unknown || has_left_out(assumptions) => {
            answer.ended = PlanEnd::Found;
        }
        PlanEnd::Alone { .. } if is_unknown => {
            let reason = unknown(assumptions);
            answer.ended = PlanEnd::Stopped { reason };
        }
        PlanEnd::Alone { .. } if has_chosen(assumptions) => {
            let reason = Reason::ChosenGoals;
            answer.ended = PlanEnd::Stopped { reason };
        }
        PlanEnd::Best { .. }
        | PlanEnd::Alone { .. }
        | PlanEnd::Found
        | PlanEnd::NoOrderWorks { .. }
        | PlanEnd::Stopped { .. }
        | PlanEnd::Horizon { .. }
        | PlanEnd::Refused { .. } => {}
    }
    if is_unknown {
        answer.bounds.clear();
    }
}
