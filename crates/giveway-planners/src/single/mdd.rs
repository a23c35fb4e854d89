//! All plans of one agent up to a deadline, as a layered graph that only grows.
//!
//! A multi-valued decision diagram (MDD; Sharon et al. 2013), generalised to
//! waypoints, batteries and slow moves. A node is a place at a time with the
//! waypoints visited; its *f-value* (cost so far plus cost to go, as in A*) is the least arrival of a plan of the agent
//! alone that goes through it. The MDD for a deadline holds the nodes whose
//! f-value is at most the deadline. F-values do not depend on the deadline, so a
//! later deadline adds nodes and changes none.
//!
//! Of the battery each node keeps the best level with which it can be reached.
//! That is exact for f-values: a fuller battery is never worse, and a way that
//! brings a fuller battery has an f-value no higher.

use std::collections::BTreeMap;

use rustc_hash::FxBuildHasher;

use super::{
    CostToGo,
    onward::State,
    task::{Mask, Task},
};
use crate::{
    budget::MemoryUse,
    budget::{Budget, Stop},
    terrain::{Terrain, Vertex},
};
use giveway_model::sorting::{map, sort_by_key};

/// Where an agent is: at a vertex, or half way along a slow arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Place {
    /// At a vertex.
    At(Vertex),
    /// In transit along the arc of this number.
    Along(u32),
}

/// A node by its number in the MDD.
pub type NodeId = u32;

/// A way on from a node.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The place one time step later.
    pub place: Place,
    /// The waypoints visited there.
    pub mask: Mask,
    /// The best battery level there by this way.
    battery: u32,
    /// The least arrival of a plan that takes this way.
    pub f_value: u32,
}

/// A place at a time with waypoints visited.
#[derive(Clone, Debug)]
pub struct Node {
    /// Where the agent is.
    pub place: Place,
    /// The waypoints visited.
    pub mask: Mask,
    /// When, in time steps.
    pub time: u32,
    /// The least arrival of a plan through here.
    pub f_value: u32,
    /// The ways on, by f-value; empty where the agent is in no need of any.
    pub steps: Vec<Step>,
}

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Index = std::collections::HashMap<(u32, Place, Mask), NodeId, FxBuildHasher>;

/// The MDD of one agent.
pub struct Mdd {
    nodes: Vec<Node>,
    index: Index,
    /// Steps that lead to no node yet, by f-value, then by the time they lead to.
    open: BTreeMap<(u32, u32), Vec<Step>>,
    deadline: Option<u32>,
    /// No plan arrives earlier, whatever the tables say, which know no times.
    optimum: u32,
    held: MemoryUse,
}

impl Mdd {
    /// An empty MDD that knows its first node.
    pub fn new(task: &Task, optimum: u32) -> Self {
        // (One that is forbidden at time 0 has no optimum, and no diagram is asked for.)
        let first = task.first().map(|state| Step {
            place: state.place,
            mask: state.mask,
            battery: state.battery,
            f_value: optimum,
        });
        Self {
            nodes: Vec::new(),
            index: Index::default(),
            open: map([((optimum, 0), Vec::from_iter(first))]),
            deadline: None,
            optimum,
            held: MemoryUse::default(),
        }
    }

    /// The deadline that it holds all plans of.
    pub fn deadline(&self) -> Option<u32> {
        self.deadline
    }

    /// The node at a place, time and set of waypoints, if the MDD has it.
    pub fn find(&self, time: u32, place: Place, mask: Mask) -> Option<NodeId> {
        self.index.get(&(time, place, mask)).copied()
    }

    /// A node by its number.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id as usize]
    }

    /// The number of nodes; they are numbered in the order in which they came.
    pub fn size(&self) -> NodeId {
        self.nodes.len() as NodeId
    }

    /// Adds the nodes of f-values up to `deadline`.
    ///
    /// # Errors
    /// When the budget is spent; the MDD is of no use then.
    pub fn grow(
        &mut self,
        deadline: u32,
        task: &Task,
        terrain: &Terrain,
        cost_to_go: &CostToGo,
        budget: &dyn Budget,
    ) -> Result<(), Stop> {
        self.deadline = self.deadline.max(Some(deadline));
        while let Some(entry) = self.open.first_entry() {
            let (f_value, time) = *entry.key();
            if f_value > deadline {
                break;
            }
            // All ways of this f-value into this time are known: their parents
            // are earlier, of no higher f-value. The fullest battery counts.
            let mut steps = entry.remove();
            sort_by_key(&mut steps, |s| (s.place, s.mask, u32::MAX - s.battery));
            steps.dedup_by_key(|s| (s.place, s.mask));
            for step in steps {
                budget.tick()?;
                if self.find(time, step.place, step.mask).is_none() {
                    self.insert(time, &step, task, terrain, cost_to_go, budget);
                }
            }
        }
        Ok(())
    }

    fn insert(
        &mut self,
        time: u32,
        at: &Step,
        task: &Task,
        terrain: &Terrain,
        cost_to_go: &CostToGo,
        budget: &dyn Budget,
    ) {
        let mut steps = Vec::new();
        let state = State {
            place: at.place,
            mask: at.mask,
            battery: at.battery,
        };
        task.onward(terrain, state, time, true, |step| {
            let State {
                place,
                mask,
                battery,
            } = step.to;
            // A place half way counts with the battery level that it leads to.
            let (arrival, delay) = match place {
                Place::At(v) => (v, 0),
                Place::Along(arc) => (terrain.ends(arc).1, 1),
            };
            let Some(rest) = cost_to_go.from(arrival, mask | task.bit(arrival), battery) else {
                return;
            };
            steps.push(Step {
                place,
                mask,
                battery,
                f_value: (time + 1 + delay + rest).max(self.optimum),
            });
        });
        sort_by_key(&mut steps, |s| s.f_value);
        budget.hold_more(&mut self.held, 96 + steps.len() * 48);
        for step in &steps {
            let slot = self.open.entry((step.f_value, time + 1)).or_default();
            slot.push(*step);
        }
        let id = self.nodes.len() as NodeId;
        self.index.insert((time, at.place, at.mask), id);
        self.nodes.push(Node {
            place: at.place,
            mask: at.mask,
            time,
            f_value: at.f_value,
            steps,
        });
    }
}
