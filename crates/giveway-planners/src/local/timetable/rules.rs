//! What rules between agents ask of a timetable.

use giveway_model::condition::Times;

use super::Timetable;
use crate::{AgentId, terrain::Vertex};

impl Timetable<'_> {
    /// The spans of time for which agents are at a vertex, or in transit to or from it.
    pub(in crate::local) fn touching(&self, v: Vertex, mut each: impl FnMut(AgentId, (u32, u32))) {
        let arcs = self.problem.terrain.arcs(v);
        let is_slow = |to: Vertex| arcs.iter().any(|arc| arc.slow && arc.to == to);
        for span in self.spans.get(v as usize).into_iter().flatten() {
            // In transit it is a step after it left.
            let to = span.to.saturating_add(u32::from(is_slow(span.next)));
            each(span.agent as AgentId, (span.from, to));
        }
        for arc in arcs.iter().filter(|arc| arc.slow) {
            let spans = self.spans.get(arc.to as usize).into_iter().flatten();
            for span in spans.filter(|span| span.next == v) {
                each(span.agent as AgentId, (span.to + 1, span.to + 1));
            }
        }
    }

    /// The spans of time, among some times, at which so many agents are in the zone of a rule
    /// between agents.
    pub(in crate::local) fn full(&self, rule: usize, most: u32, times: Times) -> Vec<(u32, u32)> {
        let shared = self.shared.as_ref();
        shared.map_or_else(Vec::new, |shared| shared.full(rule, most, times))
    }

    /// When an agent must not be at a vertex, because another has not been at one before.
    pub(in crate::local) fn before_first_visit(
        &self,
        agent: AgentId,
        v: Vertex,
    ) -> impl Iterator<Item = (u32, u32)> + '_ {
        let shared = self.shared.iter();
        shared.flat_map(move |shared| shared.before_first_visit(agent, v))
    }

    /// The vertices at which an agent has to be before others are somewhere, each with the time
    /// at which they are.
    pub(in crate::local) fn visits_due(&self, agent: AgentId) -> Vec<(Vertex, u32)> {
        let shared = self.shared.iter();
        shared.flat_map(|shared| shared.visits_due(agent)).collect()
    }
}
