//! How soon agents can be through a gate, by schedules of one machine.

use std::collections::BTreeMap;

use super::{Job, Pace};

/// More steps are not laid out.
const MOST_STEPS: u32 = 1_000_000;

/// The least sum over all jobs of the times at which only their tails are left, where all end
/// within a time.
pub(super) fn sum(jobs: &[Job], pace: Pace, within: Option<u32>) -> u64 {
    match pace {
        Pace::Places(most) => shortest_first(jobs, most),
        Pace::Apart { same, towards } => {
            let latest = latest(jobs, within.unwrap_or(u32::MAX)).unwrap_or_default();
            let allowed = |way: usize, number: usize, start: u32| {
                latest[way]
                    .get(number)
                    .is_some_and(|&latest| start <= latest)
            };
            let ends = starts(jobs, (same, towards), &allowed, false);
            ends.into_iter().map(|(_, sum)| sum).min().unwrap_or(0)
        }
    }
}

/// Whether the jobs may all end with their tails by a time.
pub(super) fn fits(jobs: &[Job], pace: Pace, by: u32) -> bool {
    match pace {
        Pace::Places(most) => {
            // The work of those that come late and have far to go needs its time between.
            jobs.iter().all(|first| {
                jobs.iter().all(|last| {
                    let (release, tail) = (first.release, last.tail);
                    let some = jobs.iter();
                    let some = some.filter(|job| job.release >= release && job.tail >= tail);
                    let work: u64 = some.map(|job| u64::from(job.work)).sum();
                    let steps = work.div_ceil(u64::from(most));
                    work == 0 || u64::from(release) + steps + u64::from(tail) <= u64::from(by) + 1
                })
            })
        }
        Pace::Apart { same, towards } => {
            // Of all of them, and of those that come late and have far to go.
            jobs.iter().all(|first| {
                jobs.iter().all(|last| {
                    let (release, tail) = (first.release, last.tail);
                    let some = jobs.iter();
                    let some = some.filter(|job| job.release >= release && job.tail >= tail);
                    let some: Vec<Job> = some.copied().collect();
                    some.is_empty() || follow(&some, (same, towards), by)
                })
            })
        }
    }
}

/// Whether jobs can start one after the other so that all end by a time.
fn follow(jobs: &[Job], apart: (u32, [u32; 2]), by: u32) -> bool {
    let Some(latest) = latest(jobs, by) else {
        return false;
    };
    let allowed = |way: usize, number: usize, start: u32| {
        latest[way]
            .get(number)
            .is_some_and(|&latest| start <= latest)
    };
    !starts(jobs, apart, &allowed, true).is_empty()
}

/// The latest starts of both kinds, ascending, where all jobs end by a time: the k-th start of a kind is not
/// before the k-th release, and not after the k-th of these.
fn latest(jobs: &[Job], by: u32) -> Option<[Vec<u32>; 2]> {
    let mut latest = [Vec::new(), Vec::new()];
    for job in jobs {
        latest[job.way].push(by.checked_sub(job.tail)?);
    }
    for latest in &mut latest {
        latest.sort_unstable();
    }
    Some(latest)
}

/// Most jobs are done at each time where the shortest one is gone on with, the work of all
/// places on any of them.
fn shortest_first(jobs: &[Job], most: u32) -> u64 {
    let mut waiting: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for job in jobs {
        waiting.entry(job.release).or_default().push(job.work);
    }
    let mut open: Vec<u32> = Vec::new();
    let mut sum = 0;
    let mut now = 0;
    for _ in 0..MOST_STEPS {
        if open.is_empty() {
            match waiting.first_key_value() {
                Some((&release, _)) => now = release.max(now),
                None => return sum,
            }
        }
        while let Some(entry) = waiting.first_entry().filter(|entry| *entry.key() <= now) {
            open.extend(entry.remove());
        }
        open.sort_unstable_by(|a, b| b.cmp(a));
        let mut places = most;
        while places > 0
            && let Some(work) = open.last_mut()
        {
            let done = places.min(*work);
            *work -= done;
            places -= done;
            if *work == 0 {
                open.pop();
                sum += u64::from(now);
            }
        }
        now += 1;
    }
    0
}

/// How many of both ways have started, and which way the last one went.
type Progress = (usize, usize, usize);

/// The last start and the sum of starts, each not beaten in both, of all orders in which all
/// jobs start; where only times matter, the soonest alone.
fn starts(
    jobs: &[Job],
    (same, towards): (u32, [u32; 2]),
    allowed: &dyn Fn(usize, usize, u32) -> bool,
    only_time: bool,
) -> Vec<(u32, u64)> {
    let mut releases = [Vec::new(), Vec::new()];
    for job in jobs {
        releases[job.way].push(job.release);
    }
    for of in &mut releases {
        of.sort_unstable();
    }
    let [forth, back] = [releases[0].len(), releases[1].len()];
    let mut known: BTreeMap<Progress, Vec<(u32, u64)>> = BTreeMap::new();
    for one in 0..=forth {
        for other in 0..=back {
            for way in 0..2 {
                let done = [one, other];
                let Some(number) = done[way].checked_sub(1) else {
                    continue;
                };
                let before = if way == 0 {
                    (number, other)
                } else {
                    (one, number)
                };
                let mut ends: Vec<(u32, u64)> = Vec::new();
                let mut add = |start: u32, sum: u64| {
                    if allowed(way, number, start) {
                        ends.push((start, sum + u64::from(start)));
                    }
                };
                let release = releases[way][number];
                if before == (0, 0) {
                    add(release, 0);
                }
                for (last, &apart) in towards.iter().enumerate() {
                    let apart = if last == way { same } else { apart };
                    for &(start, sum) in
                        known.get(&(before.0, before.1, last)).into_iter().flatten()
                    {
                        add(release.max(start + apart), sum);
                    }
                }
                ends.sort_unstable();
                let mut best: Vec<(u32, u64)> = Vec::new();
                for end in ends {
                    if best.last().is_none_or(|best| end.1 < best.1 && !only_time) {
                        best.push(end);
                    }
                }
                known.insert((one, other, way), best);
            }
        }
    }
    let all = (0..2).flat_map(|way| known.remove(&(forth, back, way)).unwrap_or_default());
    all.collect()
}
