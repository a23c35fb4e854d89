//! PIBT and LaCAM behind the one door: planners of hundreds of agents.

use super::{Asked, Best, Halt, Outcome, Report, Trace};
use crate::{
    budget::Budget,
    lacam::{self, Ended},
    pibt,
};

/// Events that a trace tells.
const TOLD: usize = 1_000;
/// Times the horizon, where nobody limits the makespan: PIBT makes detours.
const PATIENCE: u32 = 4;
/// Configurations after which LaCAM* goes on no more.
const CONFIGURATIONS: u64 = 200_000;

const fn told(asked: &Asked) -> usize {
    if asked.traced { TOLD } else { 0 }
}

/// Plans a step at a time.
pub(super) fn pibt(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let patient = asked.default_horizon.saturating_mul(PATIENCE);
    let options = pibt::Options {
        step_limit: asked.within.unwrap_or(patient),
        told: told(asked),
    };
    let made = match pibt::pibt(asked.problem, options, budget) {
        Ok(made) => made,
        Err(unsupported) => return Report::refused(unsupported.into()),
    };
    let outcome = match made.outcome {
        pibt::Outcome::Plan(walks) => {
            best.offer(&walks);
            Outcome::found(best)
        }
        pibt::Outcome::Stuck(arrived) => {
            let steps = made.steps;
            Outcome::stopped(Halt::Stuck { arrived, steps }, best)
        }
        pibt::Outcome::Stopped(stop) => Outcome::stopped(Halt::Budget(stop), best),
    };
    Report {
        outcome,
        steps: u64::from(made.steps),
        trace: asked.traced.then_some(Trace::Pibt {
            inherited: made.inherited,
            leaders: made.leaders,
        }),
    }
}

/// Plans by a search over configurations.
pub(super) fn lacam(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let options = lacam::Options {
        step_limit: CONFIGURATIONS,
        guided: true,
        first_only: false,
        told: told(asked),
    };
    let mut on_plan = |found: &lacam::Found| best.offer(&found.walks);
    let searched = match lacam::lacam(asked.problem, options, budget, &mut on_plan) {
        Ok(searched) => searched,
        Err(unsupported) => return Report::refused(unsupported.into()),
    };
    let outcome = match searched.ended {
        Ended::Stopped(stop) => Outcome::stopped(Halt::Budget(stop), best),
        // That there is no plan at all is left to other proofs.
        Ended::FirstPlan | Ended::LeastLoss | Ended::StepLimit | Ended::Exhausted(_) => {
            Outcome::found(best)
        }
    };
    Report {
        outcome,
        steps: searched.steps,
        trace: asked.traced.then_some(Trace::Lacam(searched.trace)),
    }
}
