//! What an agent may do, made known to all others: collisions, goals that are
//! kept free, and who is somewhere first.

use super::Team;
use crate::{
    counterfactual::Precedence,
    encode::{agent::Added, collisions::AgentId},
    sat::{Clauses, Lit},
    single::NodeId,
};

impl Team<'_, '_> {
    /// Makes what an agent may do known to all others.
    pub(super) fn absorb(&mut self, agent: AgentId, added: &Added) {
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

    /// Who has to be somewhere first is in its way until it has been there.
    pub(super) fn precede(&mut self, agent: AgentId, old: NodeId, added: &Added) {
        let Some(Precedence { first, second, at }) = self.problem.precedence else {
            return;
        };
        if agent == second {
            for &(time, v, lit) in &added.positions {
                if v == at {
                    let not_yet = self.not_yet(time);
                    self.sat.clause(&[!lit, !not_yet]);
                }
            }
        }
        if agent == first {
            let visited = self.problem.tasks[first].bit(at);
            let Some(code) = self.inside[first].as_ref() else {
                return;
            };
            let mdd = code.mdd();
            let nodes: Vec<(u32, Lit)> = (old..mdd.size())
                .filter(|&id| mdd.node(id).mask & visited == 0)
                .map(|id| (mdd.node(id).time, code.node(id)))
                .collect();
            for (time, node) in nodes {
                let not_yet = self.not_yet(time);
                self.sat.clause(&[!node, not_yet]);
            }
        }
    }

    /// The literal "who has to be there first has not been there by a time".
    fn not_yet(&mut self, time: u32) -> Lit {
        let sat = &mut self.sat;
        *self.not_yet.entry(time).or_insert_with(|| sat.fresh())
    }

    /// Somebody on the owner's goal at a time: the owner arrives later.
    pub(super) fn keep_away(&mut self, owner: AgentId, time: u32, lit: Lit) {
        if let Some(code) = &mut self.inside[owner]
            && let Some(by) = code.by(time, &mut self.sat)
        {
            self.sat.clause(&[!lit, !by]);
        }
    }
}
