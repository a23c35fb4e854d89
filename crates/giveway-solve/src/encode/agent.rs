//! One agent in clauses: its MDD, its deadlines, its positions.
//!
//! Variables are the nodes of the MDD, `by(d)` ("arrived by d", a chain),
//! and, under `stay`, `rest(t)` ("arrived before t"). A node implies one of its
//! steps; where steps of a higher level are not in the MDD yet, it does so
//! only under the deadline that excludes them, so growing adds clauses and
//! takes none back. No clause says that an agent is in one place only: of
//! several that are true at once, those that follow each other from the start
//! are a path, and the rest does no harm. With a battery they do (a charge
//! might be on another branch), so there the nodes of a time exclude each other.
//!
//! Diagrams in SAT: Surynek et al., "Efficient SAT approach to multi-agent path
//! finding under the sum of costs objective" (2016).

mod read;
mod waits;

use std::collections::BTreeMap;

use super::{at_most_one::AtMostOne, battery::BatteryCode, collisions::AgentId};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    sat::{Clauses, Lit},
    single::{Mdd, Node, NodeId, Place, Task, TaskConstraint},
    terrain::{Arc, Terrain, Vertex},
};

/// What growing an agent added, for those who look at several agents.
#[derive(Default)]
pub(crate) struct Added {
    /// It may be at a vertex at a time when the literal is true.
    pub(crate) positions: Vec<(u32, Vertex, Lit)>,
    /// It crosses an arc in the step from a time when both literals are true.
    pub(crate) crossings: Vec<(u32, Arc, [Lit; 2])>,
    /// It takes a step from one node to another, begun at a time.
    pub(crate) steps: Vec<TakenStep>,
}

/// A step between two nodes of the MDD.
pub(crate) struct TakenStep {
    pub(crate) from: NodeId,
    pub(crate) to: NodeId,
}

/// One agent inside the solver.
pub(crate) struct MddEncoding {
    id: AgentId,
    stays: bool,
    optimum: u32,
    mdd: Mdd,
    nodes: Vec<Lit>,
    /// How many steps of each node are in its successor clause.
    written: Vec<u8>,
    /// Nodes whose successor clause changes, by the deadline at which it does.
    due: BTreeMap<u32, Vec<NodeId>>,
    /// `by[i]`: arrived by `optimum + i`.
    by: Vec<Lit>,
    /// `rest[i]`: arrived before `optimum + 1 + i`, and at the goal then.
    rest: Vec<Lit>,
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
            written: Vec::new(),
            due: BTreeMap::new(),
            by: Vec::new(),
            rest: Vec::new(),
            positions: BTreeMap::new(),
            alone: Vec::new(),
            battery: task.reserve.map(BatteryCode::new),
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
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn grow(
        &mut self,
        deadline: u32,
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
        let old = self.mdd.len();
        let cost_to_go = &problem.cost_to_go[self.id];
        self.mdd
            .grow(deadline, task, &problem.terrain, cost_to_go, budget)?;
        for id in old..self.mdd.len() {
            budget.tick()?;
            self.write_node(id, task, &problem.terrain, &mut added, out);
            self.due.entry(0).or_default().push(id);
        }
        self.write_rest(deadline, task, &mut added, out);
        while let Some(entry) = self.due.first_entry() {
            if *entry.key() > deadline {
                break;
            }
            for id in entry.remove() {
                budget.tick()?;
                self.write_steps(id, deadline, task, &problem.terrain, &mut added, out);
            }
        }
        if let Some(battery) = &mut self.battery {
            let chain = &mut self.by;
            let optimum = self.optimum;
            battery.grow(deadline, |time, out| by(chain, optimum, time, out), out);
        }
        if let Some(demand) = &task.demand {
            self.write_waits(old, demand, out);
        }
        budget.check()?;
        Ok(added)
    }

    /// The node's variable, its level, its position.
    fn write_node(
        &mut self,
        id: NodeId,
        task: &Task,
        terrain: &Terrain,
        added: &mut Added,
        out: &mut impl Clauses,
    ) {
        let node = self.mdd.node(id);
        let (place, time, f_value) = (node.place, node.time, node.f_value);
        let lit = out.fresh();
        self.nodes.push(lit);
        self.written.push(0);
        if id == 0 {
            out.clause(&[lit]);
        }
        if f_value > self.optimum
            && let Some(sooner) = self.by(f_value - 1, out)
        {
            out.clause(&[!lit, !sooner]);
        }
        self.exclude_others(time, lit, out);
        match place {
            Place::At(v) => {
                // Where one vertex and time can have several nodes, a variable
                // of its own stands for "here now".
                let several = task.masks() > 1 || (self.stays && v == task.goal);
                self.stand(time, v, lit, several, added, out);
                if let Some(battery) = &mut self.battery
                    && task.may_charge(terrain, v, Some(time))
                {
                    battery.place(time, lit);
                    if matches!(task.demand, Some(TaskConstraint::Charge { v: there, .. }) if there == v)
                    {
                        battery.demand(time, lit);
                    }
                }
            }
            Place::Along(arc) => {
                let (from, _) = terrain.ends(arc);
                if let Some(&arc) = terrain.arcs(from).iter().find(|a| a.id == arc) {
                    // Of one that is there at time 0 the first half is past.
                    if let Some(before) = time.checked_sub(1) {
                        added.crossings.push((before, arc, [lit, lit]));
                    }
                    added.crossings.push((time, arc, [lit, lit]));
                }
            }
        }
    }

    /// The agent at its goal for good, up to the deadline.
    fn write_rest(
        &mut self,
        deadline: u32,
        task: &Task,
        added: &mut Added,
        out: &mut impl Clauses,
    ) {
        while self.stays && self.optimum + (self.rest.len() as u32) < deadline {
            let time = self.optimum + 1 + self.rest.len() as u32;
            let lit = out.fresh();
            if let Some(&before) = self.rest.last() {
                out.clause(&[!before, lit]);
            }
            self.rest.push(lit);
            self.exclude_others(time, lit, out);
            self.stand(time, task.goal, lit, true, added, out);
        }
    }

    /// The literal "arrived before `time`" under `stay`, if it is written.
    fn rest(&self, time: u32) -> Option<Lit> {
        let index = time.checked_sub(self.optimum + 1)?;
        self.rest.get(index as usize).copied()
    }

    fn exclude_others(&mut self, time: u32, lit: Lit, out: &mut impl Clauses) {
        if self.battery.is_some() {
            let time = time as usize;
            if self.alone.len() <= time {
                self.alone.resize(time + 1, AtMostOne::default());
            }
            self.alone[time].add(lit, out);
        }
    }

    /// The node or rest literal means standing at v.
    fn stand(
        &mut self,
        time: u32,
        v: Vertex,
        lit: Lit,
        several: bool,
        added: &mut Added,
        out: &mut impl Clauses,
    ) {
        let position = *self.positions.entry((time, v)).or_insert_with(|| {
            let position = if several { out.fresh() } else { lit };
            added.positions.push((time, v, position));
            position
        });
        if position != lit {
            out.clause(&[!lit, position]);
        }
    }

    /// The successor clause of a node, under the deadline as it is now.
    fn write_steps(
        &mut self,
        id: NodeId,
        deadline: u32,
        task: &Task,
        terrain: &Terrain,
        added: &mut Added,
        out: &mut impl Clauses,
    ) {
        let node = self.mdd.node(id);
        let time = node.time;
        let mut clause = vec![!self.nodes[id as usize]];
        if self.is_end(node, task) {
            if !self.stays {
                return; // it may end here, whatever the deadline
            }
            if time >= deadline {
                self.due.entry(time + 1).or_default().push(id);
                return;
            }
            clause.extend(self.rest(time + 1));
        }
        let within = node.steps.iter().take_while(|s| s.f_value <= deadline);
        let targets: Vec<NodeId> = within
            .filter_map(|s| self.mdd.find(time + 1, s.place, s.mask))
            .collect();
        clause.extend(targets.iter().map(|&to| self.nodes[to as usize]));
        let next = node.steps.get(targets.len()).map(|step| step.f_value);
        let new = self.written[id as usize] as usize;
        self.written[id as usize] = targets.len() as u8;
        for &to in &targets[new..] {
            added.steps.push(TakenStep { from: id, to });
            self.cross(id, to, terrain, added);
        }
        if let Some(level) = next {
            clause.extend(self.by(level - 1, out).map(|lit| !lit));
            self.due.entry(level).or_default().push(id);
        }
        out.clause(&clause);
    }

    /// The literal "arrived before `time`" under `stay`, if it is written.
    pub(crate) fn resting(&self, time: u32) -> Option<Lit> {
        self.rest(time)
    }

    /// Whether it may have arrived at a node: never before its optimum, which
    /// knows of demands on times.
    pub(crate) fn is_end(&self, node: &Node, task: &Task) -> bool {
        let end = matches!(node.place, Place::At(v) if task.is_end(v, node.mask));
        end && node.time >= self.optimum
    }

    fn cross(&self, from: NodeId, to: NodeId, terrain: &Terrain, added: &mut Added) {
        let (from, to) = (self.mdd.node(from), self.mdd.node(to));
        let (Place::At(u), Place::At(v)) = (from.place, to.place) else {
            return; // a slow move is seen by its node half way
        };
        let arc = terrain.arcs(u).iter().find(|arc| arc.to == v);
        let here = self.positions.get(&(from.time, u));
        let there = self.positions.get(&(to.time, v));
        if let (Some(&arc), Some(&here), Some(&there)) = (arc, here, there) {
            added.crossings.push((from.time, arc, [here, there]));
        }
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
