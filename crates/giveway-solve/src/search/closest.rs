//! Of all plans as good as the best, one that is close to a given plan.
//!
//! First as few agents as can be do something else, by unsatisfiable cores over
//! "does as before" (as in [`super::sum`]); an agent that no core names is not
//! inside the SAT solver at all, but in everyone's way where it was before. Then
//! as few entries as can be differ, from above, until one fewer is refuted.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::Cost;

use super::{
    incumbent::Incumbent,
    lexicographic::{Bounded, keep_limits},
    stage::Search,
};
use crate::{
    encode::{
        agent::Added,
        collisions::AgentId,
        totalizer::{merge, totalizer},
    },
    meter::{Meter, Stop},
    problem::Problem,
    sat::{Clauses, Lit, Outcome},
    single::{Demand, NodeId, Place},
    walk::{Walk, arrival, costs_of, crossed},
};

/// Entries of all agents inside, beyond which nothing is tried.
const MOST_ENTRIES: usize = 1500;

/// What one agent does in the given plan.
#[derive(Clone, Debug)]
pub(crate) struct Before {
    pub(crate) walk: Walk,
    pub(crate) charges: Vec<u32>,
}

/// A plan close to the given one.
pub(crate) struct Close {
    pub(crate) walks: Vec<Walk>,
    /// Agents that do as before, charges included.
    pub(crate) same: Vec<bool>,
    /// Whether it is proved that none is closer.
    pub(crate) proved: bool,
}

/// The closest plan within the limits, which the best plan meets; `None` where
/// the budget ran out before any was found.
///
/// # Errors
/// When the budget is spent before there is any.
pub(crate) fn closest(
    problem: &Problem,
    before: &[Before],
    bounded: &Bounded,
    meter: &Rc<Meter>,
) -> Result<Option<Close>, Stop> {
    let objective = giveway_model::Objective::default();
    let mut incumbent = Incumbent::new(objective, bounded.horizon, bounded.limits.clone());
    let walks: Vec<Walk> = before.iter().map(|it| it.walk.clone()).collect();
    let horizon = bounded.latest();
    let search = Search::new(problem, walks, horizon, &mut incumbent, Rc::clone(meter));
    let agents = problem.agents();
    let mut near = Near {
        problem,
        before,
        search,
        traces: (0..agents).map(|_| None).collect(),
        written: vec![Written::default(); agents],
        differs: BTreeMap::new(),
        softs: BTreeMap::new(),
        cores: Vec::new(),
    };
    if !keep_limits(&mut near.search, bounded)? {
        return Ok(None);
    }
    near.begin(bounded)?;
    if !near.few_agents()? {
        return Ok(None);
    }
    let mut close = near.read();
    // What is found later is only better.
    let end = near.few_entries(&mut close);
    close.proved = matches!(end, Ok(true)) && near.is_exact();
    Ok(Some(close))
}

/// An agent that does as before, or does not.
#[derive(Clone, Copy, Debug)]
enum Soft {
    /// An agent that is not inside the SAT solver.
    Outside(AgentId),
    /// One that is.
    Inside,
    /// No more than this one of those that a core names.
    Total,
}

/// The given walk of an inside agent, as nodes of its diagram.
struct Trace {
    nodes: Vec<(Place, u32)>,
    /// It does as before.
    same: Lit,
}

/// How far the clauses of an inside agent are written.
#[derive(Clone, Copy, Debug, Default)]
struct Written {
    nodes: NodeId,
    rest: u32,
    charges: usize,
    entries: NodeId,
    rest_entries: u32,
}

struct Near<'p, 'h> {
    problem: &'p Problem,
    before: &'p [Before],
    search: Search<'p, 'h>,
    traces: Vec<Option<Trace>>,
    written: Vec<Written>,
    /// "Its entry at this time differs", of inside agents, once they count.
    differs: BTreeMap<AgentId, Vec<Lit>>,
    softs: BTreeMap<Lit, Soft>,
    cores: Vec<Vec<Lit>>,
}

impl Near<'_, '_> {
    /// Puts those inside who cannot do as before, or cost more than they would
    /// alone; the others are where they were.
    fn begin(&mut self, bounded: &Bounded) -> Result<(), Stop> {
        let inside = self.search.team.insiders();
        let mut entering = Vec::new();
        for agent in 0..self.problem.agents() {
            let own = costs_of(self.problem, agent, &self.before[agent].walk);
            let mut dear = inside.contains(&agent) || self.masks(agent).is_none();
            for &cost in bounded.limits.keys() {
                let least = match cost {
                    Cost::Makespan => continue,
                    Cost::SumOfCosts => self.problem.optima[agent],
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
                self.fix(agent, lit);
                self.softs.insert(lit, Soft::Outside(agent));
            }
        }
        for agent in entering {
            if let Some(same) = self.enter(agent)? {
                self.softs.insert(same, Soft::Inside);
            }
        }
        Ok(())
    }

    /// The waypoints visited at each time of the given walk; `None` where the
    /// agent may not do so.
    fn masks(&self, agent: AgentId) -> Option<Vec<u32>> {
        let task = &self.problem.tasks[agent];
        let terrain = &self.problem.terrain;
        let Before { walk, charges } = &self.before[agent];
        let arrival = arrival(walk);
        let allowed = arrival >= self.problem.optima[agent]
            && arrival <= self.search.cap(agent)
            && crate::walk::charges(task, terrain, walk).is_some()
            && charges.iter().all(|&time| {
                matches!(walk.get(time as usize), Some(Place::At(v))
                    if task.may_charge(terrain, *v, Some(time)))
            })
            && self.problem.keeps_alone(agent, walk, charges.len() as u32);
        let charged = |v| {
            let mut times = charges.iter();
            times.any(|&time| walk.get(time as usize) == Some(&Place::At(v)))
        };
        let demanded = match task.demand {
            Some(Demand::Charge { v, .. }) => charged(v),
            _ => true,
        };
        if !(allowed && demanded) {
            return None;
        }
        let mut mask = task.first_mask();
        let mut masks = vec![mask];
        let first = task.may_stand(task.start, mask, Some(0));
        for (time, pair) in walk.windows(2).enumerate() {
            let now = time as u32;
            let arc = crossed(terrain, walk, time);
            match (pair[0], pair[1]) {
                (Place::At(u), Place::At(v)) if u == v => {
                    task.may_wait(u, now).then_some(())?;
                }
                (Place::At(_), _) => {
                    let arc = arc?;
                    task.may_cross(arc.id, Some(now)).then_some(())?;
                    mask |= task.crossed(arc.id, Some(now));
                }
                (Place::Along(_), _) => {}
            }
            if let Place::At(v) = pair[1] {
                mask |= task.bit(v);
                task.may_stand(v, mask, Some(now + 1)).then_some(())?;
            }
            masks.push(mask);
        }
        (first && mask == task.all()).then_some(masks)
    }

    /// An agent that is where it was before, as long as a literal holds.
    fn fix(&mut self, agent: AgentId, lit: Lit) {
        let walk = &self.before[agent].walk;
        let mut added = Added::default();
        let mut latest = arrival(walk);
        for (time, place) in walk.iter().enumerate() {
            if let Place::At(v) = *place {
                added.positions.push((time as u32, v, lit));
            }
            if let Some(arc) = crossed(&self.problem.terrain, walk, time) {
                added.crossings.push((time as u32, arc, [lit, lit]));
            }
        }
        while self.problem.rests(agent) && latest < self.search.horizon() {
            latest += 1;
            let goal = self.problem.tasks[agent].goal;
            added.positions.push((latest, goal, lit));
        }
        self.search.team.place(agent, &added);
    }

    /// Takes an agent inside; the literal "does as before", where it may.
    fn enter(&mut self, agent: AgentId) -> Result<Option<Lit>, Stop> {
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

    /// As few agents as can be do something else; false where there is no plan.
    fn few_agents(&mut self) -> Result<bool, Stop> {
        loop {
            self.extend()?;
            let guards = self.search.guards();
            let mut assumptions: Vec<Lit> = self.softs.keys().copied().collect();
            assumptions.extend(guards.keys());
            match self.search.team.solve(&assumptions)? {
                Outcome::Sat if !self.cores.is_empty() => self.assume_totals(),
                Outcome::Sat => break,
                Outcome::Unsat(core) => {
                    let mut grown = false;
                    for lit in &core {
                        if let Some(&agent) = guards.get(lit) {
                            grown |= self.search.grow_further(agent, u32::MAX)?;
                        }
                    }
                    if !grown {
                        self.learn(&core)?;
                        if core.is_empty() {
                            return Ok(false);
                        }
                    }
                }
            }
        }
        // Whoever does something else in any plan with so few has been named.
        for &lit in self.softs.keys() {
            self.search.team.harden(lit);
        }
        Ok(true)
    }

    /// One of those that a core names does something else.
    fn learn(&mut self, core: &[Lit]) -> Result<(), Stop> {
        let mut violations = Vec::new();
        for lit in core {
            match self.softs.remove(lit) {
                Some(Soft::Outside(agent)) => {
                    // From now on its place inside says where it is.
                    self.search.team.harden(!*lit);
                    if let Some(same) = self.enter(agent)? {
                        violations.push(!same);
                    }
                }
                Some(Soft::Inside | Soft::Total) => violations.push(!*lit),
                None => {}
            }
        }
        match violations.as_slice() {
            [one] => self.search.team.harden(*one),
            _ => self.cores.push(violations),
        }
        Ok(())
    }

    fn assume_totals(&mut self) {
        for violations in std::mem::take(&mut self.cores) {
            let outputs = totalizer(&violations, self.search.team.clauses());
            // One of them is paid for; every further one costs as much again.
            for &more in outputs.iter().skip(1) {
                self.softs.insert(!more, Soft::Total);
            }
        }
    }

    /// Writes what is missing about the inside agents.
    fn extend(&mut self) -> Result<(), Stop> {
        for agent in self.search.team.insiders() {
            self.search.meter.check()?;
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
        let Before { walk, charges } = &self.before[agent];
        let arrival = arrival(walk);
        let task = &self.problem.tasks[agent];
        if let Some(Trace { nodes, same }) = &self.traces[agent] {
            for id in written.nodes..code.diagram().len() {
                let node = code.diagram().node(id);
                if nodes.get(node.time as usize) != Some(&(node.place, node.mask)) {
                    clauses.push(vec![!*same, !code.node(id)]);
                }
            }
            written.nodes = code.diagram().len();
            for time in written.rest..=arrival {
                clauses.extend(code.resting(time).map(|rest| vec![!*same, !rest]));
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
        let goal = Place::At(task.goal);
        let was = |time: u32| walk.get(time as usize).copied().unwrap_or(goal);
        for id in written.entries..code.diagram().len() {
            let node = code.diagram().node(id);
            let Some(&differs) = differs.get(node.time as usize) else {
                continue;
            };
            if !is_same_entry(node.place, was(node.time)) {
                clauses.push(vec![!code.node(id), differs]);
            }
        }
        // Where agents vanish an end is an end: it is missing from then on.
        if !self.problem.rests(agent) {
            for id in written.entries..code.diagram().len() {
                let node = code.diagram().node(id);
                if !code.is_end(node, task) {
                    continue;
                }
                for time in node.time + 1..=arrival {
                    if was(time) != goal
                        && let Some(&differs) = differs.get(time as usize)
                    {
                        clauses.push(vec![!code.node(id), differs]);
                    }
                }
            }
        }
        written.entries = code.diagram().len();
        while let Some(&differs) = differs.get(written.rest_entries as usize) {
            let time = written.rest_entries;
            match code.resting(time) {
                Some(rest) if was(time) != goal => clauses.push(vec![!rest, differs]),
                None if time > self.problem.optima[agent] => break, // not written yet
                _ => {}
            }
            written.rest_entries += 1;
        }
        clauses
    }

    /// As few entries as can be differ; whether that is proved.
    fn few_entries(&mut self, close: &mut Close) -> Result<bool, Stop> {
        let insiders = self.search.team.insiders();
        let latest: Vec<u32> = insiders
            .iter()
            .map(|&agent| {
                self.search
                    .cap(agent)
                    .max(arrival(&self.before[agent].walk))
            })
            .collect();
        let entries: usize = latest.iter().map(|&cap| cap as usize + 1).sum();
        if entries > MOST_ENTRIES {
            return Ok(false);
        }
        let mut best = self.entries(&close.walks);
        let mut sum: Vec<Lit> = Vec::new();
        for (&agent, &latest) in insiders.iter().zip(&latest) {
            let out = self.search.team.clauses();
            let lits: Vec<Lit> = (0..=latest).map(|_| out.fresh()).collect();
            for lit in &lits {
                sum = merge(&sum, &[*lit], best, out);
            }
            self.differs.insert(agent, lits);
        }
        // The sum was cut at the best so far, which is never exceeded again.
        while let Some(&more) = best.checked_sub(1).and_then(|k| sum.get(k)) {
            self.search.team.harden(!more);
            loop {
                self.extend()?;
                let guards = self.search.guards();
                let assumptions: Vec<Lit> = guards.keys().copied().collect();
                match self.search.team.solve(&assumptions)? {
                    Outcome::Sat => break,
                    Outcome::Unsat(core) => {
                        let mut grown = false;
                        for lit in &core {
                            if let Some(&agent) = guards.get(lit) {
                                grown |= self.search.grow_further(agent, u32::MAX)?;
                            }
                        }
                        if !grown {
                            return Ok(true);
                        }
                    }
                }
            }
            let found = self.read();
            let fewer = self.entries(&found.walks);
            if fewer >= best {
                return Err(Stop::Contradiction);
            }
            best = fewer;
            *close = found;
        }
        Ok(true)
    }

    /// Entries that differ, arrived agents padded with their goals.
    fn entries(&self, walks: &[Walk]) -> usize {
        let mut count = 0;
        for (agent, (walk, before)) in walks.iter().zip(self.before).enumerate() {
            let goal = Place::At(self.problem.tasks[agent].goal);
            let at = |walk: &Walk, time: usize| walk.get(time).copied().unwrap_or(goal);
            let times = 0..walk.len().max(before.walk.len());
            count += times
                .filter(|&time| !is_same_entry(at(walk, time), at(&before.walk, time)))
                .count();
        }
        count
    }

    /// The plan of the last model.
    fn read(&mut self) -> Close {
        self.search.team.read();
        let team = &self.search.team;
        let same = self.traces.iter().enumerate().map(|(agent, trace)| {
            let held = trace.as_ref().map(|trace| team.is_true(trace.same));
            held.unwrap_or(!team.is_inside(agent))
        });
        Close {
            same: same.collect(),
            walks: team.walks.clone(),
            proved: false,
        }
    }

    /// Whether the clauses know every plan: where agents vanish they know none
    /// in which one comes to its end, leaves it and comes back.
    fn is_exact(&self) -> bool {
        let insiders = self.search.team.insiders();
        insiders.into_iter().all(|agent| {
            self.problem.rests(agent) || self.search.cap(agent) < self.problem.optima[agent] + 2
        })
    }
}

/// Whether two places are one entry of a path: in transit is in transit.
fn is_same_entry(a: Place, b: Place) -> bool {
    a == b || matches!((a, b), (Place::Along(_), Place::Along(_)))
}
