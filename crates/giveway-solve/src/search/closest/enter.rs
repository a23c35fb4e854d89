//! Agents that do as before from outside the SAT solver, and agents that enter it.

use giveway_model::Cost;

use super::{AsBefore, GivenWalk, Near, Trace};
use crate::{
    budget::Stop,
    encode::{agent::Added, collisions::AgentId},
    sat::{Clauses, Lit},
    search::{
        aim::Bounded,
        oll::{Oll, Soft},
    },
    single::{Mask, Place},
    walk::{arrival, costs_of, crossed},
};

impl Near<'_, '_> {
    /// Puts those inside who cannot do as before, or cost more than they would
    /// alone; the others are where they were.
    pub(super) fn begin(&mut self, bounded: &Bounded) -> Result<Oll<AsBefore>, Stop> {
        let mut oll = Oll::new();
        let inside = self.search.team.insiders();
        let mut entering = Vec::new();
        for agent in 0..self.problem.agents() {
            let own = costs_of(self.problem, agent, &self.before[agent].walk);
            let mut dear = inside.contains(&agent) || self.masks(agent).is_none();
            for &cost in bounded.limits.keys() {
                let least = match cost {
                    Cost::Makespan => continue,
                    Cost::Charges => {
                        let charges = self.before[agent].charges.len() as u32;
                        dear |= charges > self.search.team.least(agent, cost)?;
                        continue;
                    }
                    cost => self.search.team.least(agent, cost)?,
                };
                dear |= own.get(cost) > least;
            }
            if dear || own.makespan > self.search.cap(agent) {
                entering.push(agent);
            } else {
                let lit = self.search.team.clauses().fresh();
                self.fix(agent, lit)?;
                oll.assume(self, Soft::Level(AsBefore::Outside(agent, lit)))?;
            }
        }
        for agent in entering {
            if let Some(same) = self.enter(agent)? {
                oll.assume(self, Soft::Level(AsBefore::Inside(same)))?;
            }
        }
        Ok(oll)
    }

    /// The waypoints visited at each time of the given walk; `None` where the
    /// agent may not do so.
    fn masks(&self, agent: AgentId) -> Option<Vec<Mask>> {
        let task = &self.problem.tasks[agent];
        let terrain = &self.problem.terrain;
        let GivenWalk { walk, charges } = &self.before[agent];
        if walk.is_empty() {
            return None;
        }
        let arrival = arrival(walk);
        let allowed = arrival >= self.problem.optima[agent]
            && arrival <= self.search.cap(agent)
            && crate::walk::lasts(task, walk, charges)
            && charges.iter().all(|&time| {
                matches!(walk.get(time as usize), Some(Place::At(v))
                    if task.may_charge(terrain, *v, Some(time)))
            })
            && self.problem.keeps_alone(agent, walk, charges.len() as u32);
        let charged = |v| {
            let mut times = charges.iter();
            times.any(|&time| walk.get(time as usize) == Some(&Place::At(v)))
        };
        if !(allowed && task.conditions.charges().all(|(_, v)| charged(v))) {
            return None;
        }
        let mut mask = task.first()?.mask;
        let mut masks = vec![mask];
        for (time, pair) in walk.windows(2).enumerate() {
            let now = time as u32;
            let arc = crossed(terrain, walk, time);
            mask = task.counted(terrain, mask, [pair[0], pair[1]], now)?;
            match (pair[0], pair[1]) {
                (Place::At(u), Place::At(v)) if u == v => {}
                (Place::At(_), _) => {
                    let arc = arc?;
                    task.may_cross(arc.id, Some(now)).then_some(())?;
                    let slow = matches!(pair[1], Place::Along(_));
                    (arc.slow == slow).then_some(())?;
                    mask = task.depart(mask, &arc, Some(now))?;
                }
                (Place::Along(_), _) => {}
            }
            if let Place::At(v) = pair[1] {
                mask |= task.bit(v);
                task.may_stand(v, mask, Some(now + 1)).then_some(())?;
            }
            masks.push(mask);
        }
        let ends = matches!(walk.last(), Some(&Place::At(v)) if task.may_end(v, mask, arrival));
        ends.then_some(masks)
    }

    /// An agent that is where it was before, as long as a literal holds.
    fn fix(&mut self, agent: AgentId, lit: Lit) -> Result<(), Stop> {
        let walk = &self.before[agent].walk;
        let mut added = Added::default();
        let mut latest = arrival(walk);
        for (time, place) in walk.iter().enumerate() {
            if let Place::At(v) = *place {
                added.positions.push((time as u32, v, lit));
            }
            if let Place::Along(arc) = *place {
                added.transits.push((time as u32, arc, lit));
            }
            if let Some(arc) = crossed(&self.problem.terrain, walk, time) {
                added.crossings.push((time as u32, arc, [lit, lit]));
            }
        }
        let end = self.problem.tasks[agent].end_of(walk);
        if let Some(Place::At(end)) = end.filter(|_| self.problem.rests(agent)) {
            while latest < self.search.latest() {
                latest += 1;
                added.positions.push((latest, end, lit));
            }
        }
        self.search.team.place(agent, &added)
    }

    /// Takes an agent inside; the literal "does as before", where it may.
    pub(super) fn enter(&mut self, agent: AgentId) -> Result<Option<Lit>, Stop> {
        self.search.enter(agent)?;
        let Some(masks) = self.masks(agent) else {
            return Ok(None);
        };
        let walk = &self.before[agent].walk;
        let arrival = arrival(walk);
        self.search.grow(agent, arrival)?;
        let same = self.search.team.clauses().fresh();
        let nodes = walk.iter().copied().zip(masks).collect();
        self.traces[agent] = Some(Trace { nodes, same });
        if let Some(by) = self.search.team.by(agent, arrival) {
            self.search.team.clauses().clause(&[!same, by]);
        }
        Ok(Some(same))
    }
}
