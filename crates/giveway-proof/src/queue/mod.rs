//! Claims that rest on counting: agents that have to pass where only so many can be at a time.
//!
//! Where the agents cannot go round some cells, they need their time there one after the other,
//! whatever else a plan does. Gates, times and schedules are worked out here once more, from the map and
//! the rules, and shared with no solver. The bounds are those of one-machine scheduling (Carlier
//! 1982; Schrage 1968).

mod gates;
mod jobs;
mod schedule;

use giveway_model::{Cost, Instance};

use crate::Budget;
use gates::Gate;
use jobs::{Job, jobs};

/// What is counted at one gate.
struct Counted {
    jobs: Vec<Job>,
    pace: Pace,
}

/// How quickly agents get through a gate.
#[derive(Clone, Copy, Debug)]
enum Pace {
    /// So many are in it at a time, each for its work.
    Places(u32),
    /// One starts after the other: so many steps after one that goes the same way, and after one of
    /// each way that comes towards it.
    Apart { same: u32, towards: [u32; 2] },
}

/// Whether counting at some gate with at least `fewest` agents shows that a plan costs at least so
/// much, of makespan or sum of costs, if its makespan is at most `within`; `None` where the
/// budget ran out.
///
/// ```
/// use giveway_model::{Cost, format::native};
/// use giveway_proof::{Budget, queue::counted_at_least};
/// let instance = native::read_instance(r##"{ "giveway": 1, "map": ["..#..", ".....", "..#.."],
///     "agents": [{ "name": "a", "start": [0, 1], "goal": [4, 1] },
///                { "name": "b", "start": [0, 0], "goal": [4, 0] },
///                { "name": "c", "start": [0, 2], "goal": [4, 2] }] }"##).unwrap();
/// // They are in the gap at times 2, 3 and 4.
/// let shows = |bound| counted_at_least(&instance, (Cost::Makespan, bound), None, 2, &Budget::default());
/// assert_eq!((shows(7), shows(8)), (Some(true), Some(false)));
/// ```
pub fn counted_at_least(
    instance: &Instance,
    (cost, bound): (Cost, u32),
    within: Option<u32>,
    fewest: usize,
    budget: &Budget<'_>,
) -> Option<bool> {
    let sum = match cost {
        Cost::Makespan => false,
        Cost::SumOfCosts => true,
        Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => return Some(false),
    };
    let gates = gates::all(instance, fewest, budget)?;
    let alone = jobs::alone(instance, budget)?;
    for gate in gates {
        for counted in jobs(instance, &gate, budget)? {
            if counted.jobs.len() < fewest {
                continue;
            }
            let least = if sum {
                counted.sum(&alone, within)
            } else {
                counted.makespan(bound)
            };
            if least >= u64::from(bound) {
                return Some(true);
            }
        }
    }
    Some(false)
}

impl Counted {
    /// The sum of costs at least: of the agents at the gate, and of all others alone. Those that have time to
    /// lose on their way are counted alone, too, where that is more.
    fn sum(&self, alone: &[u32], within: Option<u32>) -> u64 {
        let of = |jobs: &[Job]| {
            let others = alone.iter().enumerate();
            let others = others.filter(|(agent, _)| jobs.iter().all(|job| job.agent != *agent));
            let others: u64 = others.map(|(_, &least)| u64::from(least)).sum();
            let tails: u64 = jobs.iter().map(|job| u64::from(job.tail)).sum();
            schedule::sum(jobs, self.pace, within) + tails + others
        };
        let direct = self.jobs.iter().filter(|job| {
            let inside = match self.pace {
                Pace::Places(_) => job.work.saturating_sub(1),
                Pace::Apart { .. } => 0,
            };
            job.release + inside + job.tail >= alone[job.agent]
        });
        let direct: Vec<Job> = direct.copied().collect();
        of(&self.jobs).max(of(&direct))
    }

    /// The makespan at least, as far as it matters for a bound.
    fn makespan(&self, bound: u32) -> u64 {
        let Some(last) = bound.checked_sub(1) else {
            return 0;
        };
        let late = !schedule::fits(&self.jobs, self.pace, last);
        if late { u64::from(bound) } else { 0 }
    }
}
