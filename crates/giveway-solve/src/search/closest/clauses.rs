//! Clauses that compare an inside agent with its given walk, as far as its MDD reaches.

use std::collections::BTreeMap;

use super::{GivenWalk, Near, Trace, entries::is_same_entry};
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    sat::{Clauses, Lit},
    single::{NodeId, Place},
    terrain::Vertex,
    walk::arrival,
};

/// How far the clauses of an inside agent are written.
#[derive(Clone, Debug, Default)]
pub(super) struct WrittenClauses {
    nodes: NodeId,
    rest: u32,
    charges: usize,
    entries: NodeId,
    rest_entries: u32,
    /// Of an agent that rests anywhere: how many of its rests at each vertex.
    rests: BTreeMap<Vertex, usize>,
}

impl Near<'_, '_> {
    /// Writes what is missing about the inside agents.
    pub(super) fn extend(&mut self) -> Result<(), Stop> {
        for agent in self.search.team.insiders() {
            self.search.budget.check()?;
            let clauses = self.missing(agent);
            for clause in clauses {
                self.search.team.clauses().clause(&clause);
            }
        }
        Ok(())
    }

    fn missing(&mut self, agent: AgentId) -> Vec<Vec<Lit>> {
        let mut clauses = Vec::new();
        let Some(code) = self.search.team.code(agent) else {
            return clauses;
        };
        let written = &mut self.written[agent];
        let GivenWalk { walk, charges } = &self.before[agent];
        let arrival = arrival(walk);
        let task = &self.problem.tasks[agent];
        if let Some(Trace { nodes, same }) = &self.traces[agent] {
            for id in written.nodes..code.mdd().size() {
                let node = code.mdd().node(id);
                if nodes.get(node.time as usize) != Some(&(node.place, node.mask)) {
                    clauses.push(vec![!*same, !code.node(id)]);
                }
            }
            written.nodes = code.mdd().size();
            for time in written.rest..=arrival {
                let resting = code.resting(time);
                clauses.extend(resting.map(|(_, rest)| vec![!*same, !rest]));
            }
            written.rest = arrival + 1;
            let lits = code.battery().map_or(&[][..], |battery| battery.charges());
            for (time, &lit) in lits.iter().enumerate().skip(written.charges) {
                let charges = charges.contains(&(time as u32));
                clauses.push(vec![!*same, if charges { lit } else { !lit }]);
            }
            written.charges = lits.len();
        }
        let Some(differs) = self.differs.get(&agent) else {
            return clauses;
        };
        let end = task.end_of(walk);
        let was = |time: u32| walk.get(time as usize).copied().or(end);
        for id in written.entries..code.mdd().size() {
            let node = code.mdd().node(id);
            let Some(&differs) = differs.get(node.time as usize) else {
                continue;
            };
            if was(node.time).is_none_or(|was| !is_same_entry(node.place, was)) {
                clauses.push(vec![!code.node(id), differs]);
            }
        }
        // Where agents vanish an end is an end: it is missing from then on.
        if !self.problem.rests(agent) {
            for id in written.entries..code.mdd().size() {
                let node = code.mdd().node(id);
                if !code.is_end(node, task) {
                    continue;
                }
                for time in node.time + 1..=arrival {
                    if was(time) != Some(node.place)
                        && let Some(&differs) = differs.get(time as usize)
                    {
                        clauses.push(vec![!code.node(id), differs]);
                    }
                }
            }
        }
        written.entries = code.mdd().size();
        if code.rests_on() {
            for (v, from, rests) in code.rests() {
                let done = written.rests.entry(v).or_default();
                for (time, &rest) in (from..).zip(rests).skip(*done) {
                    // Where both walks are over, there is no entry to compare.
                    if let Some(&differs) = differs.get(time as usize)
                        && time <= arrival
                        && was(time) != Some(Place::At(v))
                    {
                        clauses.push(vec![!rest, differs]);
                    }
                }
                *done = rests.len();
            }
            return clauses;
        }
        while let Some(&differs) = differs.get(written.rest_entries as usize) {
            let time = written.rest_entries;
            let resting = code.resting(time).next();
            match resting {
                Some((v, rest)) if was(time) != Some(Place::At(v)) => {
                    clauses.push(vec![!rest, differs]);
                }
                None if time > self.problem.optima[agent] => break, // not written yet
                _ => {}
            }
            written.rest_entries += 1;
        }
        clauses
    }
}
