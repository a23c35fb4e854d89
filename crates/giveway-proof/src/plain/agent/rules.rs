//! The rules of one agent alone, as clauses.

use super::{Cnf, Lit, Walker};

impl Walker<'_> {
    /// It is at one place at each time; where agents vanish, arrived before is a
    /// place, too: it is gone.
    pub(super) fn be_somewhere(&self, cnf: &mut Cnf) {
        let start = self.at(self.agent.start, 0);
        cnf.clause(start);
        for time in 0..=self.world.last {
            let t = time as usize;
            let mut places: Vec<Lit> = self.at[t].values().copied().collect();
            places.extend(self.transit[t].values());
            places.extend(self.gone(time));
            cnf.clause(places.iter().copied());
            cnf.at_most_one(&places);
        }
    }

    /// From each place it comes to a next one: it waits, moves, or moves slowly.
    pub(super) fn step(&self, cnf: &mut Cnf) {
        let grid = self.world.instance.grid();
        for time in 0..self.world.last {
            let (now, next) = (time as usize, time as usize + 1);
            for (&u, &here) in &self.at[now] {
                let mut then: Vec<Lit> = self.at(u, time + 1).into_iter().collect();
                for v in grid.neighbours(u) {
                    if grid.is_slow_edge(u, v) {
                        then.extend(self.transit[next].get(&(u, v)));
                    } else {
                        then.extend(self.at(v, time + 1));
                    }
                }
                if Some(u) == self.agent.goal {
                    then.extend(self.gone(time + 1));
                }
                cnf.implies(&[here], then);
            }
            for (&v, &there) in &self.at[next] {
                let mut before: Vec<Lit> = self.at(v, time).into_iter().collect();
                for u in grid.neighbours(v) {
                    if grid.is_slow_edge(u, v) {
                        before.extend(self.transit[now].get(&(u, v)));
                    } else {
                        before.extend(self.at(u, time));
                    }
                }
                cnf.implies(&[there], before);
            }
            for (&(u, _), &half) in &self.transit[next] {
                cnf.implies(&[half], self.at(u, time));
            }
            for (&(_, v), &half) in &self.transit[now] {
                cnf.implies(&[half], self.at(v, time + 1));
            }
        }
    }

    /// A waypoint has been seen once it was at it.
    pub(super) fn visit(&self, cnf: &mut Cnf) {
        for (waypoint, seen) in &self.seen {
            for time in 0..=self.world.last {
                let now = seen[time as usize];
                let before = time.checked_sub(1).map(|t| seen[t as usize]);
                let here = self.at(*waypoint, time);
                cnf.implies(&[now], before.into_iter().chain(here));
                for earlier in before.into_iter().chain(here) {
                    cnf.implies(&[earlier], [now]);
                }
            }
        }
    }

    /// It arrives at its goal once all waypoints are seen, for good, and no later
    /// than it stays there for good: arrivals are exact.
    pub(super) fn arrive(&self, cnf: &mut Cnf) {
        let Some(goal) = self.agent.goal else {
            self.come_to_rest(cnf);
            return;
        };
        for time in 0..=self.world.last {
            let t = time as usize;
            let done = self.done[t];
            let before = time.checked_sub(1).map(|t| self.done[t as usize]);
            if let Some(before) = before {
                cnf.implies(&[before], [done]);
            }
            let there = self.at(goal, time);
            if self.world.instance.stays() {
                cnf.implies(&[done], there);
            } else {
                cnf.implies(&[done], before.into_iter().chain(there));
            }
            for (_, seen) in &self.seen {
                cnf.implies(&[done], [seen[t]]);
            }
            if let Some(before) = before
                && let Some(was_there) = self.at(goal, time - 1)
            {
                let mut ready = vec![done, was_there];
                ready.extend(self.seen.iter().map(|(_, seen)| seen[t - 1]));
                cnf.implies(&ready, [before]);
            }
        }
        cnf.clause(self.done.get(self.world.by as usize).copied());
    }

    /// The same of an agent without a goal: once arrived it is at one cell for good.
    fn come_to_rest(&self, cnf: &mut Cnf) {
        for time in 0..=self.world.last {
            let t = time as usize;
            let done = self.done[t];
            cnf.implies(&[done], self.at[t].values().copied());
            for (_, seen) in &self.seen {
                cnf.implies(&[done], [seen[t]]);
            }
            let Some(before) = time.checked_sub(1).map(|t| self.done[t as usize]) else {
                continue;
            };
            cnf.implies(&[before], [done]);
            for (&cell, &was_there) in &self.at[t - 1] {
                let there = self.at(cell, time);
                cnf.implies(&[before, was_there], there);
                if let Some(there) = there {
                    let mut ready = vec![done, was_there, there];
                    ready.extend(self.seen.iter().map(|(_, seen)| seen[t - 1]));
                    cnf.implies(&ready, [before]);
                }
            }
        }
        cnf.clause(self.done.get(self.world.by as usize).copied());
    }

    /// The level never falls below the floor before it arrives: either there
    /// was a charge not too long ago, or what it began with still lasts.
    pub(super) fn use_battery(&self, cnf: &mut Cnf) {
        let Some(battery) = self.agent.battery else {
            return;
        };
        let (instance, floor) = (
            self.world.instance,
            self.world.instance.rules().battery_floor,
        );
        for (charge, time) in self.charging() {
            let here = self.at[time as usize].iter();
            let chargers = here.filter(|&(&cell, _)| instance.grid().is_charger(cell));
            cnf.implies(&[charge], chargers.map(|(_, &lit)| lit));
            cnf.implies(&[charge], [-self.done[time as usize]]);
        }
        if battery.initial < floor {
            cnf.clause([]);
            return;
        }
        // At this time at the latest there has been a charge.
        let first = battery.initial - floor + 1;
        // A charge at s makes the level `capacity` at s + 1.
        let lasts = battery.capacity - floor;
        for time in first.max(1)..=self.world.last {
            let recent = (time - 1).saturating_sub(lasts)..time;
            let charges = recent.filter_map(|s| self.charge[s as usize]);
            let arrived = self.done[time as usize - 1];
            cnf.clause(charges.chain([arrived]));
        }
    }
}
