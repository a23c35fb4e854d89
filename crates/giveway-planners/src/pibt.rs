//! PIBT: priority inheritance with backtracking (Okumura et al. 2019, 2022).
//!
//! All agents move at once, a step at a time, and nobody looks further ahead
//! than the next step, so hundreds of agents take milliseconds. It is neither
//! complete nor best: agents may get stuck in front of each other for good.

mod buckets;
mod guide;
mod priorities;
mod step;
mod swap;
#[cfg(test)]
mod tests;

pub use step::Inheritance;
pub(crate) use {
    guide::Guide,
    priorities::{Priorities, Ranks},
    step::Step,
};

use crate::{
    AgentId,
    budget::{Budget, Stop},
    plain::{Plain, Unsupported},
    problem::Problem,
    terrain::Vertex,
    walk::Walk,
};

/// How to plan.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Steps after which whoever is on its way is called stuck.
    pub step_limit: u32,
    /// How many inheritances are told, and of how many steps the leader; 0 for none.
    pub told: usize,
}

/// How it ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All have arrived.
    Plan(Vec<Walk>),
    /// The step limit was reached, and so many were at their goals. There may be
    /// a plan all the same.
    Stuck(usize),
    /// The budget was spent.
    Stopped(Stop),
}

/// The result of PIBT.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// How it ended.
    pub outcome: Outcome,
    /// The steps that were made.
    pub steps: u32,
    /// The first inheritances, each with the time at which its step begins.
    pub inherited: Vec<(u32, Inheritance)>,
    /// The agent of the highest priority in each step, of the first steps.
    pub leaders: Vec<AgentId>,
}

/// The seed of the choices among equals.
const SEED: u64 = 19;

/// Plans by PIBT.
///
/// # Errors
/// What the problem has beside starts and goals.
pub fn pibt(
    problem: &Problem,
    options: Options,
    budget: &dyn Budget,
) -> Result<Report, Unsupported> {
    let plain = Plain::new(problem)?;
    let mut report = Report {
        outcome: Outcome::Stuck(0),
        steps: 0,
        inherited: Vec::new(),
        leaders: Vec::new(),
    };
    report.outcome = run(&plain, options, budget, &mut report).unwrap_or_else(Outcome::Stopped);
    Ok(report)
}

fn run(
    plain: &Plain,
    options: Options,
    budget: &dyn Budget,
    report: &mut Report,
) -> Result<Outcome, Stop> {
    let mut step = Step::new(plain, None, SEED, options.told > 0);
    let ranks = Ranks::new(plain);
    let mut priorities = Priorities::first(&ranks);
    let mut held = budget.hold(0);
    let mut configurations: Vec<Box<[Vertex]>> = vec![plain.starts().into()];
    loop {
        budget.spend(plain.agents() as u64)?;
        let now = configurations.last().map_or(&[][..], |last| last);
        let arrived = now.iter().zip(plain.goals()).filter(|(v, goal)| v == goal);
        let arrived = arrived.count();
        if arrived == plain.agents() {
            let configurations: Vec<&[Vertex]> =
                configurations.iter().map(|cells| &**cells).collect();
            return Ok(Outcome::Plan(plain.walks(&configurations)));
        }
        if report.steps == options.step_limit {
            return Ok(Outcome::Stuck(arrived));
        }
        step.begin(now);
        step.choose(&priorities.order);
        let room = options.told - report.inherited.len();
        let inherited = step.inherited().iter().take(room);
        let time = report.steps;
        if report.leaders.len() < options.told {
            let first = priorities.order.first();
            report.leaders.extend(first.map(|&agent| agent as AgentId));
        }
        report.inherited.extend(inherited.map(|&told| (time, told)));
        report.steps += 1;
        priorities = priorities.after(&ranks, step.next(), plain.goals());
        budget.hold_more(&mut held, size_of_val(step.next()));
        configurations.push(step.next().into());
    }
}
