//! Rules between agents.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cell;
use giveway_model::condition::{Times, Visit};

use super::super::agent::{Moment, Walker};
use super::super::{Cnf, Lit, Name};
use super::Writer;

/// By column and row, the agents that count there, with their literals.
type Places = BTreeMap<(u32, u32), Vec<(usize, Lit)>>;

impl Writer<'_> {
    /// When an agent is at a cell, no other one is there in the next `steps` time steps: of
    /// all that are there at a time or so many steps before there is at most one.
    pub(super) fn gap(&self, cnf: &mut Cnf, steps: u32) {
        for (cell, _) in self.instance.grid().cells() {
            let mut visits: Vec<(usize, Vec<(u32, Lit)>)> = Vec::new();
            for walker in &self.walkers {
                let times = 0..=self.last();
                let there = times.filter_map(|time| Some((time, walker.at(cell, time)?)));
                visits.push((walker.index(), there.collect()));
            }
            visits.retain(|(_, there)| !there.is_empty());
            for time in 0..=self.last() {
                self.at_most_one_recent(cnf, cell, (time.saturating_sub(steps), time), &visits);
                if self.is_full(cnf) {
                    return;
                }
            }
        }
    }

    /// At most one agent was at a cell at times from one to another. Of each agent that ever
    /// is, the literals that it is there are given, with their times.
    fn at_most_one_recent(
        &self,
        cnf: &mut Cnf,
        cell: Cell,
        (from, to): (u32, u32),
        visits: &[(usize, Vec<(u32, Lit)>)],
    ) {
        let mut recent: Vec<(usize, &[(u32, Lit)])> = Vec::new();
        for (agent, there) in visits {
            let begin = there.partition_point(|&(time, _)| time < from);
            let end = there.partition_point(|&(time, _)| time <= to);
            let there = there.get(begin..end).unwrap_or_default();
            if !there.is_empty() {
                recent.push((*agent, there));
            }
        }
        if recent.len() < 2 {
            return;
        }
        let mut agents = Vec::new();
        for (agent, there) in recent {
            let was_there = cnf.variable(Name::Recent(self.index(), agent, cell, to));
            for &(_, lit) in there {
                cnf.implies(&[lit], [was_there]);
            }
            agents.push(was_there);
        }
        cnf.at_most_one(&agents);
    }

    /// At each of these times any two of the agents have at least this Manhattan distance.
    pub(super) fn apart(&self, cnf: &mut Cnf, distance: u32, times: Times) {
        for moment in Moment::of(times, self.last()) {
            let mut there = Places::new();
            for walker in &self.walkers {
                for (cell, lit) in walker.touches(moment) {
                    let agents = there.entry((cell.x, cell.y)).or_default();
                    agents.push((walker.index(), lit));
                }
            }
            for (one, other) in self.near(cnf, distance, &there) {
                cnf.clause([-one, -other]);
            }
            if self.is_full(cnf) {
                return;
            }
        }
    }

    /// The literals of two agents nearer than a distance; not all where there are too many.
    fn near(&self, cnf: &Cnf, distance: u32, there: &Places) -> BTreeSet<(Lit, Lit)> {
        let mut near = BTreeSet::new();
        let columns = distance.min(self.instance.grid().width());
        for (&(x, y), agents) in there {
            for right in 0..columns {
                let rest = distance - 1 - right;
                let (first, last) = (y.saturating_sub(rest), y.saturating_add(rest));
                for (_, others) in there.range((x + right, first)..=(x + right, last)) {
                    near.extend(pairs(agents, others));
                }
                if cnf.clauses().saturating_add(near.len()) > self.limit {
                    return near;
                }
            }
        }
        near
    }

    /// The second is not at its cell at a time unless the first was at its own before.
    pub(super) fn before(&self, cnf: &mut Cnf, first: &Visit, second: &Visit) {
        let find = |name: &str| -> Option<&Walker<'_>> {
            let mut walkers = self.walkers.iter().copied();
            walkers.find(|walker| walker.name() == name)
        };
        let (Some(one), Some(other)) = (find(&first.agent), find(&second.agent)) else {
            return;
        };
        let mut was_there = None;
        for time in 0..=self.last() {
            if let Some(there) = other.at(second.cell, time) {
                cnf.implies(&[there], was_there);
            }
            let now = cnf.variable(Name::First(self.index(), time));
            let here = one.at(first.cell, time);
            cnf.implies(&[now], was_there.into_iter().chain(here));
            was_there = Some(now);
        }
    }
}

/// The literals of two different agents, each pair once.
fn pairs<'a>(
    agents: &'a [(usize, Lit)],
    others: &'a [(usize, Lit)],
) -> impl Iterator<Item = (Lit, Lit)> + 'a {
    let with_all = move |&(agent, here): &'a (usize, Lit)| {
        let others = others.iter().filter(move |&&(other, _)| other != agent);
        others.map(move |&(_, there)| (here.min(there), here.max(there)))
    };
    agents.iter().flat_map(with_all)
}
