//! Clauses between agents: collisions, goals that are kept free, and precedences.

use super::Team;
use crate::{
    encode::{agent::Added, collisions::AgentId},
    impose::Precedence,
    sat::{Clauses, Lit},
    single::NodeId,
};

impl Team<'_, '_> {
    /// Excludes the new nodes of an agent from those of all others. Where the nodes reach later times, agents
    /// that rest anywhere rest there, too.
    pub(super) fn absorb(&mut self, agent: AgentId, added: &Added) {
        self.exclude(agent, added);
        let latest = added.positions.iter().map(|&(time, ..)| time).max();
        self.reach(latest.unwrap_or(0));
    }

    /// Lets agents that rest anywhere rest up to a time.
    pub(crate) fn reach(&mut self, until: u32) {
        if until <= self.reach {
            return;
        }
        self.reach = until;
        for agent in 0..self.inside.len() {
            let Some(code) = &mut self.inside[agent] else {
                continue;
            };
            if code.rests_anywhere() {
                let old = code.mdd().size();
                let task = &self.problem.tasks[agent];
                let added = code.reach(until, task, &mut self.sat);
                self.exclude(agent, &added);
                self.precede(agent, old, &added);
            }
        }
    }

    fn exclude(&mut self, agent: AgentId, added: &Added) {
        for &(time, v, lit) in &added.positions {
            self.collisions.occupy(time, v, agent, lit, &mut self.sat);
            if !self.problem.stays {
                continue;
            }
            if let Some(&owner) = self.owners.get(&v)
                && owner != agent
            {
                self.on_goals.entry(v).or_default().push((time, agent, lit));
                if self.problem.rests(owner) && self.problem.collide(owner, agent) {
                    self.keep_away(owner, time, lit);
                }
            }
        }
        for &(time, arc, premise) in &added.crossings {
            self.collisions
                .cross(time, arc, agent, premise, &mut self.sat);
        }
    }

    /// The second agent of a precedence is not at its vertex before the first was at its
    /// own.
    pub(super) fn precede(&mut self, agent: AgentId, old: NodeId, added: &Added) {
        let problem = self.problem;
        for (number, &Precedence { first, second }) in problem.precedences.iter().enumerate() {
            if agent == second.0 {
                // Where they cannot be there at once, "by then" is "before".
                let at_once = first.1 != second.1 || !problem.collide(first.0, second.0);
                for &(time, v, lit) in &added.positions {
                    if v != second.1 {
                        continue;
                    }
                    match time.checked_sub(u32::from(at_once)) {
                        None => self.sat.clause(&[!lit]),
                        Some(time) => {
                            let not_yet = self.not_yet(number, time);
                            self.sat.clause(&[!lit, !not_yet]);
                        }
                    }
                }
            }
            if agent == first.0 {
                let visited = problem.tasks[agent].bit(first.1);
                let Some(code) = self.inside[agent].as_ref() else {
                    continue;
                };
                let mdd = code.mdd();
                let nodes: Vec<(u32, Lit)> = (old..mdd.size())
                    .filter(|&id| mdd.node(id).mask & visited == 0)
                    .map(|id| (mdd.node(id).time, code.node(id)))
                    .collect();
                for (time, node) in nodes {
                    let not_yet = self.not_yet(number, time);
                    self.sat.clause(&[!node, not_yet]);
                }
            }
        }
    }

    /// The literal "the first agent of this precedence has not been there by a time".
    fn not_yet(&mut self, number: usize, time: u32) -> Lit {
        let sat = &mut self.sat;
        *self
            .not_yet
            .entry((number, time))
            .or_insert_with(|| sat.fresh())
    }

    /// Another agent on the owner's goal at a time: the owner arrives later.
    pub(super) fn keep_away(&mut self, owner: AgentId, time: u32, lit: Lit) {
        if let Some(code) = &mut self.inside[owner]
            && let Some(by) = code.by(time, &mut self.sat)
        {
            self.sat.clause(&[!lit, !by]);
        }
    }
}
