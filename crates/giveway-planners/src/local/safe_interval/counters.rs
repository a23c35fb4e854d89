//! What an agent counts on its way, from one arrival at a vertex to the next.
//!
//! A label stands for all times from its arrival to the end of a safe interval. So the counts in
//! its mask are those of the arrival, and what is counted while the agent stands follows from the
//! time that has gone by: how far it has turned, and whether a stay was made. A stay that
//! is under way has the count 0; one that was made is a label of its own. An agent that has to
//! arrive by entering counts as one that has waited ([`Counter::Entry`]), but in labels at
//! which its walk ends.

use crate::{
    single::{Act, Bounds, Counter, Mask, Passage, Place, Stay, Task},
    terrain::{Arc, Terrain, Vertex},
};
use giveway_model::Cost;

/// The counters of one agent.
pub(super) struct Counters<'a> {
    task: &'a Task,
    terrain: &'a Terrain,
    has_stays: bool,
    has_limits_on_waits: bool,
    /// The earliest time at which it may enter its goal for good, where that is asked for.
    pub(super) entry: Option<u32>,
}

impl<'a> Counters<'a> {
    /// The counters of a task; `None` where it has something that safe intervals do not tell.
    pub(super) fn of(task: &'a Task, terrain: &'a Terrain) -> Option<Self> {
        let conditions = &task.conditions;
        let mut counters = Self {
            task,
            terrain,
            has_stays: false,
            has_limits_on_waits: false,
            entry: None,
        };
        for counter in &conditions.counters {
            match counter {
                Counter::Sequence(_)
                | Counter::Turns(_)
                | Counter::Visited(_)
                | Counter::Order(..) => {}
                Counter::Stay(stay) if stay.begun == 0 => counters.has_stays = true,
                Counter::Entry(entry) if !entry.stood && !entry.may_stay => {
                    counters.entry = counters.entry.max(Some(entry.from));
                }
                Counter::LongWait(wait)
                    if wait.times.are_all() && wait.begun == 0 && wait.held == 0 =>
                {
                    counters.has_limits_on_waits = true;
                }
                // What began before time 0 is counted step by step.
                Counter::Stay(_) | Counter::Entry(_) | Counter::LongWait(_) | Counter::Left(_) => {
                    return None;
                }
            }
        }
        let is_told = conditions
            .forbidden
            .iter()
            .all(|forbidden| forbidden.unless == 0 && !matches!(forbidden.act, Act::Charge(_)));
        let has_only_deadlines = conditions.limits.keys().all(|&cost| cost == Cost::Makespan);
        let fits = is_told
            && has_only_deadlines
            && conditions.required.is_empty()
            && task.reserve.is_none()
            && task.transit.is_none()
            && matches!(task.bounds, Bounds::Free);
        fits.then_some(counters)
    }

    /// A mask at time 0 as that of a label.
    pub(super) fn first(&self, mask: Mask) -> Option<Mask> {
        self.each(mask, |counter, count| match counter {
            Counter::Stay(stay) if !stay.is_done(count) => 0,
            _ => count,
        })
    }

    fn each(&self, mask: Mask, mut next: impl FnMut(&Counter, u32) -> u32) -> Option<Mask> {
        let conditions = &self.task.conditions;
        conditions.counted(mask, |counter, count| Some(next(counter, count)))
    }

    /// The mask after a move, as far as it does not depend on its time, and the steps for
    /// which the agent stands before it; `None` where the move is forbidden.
    pub(super) fn moved(&self, mask: Mask, from: Vertex, arc: Arc) -> Option<(Mask, u32)> {
        let bit = self.task.bit(arc.to);
        if self.task.conditions.counters.is_empty() {
            return Some((mask | bit, 0));
        }
        let passage = Passage {
            from: Place::At(from),
            to: Place::At(arc.to),
            heading: self.terrain.heading_between(from, arc.to),
            now: 0,
        };
        let mut stands = 0;
        let conditions = &self.task.conditions;
        let mask = conditions.counted(mask, |counter, count| match counter {
            Counter::LongWait(_) => Some(0),
            Counter::Stay(stay) => Some(if stay.is_done(count) { count } else { 0 }),
            Counter::Entry(_) => Some(1),
            Counter::Turns(turns) => {
                stands = stands.max(turns.stands_before(count, passage.heading));
                Some(turns.after_move(passage.heading))
            }
            Counter::Sequence(_) | Counter::Visited(_) | Counter::Order(..) | Counter::Left(_) => {
                counter.next(count, passage)
            }
        })?;
        Some((mask | bit, stands))
    }

    /// The mask once it has arrived at a vertex at a time: stays of no time step are made.
    pub(super) fn arrived(&self, mask: Mask, v: Vertex, time: u32) -> Mask {
        if !self.has_stays {
            return mask;
        }
        let made = self.each(mask, |counter, count| match counter {
            Counter::Stay(stay) if stay.at == v && stay.steps == 0 && stay.times.contains(time) => {
                stay.done()
            }
            _ => count,
        });
        made.unwrap_or(mask)
    }

    /// The stays that were not made.
    fn stays(&self, mask: Mask) -> impl Iterator<Item = &Stay> {
        let counts = self.task.conditions.counts_in(mask);
        counts.filter_map(|(counter, count)| match counter {
            Counter::Stay(stay) => (!stay.is_done(count)).then_some(stay),
            _ => None,
        })
    }

    /// Whether a stay cannot be made any more by an agent that is at a vertex since a time.
    pub(super) fn is_too_late(&self, mask: Mask, since: u32) -> bool {
        self.has_stays && self.stays(mask).any(|stay| made_at(stay, since).is_none())
    }

    /// When the stays at a vertex are made by an agent that is there since a time, each with
    /// the mask then, in the order of time.
    pub(super) fn stays_at(&self, mask: Mask, v: Vertex, since: u32) -> Vec<(u32, Mask)> {
        if !self.has_stays {
            return Vec::new();
        }
        let here = self.stays(mask).filter(|stay| stay.at == v);
        let mut times: Vec<u32> = here.filter_map(|stay| made_at(stay, since)).collect();
        times.retain(|&time| time > since);
        times.sort_unstable();
        times.dedup();
        let after = |time: u32| {
            let mask = self.each(mask, |counter, count| match counter {
                Counter::Stay(stay)
                    if stay.at == v && made_at(stay, since).is_some_and(|made| made <= time) =>
                {
                    stay.done()
                }
                Counter::Turns(turns) => turns.after_standing(count, time - since),
                Counter::Entry(_) => 1,
                Counter::Stay(_)
                | Counter::LongWait(_)
                | Counter::Sequence(_)
                | Counter::Visited(_)
                | Counter::Left(_)
                | Counter::Order(..) => count,
            });
            mask.map(|mask| (time, mask))
        };
        times.into_iter().filter_map(after).collect()
    }

    /// The most steps for which it may wait on end at a vertex, where there is a limit.
    pub(super) fn most_waits(&self, v: Vertex) -> Option<u32> {
        if !self.has_limits_on_waits {
            return None;
        }
        let counters = self.task.conditions.counters.iter();
        let limits = counters.filter_map(|counter| match counter {
            Counter::LongWait(wait) => wait.counts(v, 0).then(|| wait.steps.saturating_sub(1)),
            _ => None,
        });
        limits.min()
    }

    /// A time that no arrival is before, as far as stays say.
    pub(super) fn least_arrival(&self, mask: Mask) -> u32 {
        if !self.has_stays {
            return 0;
        }
        let ends = self.stays(mask).map(|stay| {
            let first = stay.times.first();
            if stay.rests {
                0
            } else {
                first.saturating_add(stay.steps)
            }
        });
        ends.max().unwrap_or(0)
    }

    /// The mask of an agent that enters its goal for good, and the first time at which it
    /// may.
    pub(super) fn entering(&self, mask: Mask) -> Option<(Mask, u32)> {
        let from = self.entry?;
        let passing = self.stays(mask).filter(|stay| !stay.rests);
        let first = passing.map(|stay| stay.times.first()).max();
        let mask = self.each(mask, |counter, count| match counter {
            Counter::Entry(_) => 0,
            _ => count,
        });
        mask.map(|mask| (mask, from.max(first.unwrap_or(0))))
    }

    /// Whether counts allow an agent to arrive at a vertex where it is since a time.
    pub(super) fn may_end(&self, mask: Mask, v: Vertex, (since, arrival): (u32, u32)) -> bool {
        let counts = &mut self.task.conditions.counts_in(mask);
        counts.all(|(counter, count)| match counter {
            Counter::Stay(stay) => {
                stay.is_done(count) || stay.rests && stay.at == v && made_at(stay, since).is_some()
            }
            Counter::Sequence(_)
            | Counter::Turns(_)
            | Counter::Entry(_)
            | Counter::LongWait(_)
            | Counter::Visited(_)
            | Counter::Left(_)
            | Counter::Order(..) => counter.may_end(count, v, arrival),
        })
    }
}

/// When a stay is made by an agent that is there since a time, if that is in time.
fn made_at(stay: &Stay, since: u32) -> Option<u32> {
    let made = since.max(stay.times.first()).saturating_add(stay.steps);
    (made <= stay.times.last()).then_some(made)
}
