//! Ways that keep clear of oncoming traffic.
//!
//! Where each agent takes its shortest way, half of a crowd comes the other way
//! in every narrow aisle. Here the agents first choose ways one after the other,
//! on which a move costs more the more agents come towards it, and then once
//! more. What each agent still has to pay from every cell is its guide: agents
//! drift into lanes, and plans of large crowds become up to two fifths cheaper
//! (compare Chen et al., "Traffic Flow Optimisation for Lifelong MAPF", 2024).

use super::buckets::Buckets;
use crate::{
    AgentId,
    budget::{Budget, MemoryUse, Stop},
    plain::Plain,
    terrain::{Arc, Vertex},
};

/// The cost of a move, and of each agent that comes the other way.
const MOVE: u32 = 20;
const ONCOMING: u32 = 2;
/// How often all agents choose.
const ROUNDS: usize = 2;
/// The memory that guides may take; larger crowds on larger maps go without.
const MOST_BYTES: usize = 64_000_000;

/// The guided cost to go of each agent, from every vertex.
pub(crate) struct Guide {
    vertices: usize,
    costs: Vec<u32>,
    _held: MemoryUse,
}

impl Guide {
    /// The guides of all agents; `None` where they would take too much memory.
    pub(crate) fn new(plain: &Plain, budget: &dyn Budget) -> Result<Option<Self>, Stop> {
        let entries = plain.agents().checked_mul(plain.vertices());
        let bytes = entries.and_then(|entries| entries.checked_mul(size_of::<u32>()));
        let Some(bytes) = bytes.filter(|&bytes| bytes <= MOST_BYTES) else {
            return Ok(None);
        };
        let held = budget.hold(bytes);
        let mut traffic = Traffic::new(plain);
        let mut nearest_first: Vec<(u32, AgentId)> = (0..plain.agents())
            .map(|agent| (plain.distance(agent, plain.starts()[agent]), agent))
            .collect();
        nearest_first.sort_unstable();
        for _ in 0..ROUNDS {
            for &(_, agent) in &nearest_first {
                budget.spend(plain.vertices() as u64)?;
                traffic.count_out(agent);
                traffic.ways[agent] = traffic.cheapest_way(agent);
                traffic.count_in(agent);
            }
        }
        let mut costs = Vec::with_capacity(plain.agents() * plain.vertices());
        for agent in 0..plain.agents() {
            budget.spend(plain.vertices() as u64)?;
            traffic.count_out(agent);
            costs.extend(traffic.costs_to(plain.goals()[agent]));
            traffic.count_in(agent);
        }
        Ok(Some(Self {
            vertices: plain.vertices(),
            costs,
            _held: held,
        }))
    }

    /// The cost to go of an agent from a vertex.
    pub(crate) fn cost(&self, agent: AgentId, v: Vertex) -> u32 {
        self.costs[agent * self.vertices + v as usize]
    }
}

/// Which way the agents go, as far as they have chosen.
struct Traffic<'p> {
    plain: &'p Plain<'p>,
    /// The agents that cross each arc.
    flow: Vec<u32>,
    /// The arcs that each agent crosses.
    ways: Vec<Vec<u32>>,
    /// Of the search: the cost of each vertex, the arc by which it is reached, and
    /// which ones have a cost.
    reached: Vec<(u32, Option<Arc>)>,
    touched: Vec<Vertex>,
    open: Buckets,
}

impl<'p> Traffic<'p> {
    fn new(plain: &'p Plain<'p>) -> Self {
        Self {
            plain,
            flow: vec![0; plain.arc_count()],
            ways: vec![Vec::new(); plain.agents()],
            reached: vec![(u32::MAX, None); plain.vertices()],
            touched: Vec::new(),
            // A move away from the goal against all others, and back.
            open: Buckets::new(2 * MOVE + ONCOMING * plain.agents() as u32),
        }
    }

    fn count_in(&mut self, agent: AgentId) {
        for &arc in &self.ways[agent] {
            self.flow[arc as usize] += 1;
        }
    }

    fn count_out(&mut self, agent: AgentId) {
        for &arc in &self.ways[agent] {
            self.flow[arc as usize] -= 1;
        }
    }

    /// The cost of an arc: the other direction has the next number, or the one before.
    fn cost(&self, arc: u32) -> u32 {
        MOVE + ONCOMING * self.flow[(arc ^ 1) as usize]
    }

    /// Notes a cost; true where it is the least so far.
    fn reach(&mut self, v: Vertex, cost: u32, by: Option<Arc>) -> bool {
        let entry = &mut self.reached[v as usize];
        if cost >= entry.0 {
            return false;
        }
        if entry.0 == u32::MAX {
            self.touched.push(v);
        }
        *entry = (cost, by);
        true
    }

    /// The cheapest way of an agent (A*), as arcs from its end to its beginning.
    fn cheapest_way(&mut self, agent: AgentId) -> Vec<u32> {
        for v in self.touched.drain(..) {
            self.reached[v as usize] = (u32::MAX, None);
        }
        let plain = self.plain;
        let (start, goal) = (plain.starts()[agent], plain.goals()[agent]);
        let rest = |v| MOVE * plain.distance(agent, v);
        self.reach(start, 0, None);
        self.open.begin(rest(start));
        self.open.push(rest(start), start);
        while let Some((bound, v)) = self.open.pop() {
            if v == goal {
                break;
            }
            let cost = self.reached[v as usize].0;
            if cost + rest(v) < bound {
                continue; // reached at less cost since
            }
            for &arc in plain.arcs(v) {
                let cost = cost + self.cost(arc.id);
                if self.reach(arc.to, cost, Some(arc)) {
                    self.open.push(cost + rest(arc.to), arc.to);
                }
            }
        }
        let mut way = Vec::new();
        let mut v = goal;
        while let Some(arc) = self.reached[v as usize].1 {
            way.push(arc.id);
            v = plain.arc_begin(arc.id);
        }
        way
    }

    /// The costs to a goal from every vertex (Dijkstra, backwards).
    fn costs_to(&mut self, goal: Vertex) -> Vec<u32> {
        let plain = self.plain;
        let mut costs = vec![u32::MAX; plain.vertices()];
        costs[goal as usize] = 0;
        self.open.begin(0);
        self.open.push(0, goal);
        while let Some((cost, v)) = self.open.pop() {
            if costs[v as usize] < cost {
                continue;
            }
            for arc in plain.arcs(v) {
                let cost = cost + self.cost(arc.id ^ 1);
                let known = &mut costs[arc.to as usize];
                if cost < *known {
                    *known = cost;
                    self.open.push(cost, arc.to);
                }
            }
        }
        costs
    }
}
