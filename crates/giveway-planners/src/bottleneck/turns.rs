//! Jobs of two kinds one after the other, by dynamic programming.
//!
//! How soon the next job may start depends on the kinds of both alone. So among jobs of one kind
//! two can change places, and it is enough to know how many of each kind have started.

use std::rc::Rc;

use giveway_model::sorting::sort;

use super::{Job, Way};

/// The entries of a list of times and sums that are kept apart; more are joined, which only makes
/// a bound lower.
const MOST_ENTRIES: usize = 64;

/// The jobs, and the least steps from one start to the next.
pub(super) struct Turns {
    /// When jobs of each kind can start, and how long their tails are; both in ascending order by
    /// themselves.
    releases: [Vec<u32>; 2],
    tails: [Vec<u32>; 2],
    same: u32,
    opposed: [u32; 2],
}

/// The kinds of jobs in order, each with its start.
pub(super) type Starts = Vec<(Way, u32)>;

/// Some jobs have started: the last one then, the sum of all starts, and the order.
#[derive(Clone)]
struct Entry {
    last: u32,
    sum: u64,
    order: Option<Rc<Start>>,
}

struct Start {
    way: Way,
    at: u32,
    before: Option<Rc<Start>>,
}

/// The entries by the kind of the last job.
type Entries = [Vec<Entry>; 2];

impl Turns {
    pub(super) fn of(jobs: &[Job], same: u32, opposed: [u32; 2]) -> Self {
        let sorted = |way: Way, of: &dyn Fn(&Job) -> u32| {
            let some = jobs.iter().filter(|job| job.way == way);
            let mut some: Vec<u32> = some.map(of).collect();
            sort(&mut some);
            some
        };
        let both = |of: &dyn Fn(&Job) -> u32| [sorted(Way::Forth, of), sorted(Way::Back, of)];
        Self {
            releases: both(&|job| job.release),
            tails: both(&|job| job.tail),
            same,
            opposed,
        }
    }

    /// The least sum of starts where all jobs end by a time, with an order; nothing where they
    /// cannot.
    pub(super) fn least_sum(&self, within: u32) -> (u64, Starts) {
        let in_time = |kind, number, start| self.is_in_time((kind, number, start), within);
        let ends = self.starts(in_time, best_of);
        let best = ends.into_iter().min_by_key(|entry| entry.sum);
        best.map_or((0, Vec::new()), |best| (best.sum, best.starts()))
    }

    /// Whether a job of a kind may start at a time when all have to end by another: the k-th of a
    /// kind does not start before the k-th release, nor after the latest start that is k-th in order.
    fn is_in_time(&self, (kind, number, start): (usize, usize, u32), within: u32) -> bool {
        let tails: &Vec<u32> = &self.tails[kind];
        let tail = tails
            .len()
            .checked_sub(number + 1)
            .and_then(|i| tails.get(i));
        tail.is_some_and(|tail| start.saturating_add(*tail) <= within)
    }

    /// The least time, from one on, by which all jobs may have ended with their tails.
    pub(super) fn least_span(&self, from: u32) -> u32 {
        let longest = self.opposed.iter().copied().fold(self.same, u32::max);
        let jobs = self.releases.iter().map(Vec::len).sum::<usize>();
        let all = longest.saturating_mul(u32::try_from(jobs).unwrap_or(u32::MAX));
        // (It is never so much later: then all can start one after the other.)
        (from..from.saturating_add(all))
            .find(|&span| self.in_time(span).is_some())
            .unwrap_or(from)
    }

    /// An order in which all jobs may end with their tails by a time.
    pub(super) fn in_time(&self, span: u32) -> Option<Starts> {
        let in_time = |kind, number, start| self.is_in_time((kind, number, start), span);
        let soonest = |entries: Vec<Entry>| {
            let soonest = entries.into_iter().min_by_key(|entry| entry.last);
            soonest.into_iter().collect()
        };
        let ends = self.starts(in_time, soonest);
        ends.first().map(Entry::starts)
    }

    /// The entries after all jobs: `allow` says whether the job of a kind with a number may start
    /// at a time, `keep` which entries are worth to go on from.
    fn starts(
        &self,
        allow: impl Fn(usize, usize, u32) -> bool,
        keep: impl Fn(Vec<Entry>) -> Vec<Entry>,
    ) -> Vec<Entry> {
        let [forth, back] = &self.releases;
        let next = |kind: usize, number: usize, before: Option<&Entries>, is_first: bool| {
            let release = *self.releases[kind].get(number)?;
            let mut entries = Vec::new();
            if is_first && allow(kind, number, release) {
                entries.push(Entry::first(kind, release));
            }
            for (last, list) in before?.iter().enumerate() {
                let apart = if last == kind {
                    self.same
                } else {
                    self.opposed[last]
                };
                for entry in list {
                    let at = release.max(entry.last.saturating_add(apart));
                    entries.extend(allow(kind, number, at).then(|| entry.then(kind, at)));
                }
            }
            Some(keep(entries))
        };
        // After so many forth, by how many back.
        let mut row: Vec<Entries> = Vec::new();
        for i in 0..=forth.len() {
            let mut entries: Vec<Entries> = Vec::with_capacity(back.len() + 1);
            for j in 0..=back.len() {
                let is_first = i + j == 1;
                let go = i
                    .checked_sub(1)
                    .and_then(|i| next(0, i, row.get(j), is_first));
                let come = j
                    .checked_sub(1)
                    .and_then(|j| next(1, j, entries.last(), is_first));
                entries.push([go.unwrap_or_default(), come.unwrap_or_default()]);
            }
            row = entries;
        }
        row.pop().into_iter().flatten().flatten().collect()
    }
}

/// The way of a kind.
const fn way(kind: usize) -> Way {
    match kind {
        0 => Way::Forth,
        _ => Way::Back,
    }
}

impl Entry {
    fn first(kind: usize, at: u32) -> Self {
        let start = Start {
            way: way(kind),
            at,
            before: None,
        };
        Self {
            last: at,
            sum: u64::from(at),
            order: Some(Rc::new(start)),
        }
    }

    fn then(&self, kind: usize, at: u32) -> Self {
        let start = Start {
            way: way(kind),
            at,
            before: self.order.clone(),
        };
        Self {
            last: at,
            sum: self.sum + u64::from(at),
            order: Some(Rc::new(start)),
        }
    }

    fn starts(&self) -> Starts {
        let mut starts = Vec::new();
        let mut order = &self.order;
        while let Some(start) = order {
            starts.push((start.way, start.at));
            order = &start.before;
        }
        starts.reverse();
        starts
    }
}

/// The entries that no other one is better than: later ones have a smaller sum.
fn best_of(mut entries: Vec<Entry>) -> Vec<Entry> {
    giveway_model::sorting::sort_by_key(&mut entries, |entry| (entry.last, entry.sum));
    let mut best: Vec<Entry> = Vec::new();
    for entry in entries {
        if best.last().is_none_or(|best| entry.sum < best.sum) {
            best.push(entry);
        }
    }
    while best.len() > MOST_ENTRIES {
        let joined = best.chunks(2).filter_map(|pair| {
            let (first, last) = (pair.first()?, pair.last()?);
            Some(Entry {
                last: first.last,
                ..last.clone()
            })
        });
        best = joined.collect();
    }
    best
}
