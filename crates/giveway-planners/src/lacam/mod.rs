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
mod rewire;
mod search;
#[cfg(test)]
mod tests;
mod trace;

pub use explored::ConfigurationId;
pub use trace::{Event, Made, Trace};

use search::Search;

use crate::{
    budget::{Budget, Stop},
    pibt::Guide,
    plain::{Plain, Unsupported},
    problem::Problem,
    walk::Walk,
};

/// Steps to a first plan, beside four times the longest way, after which a guide
/// is given up.
const PATIENCE: u64 = 1_000;

/// How to search.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Configurations to make at the most, known ones and failures included.
    pub step_limit: u64,
    /// Whether agents keep clear of oncoming traffic, on ways chosen before. That
    /// makes the first plan of a large crowd much cheaper.
    pub guided: bool,
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

/// The result of the search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The last plan, which is the best one.
    pub best: Option<Found>,
    /// Why it ended.
    pub ended: Ended,
    /// The configurations that were made, known ones and failures included.
    pub steps: u64,
    /// The first steps of the search that ended it.
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
    let mut best = None;
    let mut tell = |found: &Found| {
        on_plan(found);
        best = Some(found.clone());
    };
    let (ended, steps, trace) =
        guided(&plain, options, budget, &mut tell).unwrap_or_else(|before| {
            let mut search = Search::new(&plain, None, options, budget);
            search.steps = before;
            let ended = search.run(&mut tell);
            (ended, search.steps, search.trace)
        });
    Ok(Report {
        best,
        ended,
        steps,
        trace,
    })
}

/// The search with a guide.
///
/// # Errors
/// The steps after which it was given up: with a guide, agents find a plan
/// soon or block each other for long.
fn guided(
    plain: &Plain,
    options: Options,
    budget: &dyn Budget,
    tell: &mut dyn FnMut(&Found),
) -> Result<(Ended, u64, Trace), u64> {
    if !options.guided {
        return Err(0);
    }
    let guide = match Guide::new(plain, budget) {
        Ok(guide) => guide.ok_or(0u64)?,
        Err(stop) => return Ok((Ended::Stopped(stop), 0, Trace::default())),
    };
    let mut search = Search::new(plain, Some(&guide), options, budget);
    let starts = plain.starts().iter().enumerate();
    let longest = starts.map(|(agent, &v)| plain.distance(agent, v)).max();
    search.patience = PATIENCE + 4 * u64::from(longest.unwrap_or(0));
    let ended = search.run(tell);
    match ended {
        Ended::StepLimit if search.steps < options.step_limit => Err(search.steps),
        _ => Ok((ended, search.steps, search.trace)),
    }
}
