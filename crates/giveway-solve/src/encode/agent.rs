//! One agent in clauses: its MDD, its deadlines, its positions.
//!
//! Variables are the nodes of the MDD, `by(d)` ("arrived by d", a chain),
//! and, where it stays, `rest(v, t)` ("arrived before t, at v"): of an agent with a
//! goal for that vertex alone, of another for each vertex at which it may end. A node implies one of its
//! steps; where steps of a higher level are not in the MDD yet, it does so
//! only under the deadline that excludes them, so growing adds clauses and
//! takes none back. No clause says that an agent is in one place only: of
//! several that are true at once, those that follow each other from the start
//! are a path, and the rest does no harm. A charge excludes the nodes of its time
//! that are not at chargers, so that it is on that path.
//!
//! Diagrams in SAT: Surynek et al., "Efficient SAT approach to multi-agent path
//! finding under the sum of costs objective" (2016).

mod layers;
mod read;
mod write;

use std::collections::BTreeMap;

use super::{at_most_one::AtMostOne, battery::BatteryCode, collisions::AgentId};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    sat::{Clauses, Lit},
    single::{Mdd, Node, NodeId, Place, Task},
    terrain::{Arc, Vertex},
};

/// The nodes that growing an MDD added, for encodings over several agents.
#[derive(Default)]
pub(crate) struct Added {
    /// It may be at a vertex at a time when the literal is true.
    pub(crate) positions: Vec<(u32, Vertex, Lit)>,
    /// It crosses an arc in the step from a time when both literals are true.
    pub(crate) crossings: Vec<(u32, Arc, [Lit; 2])>,
    /// It is half way along the arc of a number at a time when the literal is true.
    pub(crate) transits: Vec<(u32, u32, Lit)>,
    /// It takes a step from one node to another, begun at a time.
    pub(crate) steps: Vec<TakenStep>,
}

/// A step between two nodes of the MDD.
pub(crate) struct TakenStep {
    pub(crate) from: NodeId,
    pub(crate) to: NodeId,
}

/// An agent at one vertex for good.
struct Rest {
    /// The first time at which it may have arrived before.
    from: u32,
    /// `lits[i]`: arrived before `from + i`, and there then.
    lits: Vec<Lit>,
}

impl Rest {
    fn at(&self, time: u32) -> Option<Lit> {
        let index = time.checked_sub(self.from)?;
        self.lits.get(index as usize).copied()
    }
}

/// One agent inside the solver.
pub(crate) struct MddEncoding {
    id: AgentId,
    stays: bool,
    optimum: u32,
    mdd: Mdd,
    nodes: Vec<Lit>,
    /// The nodes of each time.
    layers: Vec<Vec<Lit>>,
    /// How many steps of each node are in its successor clause.
    written: Vec<u8>,
    /// Nodes whose successor clause changes, by the deadline at which it does.
    due: BTreeMap<u32, Vec<NodeId>>,
    /// `by[i]`: arrived by `optimum + i`.
    by: Vec<Lit>,
    /// Whether its rests are written as far as others come: it may rest at any vertex, or
    /// rules between agents look at those that rest.
    rests_on: bool,
    /// By vertex: arrived before a time, and there then.
    rest: BTreeMap<Vertex, Rest>,
    /// Of nodes at which it may vanish, though others still wait for it to be somewhere: it
    /// does.
    leaves: BTreeMap<NodeId, Lit>,
    positions: BTreeMap<(u32, Vertex), Lit>,
    alone: Vec<AtMostOne>,
    battery: Option<BatteryCode>,
}

impl MddEncoding {
    /// An agent without any node; the first [`MddEncoding::grow`] writes it.
    pub(crate) fn new(id: AgentId, problem: &Problem) -> Self {
        let task = &problem.tasks[id];
        Self {
            id,
            stays: problem.rests(id),
            optimum: problem.optima[id],
            mdd: Mdd::new(task, problem.optima[id]),
            nodes: Vec::new(),
            layers: Vec::new(),
            written: Vec::new(),
            due: BTreeMap::new(),
            by: Vec::new(),
            rests_on: problem.rests(id) && (task.goal.is_none() || problem.has_rules_between()),
            rest: BTreeMap::new(),
            leaves: BTreeMap::new(),
            positions: BTreeMap::new(),
            alone: Vec::new(),
            battery: task.reserve.map(|reserve| {
                let required = task.conditions.charges().map(|(number, _)| number);
                BatteryCode::new(reserve, required)
            }),
        }
    }

    /// The deadline that the clauses cover.
    pub(crate) fn deadline(&self) -> Option<u32> {
        self.mdd.deadline()
    }

    pub(crate) fn mdd(&self) -> &Mdd {
        &self.mdd
    }

    /// The literal of a node.
    pub(crate) fn node(&self, id: NodeId) -> Lit {
        self.nodes[id as usize]
    }

    /// The literals "at a vertex at a time".
    pub(crate) fn positions(&self) -> impl Iterator<Item = ((u32, Vertex), Lit)> + '_ {
        self.positions.iter().map(|(&at, &lit)| (at, lit))
    }

    pub(crate) fn battery(&self) -> Option<&BatteryCode> {
        self.battery.as_ref()
    }

    /// All steps that successor clauses hold so far.
    pub(crate) fn taken_steps(&self) -> Vec<TakenStep> {
        let mut steps = Vec::new();
        for (from, &written) in self.written.iter().enumerate() {
            let node = self.mdd.node(from as NodeId);
            for step in node.steps.iter().take(written as usize) {
                if let Some(to) = self.mdd.find(node.time + 1, step.place, step.mask) {
                    let from = from as NodeId;
                    steps.push(TakenStep { from, to });
                }
            }
        }
        steps
    }

    /// The literal "arrived by `time`"; `None` where that cannot be.
    pub(crate) fn by(&mut self, time: u32, out: &mut impl Clauses) -> Option<Lit> {
        by(&mut self.by, self.optimum, time, out)
    }

    /// Writes what a later deadline needs, and tells what it added.
    ///
    /// An agent whose rests are written on rests up to `reach` at least.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn grow(
        &mut self,
        deadline: u32,
        reach: u32,
        problem: &Problem,
        budget: &Budget,
        out: &mut impl Clauses,
    ) -> Result<Added, Stop> {
        let mut added = Added::default();
        let before = self.mdd.deadline();
        if before >= Some(deadline) {
            return Ok(added);
        }
        let task = &problem.tasks[self.id];
        let old = self.mdd.size();
        let cost_to_go = &problem.cost_to_go[self.id];
        self.mdd
            .grow(deadline, task, &problem.terrain, cost_to_go, budget)?;
        for id in old..self.mdd.size() {
            budget.tick()?;
            self.write_node(id, task, &problem.terrain, &mut added, out);
            self.due.entry(0).or_default().push(id);
        }
        self.begin_rests(old, task);
        let until = if self.rests_on {
            // An end at the deadline, too, is followed by a rest.
            reach.max(deadline.saturating_add(1))
        } else {
            deadline
        };
        self.write_rest(until, task, &mut added, out);
        while let Some(entry) = self.due.first_entry() {
            if *entry.key() > deadline {
                break;
            }
            for id in entry.remove() {
                budget.tick()?;
                self.write_steps(id, deadline, task, &problem.terrain, &mut added, out);
            }
        }
        self.write_layers(old, deadline, out);
        if let Some(battery) = &mut self.battery {
            let chain = &mut self.by;
            let optimum = self.optimum;
            battery.grow(deadline, |time, out| by(chain, optimum, time, out), out);
        }
        budget.check()?;
        Ok(added)
    }

    /// Lets an agent whose rests are written on rest up to a time; any other agent keeps
    /// its goal free by its deadline.
    pub(crate) fn reach(&mut self, until: u32, task: &Task, out: &mut impl Clauses) -> Added {
        let mut added = Added::default();
        if self.rests_on {
            self.write_rest(until, task, &mut added, out);
        }
        added
    }

    /// Whether [`MddEncoding::reach`] matters.
    pub(crate) const fn rests_on(&self) -> bool {
        self.rests_on
    }

    /// The literal "arrived before `time`, at `v`" where it stays, if it is written.
    pub(crate) fn rest(&self, v: Vertex, time: u32) -> Option<Lit> {
        self.rest.get(&v)?.at(time)
    }

    /// The literal "vanishes at a node", where it may go on from there, too.
    pub(crate) fn leaves(&self, id: NodeId) -> Option<Lit> {
        self.leaves.get(&id).copied()
    }

    /// The vertices at which it may rest, each with the literals "arrived before, and
    /// there" of the times from one on.
    pub(crate) fn rests(&self) -> impl Iterator<Item = (Vertex, u32, &[Lit])> + '_ {
        let rests = self.rest.iter();
        rests.map(|(&v, rest)| (v, rest.from, rest.lits.as_slice()))
    }

    /// The literals "arrived before `time`", one for each vertex, as far as written.
    pub(crate) fn resting(&self, time: u32) -> impl Iterator<Item = (Vertex, Lit)> + '_ {
        let rests = self.rest.iter();
        rests.filter_map(move |(&v, rest)| Some((v, rest.at(time)?)))
    }

    /// Whether it may have arrived at a node: never before its optimum, which
    /// knows of demands on times.
    pub(crate) fn is_end(&self, node: &Node, task: &Task) -> bool {
        let end = matches!(node.place, Place::At(v) if task.may_end(v, node.mask, node.time));
        end && node.time >= self.optimum
    }
}

/// The chain "arrived by", made as far as it is asked for.
fn by(chain: &mut Vec<Lit>, optimum: u32, time: u32, out: &mut impl Clauses) -> Option<Lit> {
    let index = time.checked_sub(optimum)? as usize;
    while chain.len() <= index {
        let lit = out.fresh();
        if let Some(&before) = chain.last() {
            out.clause(&[!before, lit]);
        }
        chain.push(lit);
    }
    Some(chain[index])
}
