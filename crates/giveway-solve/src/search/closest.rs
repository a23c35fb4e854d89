//! Of all plans as good as the best, one that is close to a given plan.
//!
//! First as few agents as can be do something else ([`agents`]); then as few
//! entries as can be differ ([`entries`]). What either needs of the agents inside
//! the SAT solver is written by [`clauses`], as their MDDs grow.

mod agents;
mod clauses;
mod entries;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::Cost;

use super::{
    aim::Bounded,
    deadlines::Keeping,
    for_ever::{self, Reach},
    incumbent::Incumbent,
    stage::{Search, Subject},
};
use crate::{
    budget::{Budget, Stop},
    encode::{agent::Added, collisions::AgentId},
    problem::Problem,
    sat::{Clauses, Lit},
    single::{Place, TaskConstraint},
    walk::{Walk, arrival, costs_of, crossed},
};
use agents::SoftAgent;
use clauses::Written;

/// What is to be as small as can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// The number of agents that do something else.
    Agents,
    /// Then the number of entries that differ.
    Entries,
}

/// What one agent does in the given plan; its walk is empty where it is not
/// there.
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
    /// How far it is proved that none is closer, if it is.
    pub(crate) proved: Option<Reach>,
}

/// The proof that no plan within the limits is closer. Only the search for the
/// closest one makes it, when it has come to its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct NoneCloser(());

/// The closest plan within the limits, which the best plan meets; `None` where
/// the budget ran out before any was found.
///
/// # Errors
/// When the budget is spent before there is any.
pub(crate) fn closest(
    problem: &Problem,
    before: &[Before],
    bounded: &Bounded,
    extent: Extent,
    budget: &Rc<Budget>,
) -> Result<Option<Close>, Stop> {
    let objective = giveway_model::Objective::default();
    let latest = bounded.horizon.latest();
    let mut incumbent = Incumbent::new(objective, latest, bounded.limits.clone(), &|_| {});
    let walks: Vec<Walk> = before.iter().map(|it| it.walk.clone()).collect();
    let subject = Subject {
        problem,
        walks: &walks,
        bounded,
    };
    let search = Search::new(subject, Keeping::Hard, &mut incumbent, Rc::clone(budget));
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
    let Some(shown) = near.find(bounded)? else {
        return Ok(None);
    };
    let mut close = near.read();
    if extent == Extent::Agents {
        close.proved = near.reach(Some(shown));
        return Ok(Some(close));
    }
    // What is found later is only better.
    let shown = near.few_entries(&mut close).ok().flatten();
    close.proved = near.reach(shown);
    Ok(Some(close))
}

/// The given walk of an inside agent, as nodes of its MDD.
struct Trace {
    nodes: Vec<(Place, u32)>,
    /// It does as before.
    same: Lit,
}

struct Near<'p, 'h> {
    problem: &'p Problem,
    before: &'p [Before],
    search: Search<'p, 'h, 'p>,
    traces: Vec<Option<Trace>>,
    written: Vec<Written>,
    /// "Its entry at this time differs", of inside agents, once they count.
    differs: BTreeMap<AgentId, Vec<Lit>>,
    softs: BTreeMap<Lit, SoftAgent>,
    cores: Vec<Vec<Lit>>,
}

impl Near<'_, '_> {
    /// Finds a plan in which as few agents as can be do something else; `None`
    /// where there is none.
    fn find(&mut self, bounded: &Bounded) -> Result<Option<NoneCloser>, Stop> {
        if self.search.keep_limits(bounded)?.is_some() {
            return Ok(None);
        }
        self.begin(bounded)?;
        self.few_agents()
    }

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
                    Cost::SumOfCosts => self.problem.least_cost(agent),
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
                self.softs.insert(lit, SoftAgent::Outside(agent));
            }
        }
        for agent in entering {
            if let Some(same) = self.enter(agent)? {
                self.softs.insert(same, SoftAgent::Inside);
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
        let demanded = match task.demand {
            Some(TaskConstraint::Charge { v, .. }) => charged(v),
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
        while self.problem.rests(agent) && latest < self.search.latest() {
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
            proved: None,
        }
    }

    /// How far what was found is proved, where it is.
    fn reach(&self, shown: Option<NoneCloser>) -> Option<Reach> {
        let shown = shown.filter(|_| self.is_exact())?;
        Some(for_ever::none_closer(&self.search, shown))
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
