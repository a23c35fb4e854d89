//! One agent alone: moves, waypoints, arrival, battery.

use std::collections::BTreeMap;

use giveway_model::{Agent, Cell, Cost, sorting};

use super::distance::Distances;
use super::{Cnf, Lit, Name, World};

/// The variables of one agent.
pub(super) struct Walker<'a> {
    world: World<'a>,
    agent: &'a Agent,
    /// At each time, the cells where it may be.
    at: Vec<BTreeMap<Cell, Lit>>,
    /// At each time, the slow moves of which it may be half way.
    transit: Vec<BTreeMap<(Cell, Cell), Lit>>,
    /// At each time, whether it has arrived.
    done: Vec<Lit>,
    /// For each waypoint, at each time, whether it has been there.
    seen: Vec<(Cell, Vec<Lit>)>,
    /// At each time but the last, whether it charges, where it could.
    charge: Vec<Option<Lit>>,
}

impl<'a> Walker<'a> {
    /// Makes the variables.
    pub(super) fn new(cnf: &mut Cnf, world: World<'a>) -> Self {
        let World {
            instance,
            index,
            last,
        } = world;
        let (grid, agent) = (instance.grid(), &instance.agents()[index]);
        let from_start = Distances::from(grid, agent.start);
        let to_goal = Distances::from(grid, agent.goal);
        // Where the goal is too far there would be no variable at all, and a
        // proof about nothing: then only the distance from the start counts.
        let in_reach = to_goal.to(agent.start).is_some_and(|steps| steps <= last);
        let may_be = |cell: Cell, time: u32| {
            from_start.to(cell).is_some_and(|steps| steps <= time)
                && (!in_reach || to_goal.to(cell).is_some_and(|steps| steps <= last - time))
        };
        let cells: Vec<Cell> = grid
            .cells()
            .filter_map(|(cell, ground)| ground.is_vertex().then_some(cell))
            .collect();
        let mut at = Vec::new();
        for time in 0..=last {
            let here = cells.iter().filter(|&&cell| may_be(cell, time));
            let named = here.map(|&cell| (cell, cnf.variable(Name::At(index, cell, time))));
            at.push(sorting::map(named));
        }
        let mut transit = vec![BTreeMap::new(); last as usize + 1];
        for time in 1..last {
            for &u in &cells {
                for v in grid.neighbours(u) {
                    let t = time as usize;
                    if grid.is_slow_edge(u, v)
                        && at[t - 1].contains_key(&u)
                        && at[t + 1].contains_key(&v)
                    {
                        let lit = cnf.variable(Name::Transit(index, u, v, time));
                        transit[t].insert((u, v), lit);
                    }
                }
            }
        }
        let times = |cnf: &mut Cnf, name: &dyn Fn(u32) -> Name| -> Vec<Lit> {
            (0..=last).map(|time| cnf.variable(name(time))).collect()
        };
        let done = times(cnf, &|time| Name::Done(index, time));
        let seen = agent.waypoints.iter().map(|&waypoint| {
            let seen = times(cnf, &|time| Name::Seen(index, waypoint, time));
            (waypoint, seen)
        });
        let seen = seen.collect();
        let charge = (0..last).map(|time| {
            let at_charger = at[time as usize].keys().any(|&cell| grid.is_charger(cell));
            (agent.battery.is_some() && at_charger).then(|| cnf.variable(Name::Charge(index, time)))
        });
        let charge = charge.collect();
        Self {
            world,
            agent,
            at,
            transit,
            done,
            seen,
            charge,
        }
    }

    /// All rules of this agent alone.
    pub(super) fn rules(&self, cnf: &mut Cnf) {
        self.be_somewhere(cnf);
        self.step(cnf);
        self.visit(cnf);
        self.arrive(cnf);
        self.use_battery(cnf);
    }

    /// It is at one place at each time; where agents vanish, arrived before is a
    /// place, too: it is gone.
    fn be_somewhere(&self, cnf: &mut Cnf) {
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
    fn step(&self, cnf: &mut Cnf) {
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
                if u == self.agent.goal {
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
    fn visit(&self, cnf: &mut Cnf) {
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
    fn arrive(&self, cnf: &mut Cnf) {
        let goal = self.agent.goal;
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
        cnf.clause(self.done.last().copied());
    }

    /// The level never falls below the floor before it arrives: either there
    /// was a charge not too long ago, or what it began with still lasts.
    fn use_battery(&self, cnf: &mut Cnf) {
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

    /// The literal that it is at a cell at a time, where it can be.
    pub(super) fn at(&self, cell: Cell, time: u32) -> Option<Lit> {
        self.at.get(time as usize)?.get(&cell).copied()
    }

    /// The literal that it is half way of a slow move at a time, where it can be.
    pub(super) fn transit(&self, u: Cell, v: Cell, time: u32) -> Option<Lit> {
        self.transit.get(time as usize)?.get(&(u, v)).copied()
    }

    /// The literal that it has vanished at a time, where agents vanish: it
    /// arrived before.
    fn gone(&self, time: u32) -> Option<Lit> {
        if self.world.instance.stays() {
            return None;
        }
        self.done.get((time as usize).checked_sub(1)?).copied()
    }

    /// The last time.
    pub(super) fn last(&self) -> u32 {
        self.world.last
    }

    /// The literal that it has arrived at a time or before; later than the last
    /// time it has in any case, as it has then.
    pub(super) fn done_by(&self, time: u32) -> Option<Lit> {
        self.done.get(time.min(self.world.last) as usize).copied()
    }

    /// Whether it stays at this cell in the end.
    pub(super) fn rests_at(&self, cell: Cell) -> bool {
        self.world.instance.stays() && self.agent.goal == cell
    }

    /// The literals that it is at a cell, at one time or at any.
    pub(super) fn visits(&self, cell: Cell, time: Option<u32>) -> Vec<Lit> {
        match time {
            Some(time) => self.at(cell, time).into_iter().collect(),
            None => (0..=self.world.last)
                .filter_map(|time| self.at(cell, time))
                .collect(),
        }
    }

    /// The literals that it charges, with their times.
    pub(super) fn charging(&self) -> Vec<(Lit, u32)> {
        let charges = self.charge.iter().zip(0..);
        charges
            .filter_map(|(charge, time)| Some(((*charge)?, time)))
            .collect()
    }

    /// It does not wait at a cell for so many steps from a time on, before its
    /// arrival.
    pub(super) fn exclude_wait(&self, cnf: &mut Cnf, cell: Cell, begin: u32, steps: u32) {
        let there: Option<Vec<Lit>> = (begin..=begin + steps)
            .map(|time| self.at(cell, time))
            .collect();
        if let Some(there) = there {
            cnf.implies(&there, [self.done[(begin + steps) as usize - 1]]);
        }
    }

    /// What holds where it begins to go from one cell to another, at one time or
    /// at any; all literals of an entry together.
    pub(super) fn moves_between(
        &self,
        u: Cell,
        v: Cell,
        time: Option<u32>,
    ) -> Vec<(Vec<Lit>, u32)> {
        let grid = self.world.instance.grid();
        let mut moves = Vec::new();
        if !u.touches(v) {
            return moves;
        }
        for begin in 0..self.world.last {
            if time.is_some_and(|time| time != begin) {
                continue;
            }
            if grid.is_slow_edge(u, v) {
                let half = self.transit(u, v, begin + 1);
                moves.extend(half.map(|half| (vec![half], begin)));
            } else if let (Some(here), Some(there)) = (self.at(u, begin), self.at(v, begin + 1)) {
                moves.push((vec![here, there], begin));
            }
        }
        moves
    }

    /// The literals of its slow moves, over one edge either way or over any.
    pub(super) fn slow_moves(&self, edge: Option<(Cell, Cell)>) -> Vec<Lit> {
        let asked = |&(u, v): &(Cell, Cell)| edge.is_none_or(|e| e == (u, v) || e == (v, u));
        let moves = self.transit.iter().flatten();
        moves
            .filter(|(edge, _)| asked(edge))
            .map(|(_, &half)| half)
            .collect()
    }

    /// The literals of which as many hold as it has of a cost.
    pub(super) fn counted(&self, cnf: &mut Cnf, cost: Cost) -> Vec<Lit> {
        match cost {
            Cost::Makespan | Cost::SumOfCosts => self.not_done(),
            Cost::Charges => self.charges(),
            Cost::Moves => self.moves(cnf),
            Cost::Waits => self.waits(cnf),
        }
    }

    /// As many of these hold as its arrival is late, the first ones.
    fn not_done(&self) -> Vec<Lit> {
        let last = self.world.last as usize;
        self.done.iter().take(last).map(|done| -done).collect()
    }

    /// Whether it charges, at each time.
    fn charges(&self) -> Vec<Lit> {
        self.charge.iter().flatten().copied().collect()
    }

    /// Whether it begins a move, at each time: it is somewhere else next, and
    /// has not vanished.
    fn moves(&self, cnf: &mut Cnf) -> Vec<Lit> {
        let mut moves = Vec::new();
        for time in 0..self.world.last {
            let begins = cnf.variable(Name::Move(self.world.index, time));
            for (&u, &here) in &self.at[time as usize] {
                let stays = self.at(u, time + 1).into_iter().chain(self.gone(time + 1));
                cnf.implies(&[here], stays.chain([begins]));
            }
            moves.push(begins);
        }
        moves
    }

    /// Whether it waits before its arrival, at each time.
    fn waits(&self, cnf: &mut Cnf) -> Vec<Lit> {
        let mut waits = Vec::new();
        for time in 0..self.world.last {
            let waits_now = cnf.variable(Name::Wait(self.world.index, time));
            for (&u, &here) in &self.at[time as usize] {
                if let Some(still) = self.at(u, time + 1) {
                    cnf.implies(&[here, still], [self.done[time as usize], waits_now]);
                }
            }
            waits.push(waits_now);
        }
        waits
    }
}
