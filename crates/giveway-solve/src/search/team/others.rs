//! Clauses between agents: collisions, goals that are kept free, and precedences.

use super::Team;
use crate::{
    budget::Stop,
    encode::{agent::Added, collisions::AgentId},
    impose::Precedence,
    sat::{Clauses, Lit},
    single::{NodeId, Place},
};

impl Team<'_, '_> {
    /// Excludes the new nodes of an agent from those of all others. Where the nodes reach later times, agents
    /// that rest anywhere rest there, too.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn absorb(&mut self, agent: AgentId, added: &Added) -> Result<(), Stop> {
        self.exclude(agent, added)?;
        let latest = added.positions.iter().map(|&(time, ..)| time).max();
        // A gap needs no later rest: of an agent that came after another one left, the arrival
        // is the nearest time, and no rest.
        self.reach(latest.unwrap_or(0))
    }

    /// Lets agents whose rests are written on rest up to a time.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn reach(&mut self, until: u32) -> Result<(), Stop> {
        if until <= self.reach {
            return Ok(());
        }
        self.reach = until;
        for agent in 0..self.inside.len() {
            let Some(code) = &mut self.inside[agent] else {
                continue;
            };
            if code.rests_on() {
                let old = code.mdd().size();
                let task = &self.problem.tasks[agent];
                let added = code.reach(until, task, &mut self.sat);
                self.exclude(agent, &added)?;
                self.precede(agent, old, &added);
            }
        }
        Ok(())
    }

    /// Excludes new positions that break a rule between agents together with others.
    fn keep_rules(&mut self, agent: AgentId, added: &Added) -> Result<(), Stop> {
        let problem = self.problem;
        let at = added.positions.iter();
        let at = at.map(|&(time, v, lit)| (time, Place::At(v), lit));
        let along = added.transits.iter();
        let along = along.map(|&(time, arc, lit)| (time, Place::Along(arc), lit));
        for (time, place, lit) in at.chain(along) {
            // A long gap or a large distance has many clauses for a single position.
            self.budget.check()?;
            let world = (&problem.between, &problem.terrain);
            let (here, whose) = ((time, place), (agent, lit));
            self.rules.occupy(world, here, whose, &mut self.sat)?;
        }
        Ok(())
    }

    fn exclude(&mut self, agent: AgentId, added: &Added) -> Result<(), Stop> {
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
        if !self.problem.between.is_empty() {
            self.keep_rules(agent, added)?;
        }
        Ok(())
    }

    /// The second agent of a precedence is not at its vertex before the first was at its
    /// own.
    pub(super) fn precede(&mut self, agent: AgentId, old: NodeId, added: &Added) {
        let problem = self.problem;
        for (number, &Precedence { first, second, .. }) in problem.precedences.iter().enumerate() {
            if agent == second.0 {
                // Where they cannot be there at once, "by then" is "before".
                let at_once = first.1 != second.1 || !problem.collide(first.0, second.0);
                for &(time, v, lit) in &added.positions {
                    if v != second.1 {
                        continue;
                    }
                    let never = self.never(number);
                    self.sat.clause(&[!lit, !never]);
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
                let task = &problem.tasks[agent];
                let Some(code) = self.inside[agent].as_ref() else {
                    continue;
                };
                let mdd = code.mdd();
                let nodes: Vec<(u32, Lit)> = (old..mdd.size())
                    .filter(|&id| !task.has_been(mdd.node(id).mask, first.1))
                    .map(|id| (mdd.node(id).time, code.node(id)))
                    .collect();
                // One that ends without having been there never is.
                let ends = (old..mdd.size()).filter_map(|id| {
                    let node = mdd.node(id);
                    let Place::At(v) = node.place else {
                        return None;
                    };
                    let is_end = code.is_end(node, task) && !task.has_been(node.mask, first.1);
                    let rests = || (code.node(id), code.rest(v, node.time + 1));
                    is_end.then(|| code.leaves(id).map_or_else(rests, |leaves| (leaves, None)))
                });
                let ends: Vec<(Lit, Option<Lit>)> = ends.collect();
                for (end, rest) in ends {
                    let never = self.never(number);
                    let clause = [Some(!end), rest.map(|rest| !rest), Some(never)];
                    let clause: Vec<Lit> = clause.into_iter().flatten().collect();
                    self.sat.clause(&clause);
                }
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

    /// The literal "the first agent of this precedence is never there".
    fn never(&mut self, number: usize) -> Lit {
        let sat = &mut self.sat;
        *self.never.entry(number).or_insert_with(|| sat.fresh())
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
