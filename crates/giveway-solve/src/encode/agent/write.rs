//! The clauses of one agent: its nodes, its steps, its rest at the goal.

use super::{Added, MddEncoding, Rest, TakenStep};
use crate::{
    encode::at_most_one::AtMostOne,
    sat::{Clauses, Lit},
    single::{NodeId, Place, Task},
    terrain::{Terrain, Vertex},
};

impl MddEncoding {
    /// The node's variable, its level, its position.
    pub(super) fn write_node(
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
        self.exclude_others(time, lit, task, out);
        match place {
            Place::At(v) => {
                // Where one vertex and time can have several nodes, a variable
                // of its own stands for "here now".
                let several = task.masks() > 1
                    || !task.conditions.counters.is_empty()
                    || (self.stays && task.may_rest_at(v));
                self.stand(time, v, lit, several, added, out);
                if let Some(battery) = &mut self.battery {
                    if task.may_charge(terrain, v, Some(time)) {
                        battery.place(time, lit);
                        for (number, _) in task.conditions.charges().filter(|&(_, at)| at == v) {
                            battery.require(number, time, lit);
                        }
                    } else {
                        battery.elsewhere(time, lit);
                    }
                }
            }
            Place::Along(arc) => {
                if let Some(battery) = &mut self.battery {
                    battery.elsewhere(time, lit);
                }
                added.transits.push((time, arc, lit));
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

    /// The vertices at which it may rest, after nodes from a number on were written.
    pub(super) fn begin_rests(&mut self, old: NodeId, task: &Task) {
        let rest = |from: u32| Rest {
            from,
            lits: Vec::new(),
        };
        if !self.stays {
            return;
        }
        if let Some(goal) = task.goal {
            let from = self.optimum + 1;
            self.rest.entry(goal).or_insert_with(|| rest(from));
            return;
        }
        // Nodes that are ends come in the order of time.
        for id in old..self.mdd.size() {
            let node = self.mdd.node(id);
            if let Place::At(v) = node.place
                && self.is_end(node, task)
            {
                let from = node.time + 1;
                self.rest.entry(v).or_insert_with(|| rest(from));
            }
        }
    }

    /// The agent at rest for good, up to a time.
    pub(super) fn write_rest(
        &mut self,
        until: u32,
        task: &Task,
        added: &mut Added,
        out: &mut impl Clauses,
    ) {
        let mut rests = std::mem::take(&mut self.rest);
        for (&v, rest) in &mut rests {
            while rest.from + (rest.lits.len() as u32) <= until {
                let time = rest.from + rest.lits.len() as u32;
                let lit = out.fresh();
                if let Some(&before) = rest.lits.last() {
                    out.clause(&[!before, lit]);
                }
                rest.lits.push(lit);
                self.exclude_others(time, lit, task, out);
                self.stand(time, v, lit, true, added, out);
            }
        }
        self.rest = rests;
    }

    /// Where a charge at one charger is required, it is in one place at a time.
    fn exclude_others(&mut self, time: u32, lit: Lit, task: &Task, out: &mut impl Clauses) {
        if task.conditions.must_charge() {
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
    pub(super) fn write_steps(
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
            if !self.stays && !task.is_awaited(node.mask) {
                return; // it may end here, whatever the deadline
            }
            if !self.stays {
                let leaves = self.leaves.entry(id);
                clause.push(*leaves.or_insert_with(|| out.fresh()));
            } else if !self.rests_on && time >= deadline {
                self.due.entry(time + 1).or_default().push(id);
                return;
            } else if let Place::At(v) = node.place {
                clause.extend(self.rest(v, time + 1));
            }
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
