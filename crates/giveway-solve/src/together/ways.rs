//! Where an agent alone can be at each time while it arrives by a deadline: its MDD,
//! looked at cell by cell.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use giveway_model::sorting::sort_by_key;

use super::{CellTimes, Region};
use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    single::{Mdd, NodeId, Place, Task},
    terrain::Terrain,
};

/// The nodes of an MDD from which the agent arrives by a deadline. Tables know no times and
/// nothing that is counted on the way, so that not all do where rules ask for such.
fn on_time(mdd: &Mdd, (task, earliest): (&Task, u32), by: u32) -> BTreeSet<NodeId> {
    let mut nodes: Vec<NodeId> = (0..mdd.size()).collect();
    sort_by_key(&mut nodes, |&id| Reverse(mdd.node(id).time));
    let mut on_time = BTreeSet::new();
    for id in nodes {
        let node = mdd.node(id);
        let may_end = matches!(node.place, Place::At(v) if task.may_end(v, node.mask, node.time));
        let ends = may_end && (earliest..=by).contains(&node.time);
        let goes_on = || {
            let mut next = node.steps.iter();
            next.any(|step| {
                let next = mdd.find(node.time + 1, step.place, step.mask);
                next.is_some_and(|next| on_time.contains(&next))
            })
        };
        if ends || goes_on() {
            on_time.insert(id);
        }
    }
    on_time
}

/// All ways of an agent alone that arrive by a deadline.
pub(super) struct Ways {
    /// The places where it can be at each time up to the deadline.
    layers: Vec<BTreeSet<Place>>,
    /// Where it may have come to rest by each time up to the deadline; `None` where it
    /// is gone after arriving.
    rests_at: Option<Vec<BTreeSet<Place>>>,
    /// When it arrives at the earliest.
    earliest: u32,
    /// The deadline.
    pub(super) by: u32,
}

impl Ways {
    /// The ways of an agent that arrive by a deadline. There are none where it
    /// cannot.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn of(
        problem: &Problem,
        agent: AgentId,
        by: u32,
        budget: &Budget,
    ) -> Result<Self, Stop> {
        let task = &problem.tasks[agent];
        let earliest = problem.optima[agent];
        let mut mdd = Mdd::new(task, earliest);
        mdd.grow(
            by,
            task,
            &problem.terrain,
            &problem.cost_to_go[agent],
            budget,
        )?;
        let mut layers = Vec::new();
        let on_time = on_time(&mdd, (task, earliest), by);
        for id in (0..mdd.size()).filter(|id| on_time.contains(id)) {
            let node = mdd.node(id);
            let time = node.time as usize;
            if layers.len() <= time {
                layers.resize(time + 1, BTreeSet::new());
            }
            layers[time].insert(node.place);
        }
        let rests_at = problem.rests(agent).then(|| {
            let mut ends = vec![BTreeSet::new(); layers.len()];
            for id in 0..mdd.size() {
                let node = mdd.node(id);
                if let Place::At(v) = node.place
                    && task.may_end(v, node.mask, node.time)
                    && node.time >= earliest
                {
                    ends[node.time as usize].insert(node.place);
                }
            }
            for time in 1..ends.len() {
                let (before, now) = ends.split_at_mut(time);
                now[0].extend(before[time - 1].iter().copied());
            }
            ends
        });
        Ok(Self {
            layers,
            rests_at,
            earliest,
            by,
        })
    }

    /// The cells where it can be, by row.
    pub(super) fn region(&self, agent: &str, terrain: &Terrain) -> Region {
        let mut cells = BTreeMap::new();
        for (time, places) in (0..).zip(&self.layers) {
            for &place in places {
                let cell = match place {
                    Place::At(v) => terrain.cell(v),
                    Place::Along(arc) => terrain.cell(terrain.ends(arc).0),
                };
                let times = cells.entry((cell.y, cell.x)).or_insert(CellTimes {
                    cell,
                    first: time,
                    last: time,
                });
                times.last = time;
            }
        }
        Region {
            agent: agent.to_owned(),
            by: self.by,
            cells: cells.into_values().collect(),
        }
    }

    /// Whether it has arrived by a time, and rests from then on, whichever way it
    /// takes.
    pub(super) fn rests(&self, time: u32) -> bool {
        self.rests_at.is_some() && self.earliest <= self.by && self.by <= time
    }

    /// The one place where it is at a time, whichever way it takes.
    pub(super) fn only_place(&self, time: u32) -> Option<Place> {
        let ends = self.rests_at.as_ref();
        if self.rests(time) {
            let mut places = ends?.last()?.iter().copied();
            return places.next().filter(|_| places.next().is_none());
        }
        let layer = self.layers.get(time as usize)?;
        // From its earliest arrival on it may have arrived already.
        let arrived = ends.filter(|_| time >= self.earliest);
        if time > self.earliest && arrived.is_none() {
            return None;
        }
        let arrived = arrived.and_then(|ends| ends.get(time as usize));
        let mut places = layer.iter().chain(arrived.into_iter().flatten()).copied();
        let first = places.next()?;
        places.all(|place| place == first).then_some(first)
    }
}
