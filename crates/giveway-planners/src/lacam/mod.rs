//! LaCAM and LaCAM*: lazy constraints addition search (Okumura 2023).
//!
//! A search over configurations (where all agents are at one time), depth
//! first. A configuration has very many successors; they are made one at a
//! time, by PIBT under few constraints, which become more only when it is looked
//! at again. That is complete, and mostly goes straight to a plan. LaCAM* goes
//! on: whenever a known configuration is reached at less cost, what follows it
//! is rewired, so that in time the plan has the least sum of losses (an agent
//! loses a step whenever it is not at its goal before and after it).

mod constraints;
mod explored;
mod search;
#[cfg(test)]
mod tests;
mod trace;

pub use explored::ConfigurationId;
pub use trace::{Event, Made, Trace};

use crate::{
    budget::{Budget, Stop},
    plain::{Plain, Unsupported},
    problem::Problem,
    walk::Walk,
};

/// How to search.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Configurations to make at the most, known ones and failures included.
    pub step_limit: u64,
    /// Whether the first plan ends it (LaCAM), or it goes on (LaCAM*).
    pub first_only: bool,
    /// How many steps the trace tells; 0 for none.
    pub told: usize,
}

/// A plan that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// The walks, one an agent.
    pub walks: Vec<Walk>,
    /// Its sum of losses: its sum of costs but for the steps that agents rest at
    /// their goals before they leave them again.
    pub loss: u64,
    /// The steps of the search up to it.
    pub steps: u64,
}

/// The proof that no plan exists in which agents stay at their goals: every
/// configuration that can be reached was found. Only the search makes it. It
/// says nothing of plans in which agents vanish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhausted(());

impl Exhausted {
    /// No configuration is open, and none is the goal.
    const fn configurations() -> Self {
        Self(())
    }
}

/// Why the search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// With the first plan, as was asked for.
    FirstPlan,
    /// No plan in which agents stay has a smaller sum of losses than the last one.
    LeastLoss,
    /// There is no plan in which agents stay.
    Exhausted(Exhausted),
    /// The step limit was reached; what was not found may exist.
    StepLimit,
    /// The budget was spent; what was not found may exist.
    Stopped(Stop),
}

/// What the search did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The last plan, which is the best one.
    pub best: Option<Found>,
    /// Why it ended.
    pub ended: Ended,
    /// The configurations that were made, known ones and failures included.
    pub steps: u64,
    /// Its first steps.
    pub trace: Trace,
}

/// Plans by LaCAM. Each plan is told as soon as it is found; each has a smaller
/// sum of losses than the one before.
///
/// # Errors
/// What the problem has beside starts and goals.
pub fn lacam(
    problem: &Problem,
    options: Options,
    budget: &dyn Budget,
    on_plan: &mut dyn FnMut(&Found),
) -> Result<Report, Unsupported> {
    let plain = Plain::new(problem)?;
    let mut search = search::Search::new(&plain, options, budget);
    let mut best = None;
    let ended = search.run(&mut |found| {
        on_plan(found);
        best = Some(found.clone());
    });
    Ok(Report {
        best,
        ended,
        steps: search.steps,
        trace: search.trace,
    })
}
