//! Bounds of one-machine scheduling.

use giveway_model::sorting::{sort, sort_by_key};

use super::{Job, Way, turns::Turns};
use crate::AgentId;

/// The releases, and the tails, of which subsets of jobs are looked at.
const MOST_NUMBERS: usize = 64;
/// Time steps over which work is laid out.
const MOST_STEPS: u32 = 1_000_000;

/// Which of the jobs that could come next does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Prefer {
    /// The one that is there first.
    First,
    /// The one with most to do afterwards: it has the farthest to go, past the goals of others.
    Longest,
}

/// What agents are to a gate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Machine {
    /// So many agents may be in it at a time, each for its work.
    Places(u32),
    /// One after the other: the least steps from the start of one to the start of the next.
    Turns {
        /// Where both go the same way.
        same: u32,
        /// Where the first goes forth and the next back, and the other way round.
        opposed: [u32; 2],
    },
}

impl Machine {
    /// How long after its start in the gate the tail of a job begins.
    pub(super) const fn last_point(self, work: u32) -> u32 {
        match self {
            Self::Places(_) => work.saturating_sub(1),
            Self::Turns { .. } => 0,
        }
    }

    /// A lower bound of the time at which the last of some jobs ends with its tail.
    ///
    /// Of all jobs that are released no sooner than one, with tails no shorter than
    /// another's, the first begins no sooner than that, and after the last one comes at least
    /// that tail.
    pub(super) fn span(self, jobs: &[Job], tail: impl Fn(&Job) -> u32) -> u32 {
        let counted = self.counted_span(jobs, &tail);
        match self {
            Self::Places(_) => counted,
            Self::Turns { same, opposed } => {
                let jobs: Vec<Job> = jobs
                    .iter()
                    .map(|job| Job {
                        tail: tail(job),
                        ..*job
                    })
                    .collect();
                Turns::of(&jobs, same, opposed).least_span(counted)
            }
        }
    }

    /// The same from the number of jobs alone.
    fn counted_span(self, jobs: &[Job], tail: &impl Fn(&Job) -> u32) -> u32 {
        let mut span = 0;
        for least in some_of(jobs.iter().map(tail).collect()) {
            let late: Vec<&Job> = jobs.iter().filter(|job| tail(job) >= least).collect();
            for release in some_of(late.iter().map(|job| job.release).collect()) {
                let some = late.iter().filter(|job| job.release >= release);
                let some: Vec<&Job> = some.copied().collect();
                span = span.max(self.span_of(&some, tail));
            }
        }
        span
    }

    fn span_of(self, jobs: &[&Job], tail: &impl Fn(&Job) -> u32) -> u32 {
        let least = |of: &dyn Fn(&Job) -> u32, way: Option<Way>| {
            let some = jobs
                .iter()
                .filter(|job| way.is_none_or(|way| job.way == way));
            some.map(|job| of(job)).min().unwrap_or(0)
        };
        match self {
            Self::Places(most) => {
                let work = jobs.iter().map(|job| u64::from(job.work)).sum::<u64>();
                let steps = work.div_ceil(u64::from(most.max(1))).saturating_sub(1);
                let steps = u32::try_from(steps).unwrap_or(u32::MAX);
                least(&|job| job.release, None)
                    .saturating_add(steps)
                    .saturating_add(least(&|job| tail(job), None))
            }
            Self::Turns { same, opposed } => {
                let forth = jobs.iter().filter(|job| job.way == Way::Forth).count() as u32;
                let back = jobs.len() as u32 - forth;
                let through = |first: Way, last: Way, changes: u32, turning: u32| {
                    let between = (forth + back).saturating_sub(1).saturating_sub(changes);
                    least(&|job| job.release, Some(first))
                        .saturating_add(between.saturating_mul(same))
                        .saturating_add(turning)
                        .saturating_add(least(&|job| tail(job), Some(last)))
                };
                let [to_back, to_forth] = opposed;
                let both = to_back.saturating_add(to_forth);
                if back == 0 {
                    return through(Way::Forth, Way::Forth, 0, 0);
                }
                if forth == 0 {
                    return through(Way::Back, Way::Back, 0, 0);
                }
                let mut least = through(Way::Forth, Way::Back, 1, to_back).min(through(
                    Way::Back,
                    Way::Forth,
                    1,
                    to_forth,
                ));
                if forth > 1 {
                    least = least.min(through(Way::Forth, Way::Forth, 2, both));
                }
                if back > 1 {
                    least = least.min(through(Way::Back, Way::Back, 2, both));
                }
                least
            }
        }
    }

    /// A lower bound of the sum over all jobs of the time after which only the tail is left, where all
    /// end by a time.
    pub(super) fn sum(self, jobs: &[Job], within: u32) -> u64 {
        match self {
            Self::Places(most) => remaining(jobs, most.max(1)),
            Self::Turns { same, opposed } => Turns::of(jobs, same, opposed).least_sum(within).0,
        }
    }

    /// The jobs in an order in which all end by a time; of such orders one in which the sum is
    /// least, where that is asked for.
    pub(super) fn order(
        self,
        jobs: &[Job],
        within: u32,
        is_sum: bool,
        prefer: Prefer,
    ) -> Vec<AgentId> {
        let mut left = jobs.to_vec();
        sort_by_key(&mut left, |job| {
            (job.release.saturating_add(job.work), u32::MAX - job.tail)
        });
        let ways = match self {
            Self::Places(most) => return in_places(left, most, prefer),
            Self::Turns { same, opposed } => {
                let turns = Turns::of(jobs, same, opposed);
                if is_sum {
                    turns.least_sum(within).1
                } else {
                    turns.in_time(within).unwrap_or_default()
                }
            }
        };
        let mut order = Vec::new();
        for (way, start) in ways {
            let mut same = left.iter().enumerate().filter(|(_, job)| job.way == way);
            let next = match prefer {
                Prefer::First => same.next(),
                Prefer::Longest => same
                    .filter(|(_, job)| job.release <= start)
                    .max_by_key(|(place, job)| (job.tail, usize::MAX - place)),
            };
            if let Some((place, _)) = next {
                order.push(left.remove(place).agent);
            }
        }
        order.extend(left.iter().map(|job| job.agent));
        order
    }
}

/// The order in which jobs, sorted by when they could be done, are taken in by so many places.
fn in_places(mut left: Vec<Job>, most: u32, prefer: Prefer) -> Vec<AgentId> {
    let places = (most.max(1) as usize).min(left.len());
    let mut free = vec![0; places];
    let mut order = Vec::new();
    while let Some(first) = left.iter().map(|job| job.release).min() {
        let Some(place) = free.iter_mut().min() else {
            break;
        };
        let now = first.max(*place);
        let mut ready = left.iter().enumerate();
        let next = match prefer {
            Prefer::First => ready.next(),
            Prefer::Longest => ready
                .filter(|(_, job)| job.release <= now)
                .min_by_key(|(place, job)| (job.work, u32::MAX - job.tail, *place)),
        };
        let Some((next, _)) = next else { break };
        let job = left.remove(next);
        *place = now.max(job.release).saturating_add(job.work);
        order.push(job.agent);
    }
    order
}

/// The numbers, ascending and each once; of very many the least and some others.
fn some_of(mut numbers: Vec<u32>) -> Vec<u32> {
    sort(&mut numbers);
    numbers.dedup();
    let step = numbers.len().div_ceil(MOST_NUMBERS).max(1);
    numbers.into_iter().step_by(step).collect()
}

/// Shortest remaining processing time on one machine that does the work of all places: among
/// all schedules with interruptions it has the most jobs done at any time, so the sum of the
/// last times is the least, too.
fn remaining(jobs: &[Job], most: u32) -> u64 {
    let mut left: Vec<(u32, u32)> = jobs.iter().map(|job| (job.release, job.work)).collect();
    sort(&mut left);
    let mut sum = 0;
    let mut now = 0;
    for _ in 0..MOST_STEPS {
        let Some(&(first, _)) = left.first() else {
            return sum;
        };
        now = first.max(now);
        let mut places = most;
        while places > 0 {
            let released = left.iter_mut().filter(|(release, _)| *release <= now);
            let Some((_, work)) = released.min_by_key(|(_, work)| *work) else {
                break;
            };
            let done = places.min(*work);
            *work -= done;
            places -= done;
            if *work == 0 {
                sum += u64::from(now);
                left.retain(|(_, work)| *work > 0);
            }
        }
        now += 1;
    }
    // What is left was not laid out; it ends no sooner than now.
    sum + left.len() as u64 * u64::from(now)
}
