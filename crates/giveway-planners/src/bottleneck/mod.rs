//! Lower bounds by counting: where many agents must pass and only a few can at a time.
//!
//! A passage of one cell's width and a zone with a limit are machines, and the agents that
//! cannot go round them are their jobs: each with an earliest start (*release*), the time that it
//! takes (*work*), and the least time that it needs afterwards (*tail*). The bounds of
//! one-machine scheduling hold for every plan then: the time between the least release and
//! the least tail of some jobs is at least their work (Carlier 1982), and shortest remaining
//! processing time is the least sum of completions where jobs may be interrupted (Schrage 1968). A SAT
//! solver proves the same only by the pigeonhole principle, which takes it exponentially long.
//!
//! Everything that a plan has to keep beside (batteries, other rules, questions) only
//! takes plans away, so the bounds hold with it.

mod cuts;
mod passages;
mod reach;
mod schedule;
#[cfg(test)]
mod tests;
mod turns;
mod zones;

use giveway_model::Cost;

use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::{Problem, Relaxed},
    terrain::Vertex,
};
use schedule::{Machine, Prefer};

/// Where agents have to pass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Gate {
    /// These vertices one after the other, at which no two agents can pass each other.
    Passage(Vec<Vertex>),
    /// The zone of a rule of the scene's own, by its number: so many agents may be in it.
    Zone {
        /// The number of the rule.
        rule: usize,
        /// How many agents may be in the zone at a time.
        most: u32,
    },
}

/// Which way an agent passes a gate; all agents go the same way where that makes no difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Way {
    Forth,
    Back,
}

/// An agent that has to pass a gate.
#[derive(Clone, Copy, Debug)]
struct Job {
    agent: AgentId,
    way: Way,
    /// The earliest time at which it can be in the gate.
    release: u32,
    /// The time points in the gate that it needs, at least; where a machine counts starts, one.
    work: u32,
    /// The least steps from its start in the gate to its arrival, where a machine counts starts;
    /// else from its last time in the gate.
    tail: u32,
}

/// A gate, and the agents that cannot go round it.
#[derive(Clone, Debug)]
pub struct Bottleneck {
    gate: Gate,
    machine: Machine,
    jobs: Vec<Job>,
}

/// A lower bound of a cost, and the bottleneck that shows it.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    /// No plan has less.
    pub at_least: u32,
    /// Why.
    pub bottleneck: &'a Bottleneck,
}

/// The bottlenecks of a problem.
#[derive(Clone, Debug, Default)]
pub struct Bottlenecks(Vec<Bottleneck>);

impl Bottlenecks {
    /// Finds the bottlenecks with most agents, each with at least `fewest`: of few agents the same is
    /// proved quickly in any way. There are none where some agents ignore each other.
    ///
    /// # Errors
    /// When the budget is spent.
    pub fn of(problem: &Problem, fewest: usize, budget: &dyn Budget) -> Result<Self, Stop> {
        if problem.agents() < fewest || problem.relaxed != Relaxed::default() {
            return Ok(Self::default());
        }
        let mut found = passages::find(problem, fewest, budget)?;
        found.extend(zones::find(problem, fewest, budget)?);
        Ok(Self(found))
    }

    /// The largest lower bound of a cost, where one is above what the agents need alone: of all plans, or of those
    /// that have at most a makespan.
    pub fn bound(&self, problem: &Problem, cost: Cost, within: Option<u32>) -> Option<Counted<'_>> {
        let mut best: Option<Counted<'_>> = None;
        let mut known = match cost {
            Cost::Makespan => problem.optima.iter().copied().max().unwrap_or(0),
            Cost::SumOfCosts => {
                let least = (0..problem.agents()).map(|agent| problem.least_cost(agent));
                least.fold(0, u32::saturating_add)
            }
            Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => return None,
        };
        for bottleneck in &self.0 {
            let at_least = match cost {
                Cost::SumOfCosts => bottleneck.sum(problem, within.unwrap_or(u32::MAX)),
                _ => bottleneck.makespan(),
            };
            if at_least > known {
                known = at_least;
                best = Some(Counted {
                    at_least,
                    bottleneck,
                });
            }
        }
        best
    }

    /// A bottleneck whose agents cannot all arrive in time, each by the latest time that is
    /// given for it.
    pub fn too_late(&self, latest: impl Fn(AgentId) -> u32) -> Option<&Bottleneck> {
        self.0.iter().find(|bottleneck| {
            let all = bottleneck.agents().map(&latest).max().unwrap_or(0);
            // What must end sooner has so much more to do afterwards.
            let tail = |job: &Job| job.tail.saturating_add(all - latest(job.agent).min(all));
            bottleneck.machine.span(&bottleneck.jobs, tail) > all
        })
    }
}

impl Bottleneck {
    /// Where it is.
    pub const fn gate(&self) -> &Gate {
        &self.gate
    }

    /// The agents that cannot go round it.
    pub fn agents(&self) -> impl Iterator<Item = AgentId> + '_ {
        self.jobs.iter().map(|job| job.agent)
    }

    /// Its agents in orders in which they pass it when its bound of a cost is met, and a makespan:
    /// who is there first, or who has the farthest to go from there, goes first.
    pub fn orders(&self, cost: Cost, within: Option<u32>) -> [Vec<AgentId>; 2] {
        let is_sum = cost == Cost::SumOfCosts;
        let latest = within.filter(|_| is_sum).unwrap_or(u32::MAX);
        let latest = if is_sum { latest } else { self.makespan() };
        // Where all have to be done by a time, who has most to do must not wait.
        let prefer = if latest < u32::MAX {
            [Prefer::Longest, Prefer::First]
        } else {
            [Prefer::First, Prefer::Longest]
        };
        prefer.map(|prefer| self.machine.order(&self.jobs, latest, is_sum, prefer))
    }

    /// A lower bound of the makespan.
    fn makespan(&self) -> u32 {
        self.machine.span(&self.jobs, |job| job.tail)
    }

    /// A lower bound of the sum of costs: of all jobs, and of those that have no time to
    /// lose on their way to the gate and from there.
    fn sum(&self, problem: &Problem, within: u32) -> u32 {
        let is_tight = |job: &&Job| {
            let way = job.release + job.tail + self.machine.last_point(job.work);
            way >= problem.optima[job.agent]
        };
        let tight: Vec<Job> = self.jobs.iter().filter(is_tight).copied().collect();
        self.sum_of(problem, &self.jobs, within)
            .max(self.sum_of(problem, &tight, within))
    }

    /// The same, of these jobs in the gate and of all other agents alone.
    fn sum_of(&self, problem: &Problem, jobs: &[Job], within: u32) -> u32 {
        let mut is_job = vec![false; problem.agents()];
        let mut sum = self.machine.sum(jobs, within);
        for job in jobs {
            is_job[job.agent] = true;
            let after = u64::from(problem.tasks[job.agent].cost_if_it_leaves_goal);
            sum += u64::from(job.tail) + after;
        }
        for (agent, _) in is_job.iter().enumerate().filter(|(_, is_job)| !**is_job) {
            sum += u64::from(problem.least_cost(agent));
        }
        u32::try_from(sum).unwrap_or(u32::MAX)
    }
}
