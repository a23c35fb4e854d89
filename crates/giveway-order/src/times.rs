//! The earliest times at which events can begin.

use giveway_model::change::History;

use crate::events::{Event, Time, Way};
use crate::units::{Unit, before};

/// The world in which events are timed.
pub(crate) struct Timing<'a> {
    pub(crate) history: &'a History,
    pub(crate) ways: &'a [Way<'a>],
    pub(crate) events: &'a [Event],
    pub(crate) units: &'a [Unit],
}

impl Timing<'_> {
    /// The earliest begin of each event that begins no earlier than its release; an event of
    /// an agent that is removed before has a time at or after that.
    pub(crate) fn begins(&self, release: &dyn Fn(usize) -> Time) -> Vec<Time> {
        let mut begins: Vec<Time> = vec![Time::MIN; self.events.len()];
        for unit in self.units {
            for &event in unit {
                let own = self.own(event, release(event), &begins);
                if let Some(it) = begins.get_mut(event) {
                    *it = own;
                }
            }
            // Around a rotation times only grow, up to the latest of them. A breakdown may
            // hold an agent then, which moves all of them on again.
            let mut changed = true;
            while changed {
                changed = false;
                for &event in unit {
                    let linked = self.linked(event, &begins);
                    if begins.get(event).is_some_and(|begin| *begin < linked) {
                        let free = self.not_held(event, linked, &begins);
                        if let Some(it) = begins.get_mut(event) {
                            *it = free;
                        }
                        changed = unit.len() > 1;
                    }
                }
            }
        }
        begins
    }

    /// The arrival of an event that begins at a time: a slow edge takes two steps.
    pub(crate) fn arrives(&self, event: usize, begin: Time) -> Time {
        begin + 1 + Time::from(self.is_slow(event, begin))
    }

    fn is_slow(&self, event: usize, begin: Time) -> bool {
        let to = self.events.get(event).and_then(|it| it.enters);
        let from = before(self.events, event).and_then(|it| self.events.get(it)?.enters);
        let grid = self.history.grid(u32::try_from(begin).unwrap_or(0));
        from.zip(to)
            .is_some_and(|(from, to)| grid.is_slow_edge(from, to))
    }

    /// The earliest begin as far as the agent itself goes.
    fn own(&self, event: usize, release: Time, begins: &[Time]) -> Time {
        let earlier = before(self.events, event);
        let begin = earlier.and_then(|it| Some((it, *begins.get(it)?)));
        let arrived = begin.map(|(earlier, begin)| self.arrives(earlier, begin));
        let stands = self.events.get(event).map_or(0, |it| it.stands);
        let own = arrived.map_or(release, |time| release.max(time + stands));
        self.not_held(event, own, begins)
    }

    /// The earliest begin as far as the event's links go.
    fn linked(&self, event: usize, begins: &[Time]) -> Time {
        let after = self.events.get(event).into_iter().flat_map(|it| &it.after);
        let times = after.map(|&(earlier, gap)| self.left(earlier, begins).saturating_add(gap));
        times.max().unwrap_or(Time::MIN)
    }

    /// When a cell is left with an event. An agent that is removed leaves in the step before,
    /// wherever it is; where it has not come to the cell by then, those before it may be there.
    pub(crate) fn left(&self, event: usize, begins: &[Time]) -> Time {
        let begin = begins.get(event).copied().unwrap_or(Time::MIN);
        let agent = self.events.get(event).map(|it| it.agent);
        let way = agent.and_then(|agent| self.ways.get(agent));
        let Some(until) = way.and_then(Way::until) else {
            return begin;
        };
        let came = before(self.events, event).and_then(|it| self.events.get(it));
        let earlier = came.and_then(|it| it.cell_before);
        let earlier = earlier.map_or(Time::MIN, |it| self.left(it, begins));
        begin.min(earlier.max(Time::from(until) - 1))
    }

    /// The first time from one on at which no breakdown keeps the agent from beginning a move.
    fn not_held(&self, event: usize, time: Time, begins: &[Time]) -> Time {
        let Some(earlier) = before(self.events, event) else {
            return time;
        };
        let Some(it) = self.events.get(event).filter(|it| it.enters.is_some()) else {
            return time; // leaving the floor is no move
        };
        let begun = begins.get(earlier).copied().unwrap_or(time);
        let arrives = self.arrives(earlier, begun);
        let breakdowns = self.ways.get(it.agent).map(|way| way.breakdowns.iter());
        let held = breakdowns.into_iter().flatten().map(|&(at, steps)| {
            // A slow move under way is completed.
            let from = at + Time::from(begun < at && at < arrives);
            (from, from + steps)
        });
        let held: Vec<(Time, Time)> = held.collect();
        let mut free = time;
        while let Some(&(_, to)) = held.iter().find(|&&(from, to)| from <= free && free < to) {
            free = to;
        }
        free
    }
}
