//! Which agents to free, where a method leaves no plan: as few as can be.
//!
//! Freeing more agents never takes a plan away. So every set of agents that are
//! held to the method and have no plan, a *core*, must have one of them freed:
//! the fewest to free are a smallest set that meets all cores. Cores are found
//! as they are needed (the implicit hitting set algorithm), each made minimal
//! by freeing its agents one by one.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Objective, sorting};

use super::{
    CauseKind, Method,
    hitting::{MOST_SETS, hitting},
    keep::{self, Fault},
    world::{Member, World},
};
use crate::{
    budget::{Budget, Stop},
    problem::{Problem, ProblemError},
    search::{Aim, Bounded, ForEver, Horizon, find},
    single::{Bounds, Hopeless, Task},
};

/// A method at the time of a change.
pub(super) struct Case<'a, 'h> {
    pub(super) world: &'a World<'a>,
    pub(super) method: Method,
    pub(super) objective: &'a Objective,
    /// The latest arrival from now on, where a person set one.
    pub(super) within: Option<u32>,
    pub(super) budget: Rc<Budget<'h>>,
}

/// Why there is nothing to search in.
#[derive(Clone, Copy, Debug)]
pub(super) enum Trouble {
    /// An agent cannot be held to what the method asks of it.
    Held(usize, Fault),
    /// An agent cannot do what is asked of it, whatever the others do; and why
    /// that holds whatever the horizon.
    Alone(usize, Fault, ForEver),
    /// An agent has more waypoints than can be planned for.
    TooManyWaypoints(usize),
    Stopped(Stop),
}

impl From<Stop> for Trouble {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Case<'_, '_> {
    pub(super) fn member(&self, agent: usize) -> Option<&Member> {
        self.world.members.get(agent)
    }

    /// The old agents that are held to the method.
    pub(super) fn held(&self, freed: &BTreeSet<usize>) -> Vec<usize> {
        let agents = 0..self.world.members.len();
        agents
            .filter(|agent| self.member(*agent).is_some_and(|member| member.is_old))
            .filter(|agent| self.method != Method::Replan && !freed.contains(agent))
            .collect()
    }

    /// The problem from now on, these agents freed.
    pub(super) fn problem(&self, freed: &BTreeSet<usize>) -> Result<Problem, Trouble> {
        let mut terrain = self.world.terrain();
        let mut tasks: Vec<Task> = Vec::new();
        let battery = |agent, hopeless: Hopeless| {
            let kind = CauseKind::Battery;
            Trouble::Alone(agent, Fault { kind, cell: None }, hopeless.into())
        };
        for (agent, member) in self.world.members.iter().enumerate() {
            if let Some((fault, hopeless)) = keep::blocked(member, &terrain) {
                return Err(Trouble::Alone(agent, fault, hopeless.into()));
            }
            let bounds = if freed.contains(&agent) {
                Bounds::Free
            } else {
                keep::bounds(self.method, member, &terrain)
                    .map_err(|fault| Trouble::Held(agent, fault))?
            };
            let task = self.world.task(member, bounds, &mut terrain);
            tasks.push(task.map_err(|hopeless| battery(agent, hopeless))?);
        }
        let stays = self.world.after.stays();
        Problem::of_tasks(terrain, stays, tasks, &self.budget).map_err(|error| match error {
            ProblemError::Alone(agent, reason) => {
                Trouble::Alone(agent, self.alone(agent, freed), reason)
            }
            ProblemError::TooManyWaypoints(agent) => Trouble::TooManyWaypoints(agent),
            ProblemError::Stopped(stop) => Trouble::Stopped(stop),
        })
    }

    /// Why an agent cannot even alone.
    fn alone(&self, agent: usize, freed: &BTreeSet<usize>) -> Fault {
        let terrain = self.world.terrain();
        let none = |kind| Fault { kind, cell: None };
        let Some(member) = self.member(agent) else {
            return none(CauseKind::NoWay);
        };
        if !freed.contains(&agent)
            && let Some(fault) = keep::obstacle(member, &terrain)
        {
            return fault;
        }
        none(if member.has_battery() {
            CauseKind::Battery
        } else {
            CauseKind::NoWay
        })
    }

    /// What is looked for in a problem.
    pub(super) fn bounded(&self, problem: &Problem) -> Bounded {
        let grid = self.world.after.grid(self.world.at);
        Bounded {
            horizon: Horizon::of(problem, grid, self.within, 0),
            limits: BTreeMap::new(),
        }
    }

    /// Whether there is a plan with these agents freed.
    fn exists(&self, freed: &BTreeSet<usize>) -> Result<bool, Stop> {
        if self.is_deadlocked(freed)? {
            return Ok(false);
        }
        let problem = match self.problem(freed) {
            Ok(problem) => problem,
            Err(Trouble::Stopped(stop)) => return Err(stop),
            Err(_) => return Ok(false),
        };
        let bounded = self.bounded(&problem);
        let verdict = find(&problem, self.objective, &bounded, &Aim::Any, &self.budget);
        match (verdict.best, verdict.stop) {
            (Some(_), _) => Ok(true),
            (None, Some(stop)) => Err(stop),
            (None, None) => Ok(false),
        }
    }

    /// Whether the agents that keep to their old paths block each other for
    /// good, all others and batteries aside: without waits of all of them at
    /// once they would be done, or never, within two steps an edge.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn is_deadlocked(&self, freed: &BTreeSet<usize>) -> Result<bool, Stop> {
        let held = self.held(freed);
        if self.method != Method::Revise || held.len() < 2 {
            return Ok(false);
        }
        let mut terrain = self.world.terrain();
        let mut tasks = Vec::new();
        let mut steps = 1;
        for member in held.iter().filter_map(|&agent| self.member(agent)) {
            let Ok(bounds) = keep::bounds(self.method, member, &terrain) else {
                return Ok(false);
            };
            let Ok(task) = self.world.task(member, bounds, &mut terrain) else {
                return Ok(false);
            };
            let edges = task.along().map_or(0, |path| path.len().saturating_sub(1));
            steps += 2 * edges as u32 + task.held + task.delay();
            tasks.push(Task {
                reserve: None,
                ..task
            });
        }
        let stays = self.world.after.stays();
        let problem = match Problem::of_tasks(terrain, stays, tasks, &self.budget) {
            Ok(problem) => problem,
            Err(ProblemError::Stopped(stop)) => return Err(stop),
            Err(_) => return Ok(false),
        };
        let bounded = Bounded {
            horizon: Horizon::at(steps),
            limits: BTreeMap::new(),
        };
        let verdict = find(&problem, self.objective, &bounded, &Aim::Any, &self.budget);
        match verdict.stop {
            Some(stop) if verdict.best.is_none() => Err(stop),
            _ => Ok(verdict.best.is_none()),
        }
    }

    /// Agents that, held to the method, leave no plan, where all others are
    /// free: none of them can be left out.
    fn core(&self, freed: &BTreeSet<usize>) -> Result<BTreeSet<usize>, Stop> {
        let all = sorting::set(self.held(&BTreeSet::new()));
        let mut core = sorting::set(all.difference(freed).copied());
        for agent in core.clone() {
            core.remove(&agent);
            let others = sorting::set(all.difference(&core).copied());
            if self.exists(&others)? {
                core.insert(agent);
            }
        }
        Ok(core)
    }

    /// The smallest sets of agents to free beside those given, with which there
    /// is a plan, and the first core; `None` where there is no plan even if all
    /// are free.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn fewest(&self, given: &BTreeSet<usize>) -> Result<Option<Fewest>, Stop> {
        let old = (0..self.world.members.len())
            .filter(|&agent| self.member(agent).is_some_and(|member| member.is_old));
        let all = sorting::set(old);
        if !self.exists(&all)? {
            return Ok(None);
        }
        let mut cores: Vec<BTreeSet<usize>> = vec![self.core(given)?];
        let mut size = 1;
        loop {
            let sets = hitting(&cores, size, &self.budget)?;
            let (mut good, mut tried) = (Vec::new(), 0);
            let mut left = (sets.len() > MOST_SETS).then_some(Stop::Sets);
            let known = cores.len();
            for set in sets {
                if !cores.iter().all(|core| !core.is_disjoint(&set)) {
                    continue; // it does not meet a core found meanwhile
                }
                let freed = sorting::set(given.union(&set).copied());
                tried += 1;
                match self.exists(&freed) {
                    Ok(true) => good.push(freed),
                    Ok(false) => match self.core(&freed) {
                        Ok(core) => cores.push(core),
                        Err(stop) if good.is_empty() => return Err(stop),
                        Err(stop) => left = Some(stop),
                    },
                    Err(stop) if good.is_empty() => return Err(stop),
                    Err(stop) => left = Some(stop),
                }
                if left.is_some_and(|left| left != Stop::Sets) {
                    break; // those at hand are told
                }
            }
            if let Some(core) = cores.first()
                && !good.is_empty()
            {
                return Ok(Some(Fewest {
                    sets: good,
                    core: core.iter().copied().collect(),
                    left,
                }));
            }
            if tried == 0 || cores.len() == known {
                size += 1;
            }
            if size > all.len() {
                return Ok(None);
            }
        }
    }
}

/// As few agents to free as can be.
pub(super) struct Fewest {
    /// Equally small sets, each with a plan.
    pub(super) sets: Vec<BTreeSet<usize>>,
    /// Agents that block each other.
    pub(super) core: Vec<usize>,
    /// Why some sets were not looked at, where some were not.
    pub(super) left: Option<Stop>,
}
