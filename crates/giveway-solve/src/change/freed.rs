//! Which agents to free, where a method leaves no plan: as few as can be.
//!
//! Freeing more agents never takes a plan away. So every set of agents that are
//! held to the method and have no plan, a *core*, must have one of them freed:
//! the fewest to free are a smallest set that meets all cores. Cores are found
//! as they are needed (the implicit hitting set algorithm), each made minimal
//! by freeing its agents one by one.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Agent, Objective,
    snapshot::{RunningAgent, Snapshot},
    sorting,
};

use super::{
    CauseKind, Method,
    keep::{self, MethodRefusal},
};
use crate::{
    budget::{Budget, Stop},
    hitting::{MOST_SETS, hitting},
    problem::{NeverAlone, Problem, ProblemError},
    search::{Aim, Bounded, ForEver, Horizon, NoPlan, Proved, find},
    single::Bounds,
    terrain::Terrain,
};

/// A method at the time of a change.
pub(super) struct MethodCase<'a, 'h> {
    pub(super) snapshot: &'a Snapshot<'a>,
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
    Held(usize, MethodRefusal),
    /// An agent cannot do what is asked of it, whatever the others do; and why
    /// that holds whatever the horizon.
    Alone(usize, MethodRefusal, ForEver<NoPlan>),
    /// An agent has more waypoints than can be planned for.
    TooManyWaypoints(usize),
    Stopped(Stop),
}

impl From<Stop> for Trouble {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl MethodCase<'_, '_> {
    /// An agent, and what the running plan has it do.
    pub(super) fn agent(&self, agent: usize) -> Option<(&Agent, &RunningAgent)> {
        let snapshot = self.snapshot;
        snapshot
            .instance
            .agents()
            .get(agent)
            .zip(snapshot.agents.get(agent))
    }

    pub(super) fn name(&self, agent: usize) -> &str {
        self.agent(agent)
            .map_or("", |(agent, _)| agent.name.as_str())
    }

    /// The map of now.
    pub(super) fn terrain(&self) -> Terrain {
        Terrain::new(self.snapshot.instance.grid())
    }

    /// The old agents that are held to the method.
    pub(super) fn held(&self, freed: &BTreeSet<usize>) -> Vec<usize> {
        let agents = 0..self.snapshot.agents.len();
        agents
            .filter(|agent| {
                self.agent(*agent)
                    .is_some_and(|(_, running)| running.is_old)
            })
            .filter(|agent| self.method != Method::Replan && !freed.contains(agent))
            .collect()
    }

    /// The problem from now on, these agents freed.
    pub(super) fn problem(&self, freed: &BTreeSet<usize>) -> Result<Problem, Trouble> {
        let terrain = self.terrain();
        let mut bounds = Vec::new();
        let agents = self.snapshot.instance.agents().iter();
        for (number, (agent, running)) in agents.zip(&self.snapshot.agents).enumerate() {
            if let Some((fault, never)) = keep::blocked(agent, &terrain) {
                return Err(Trouble::Alone(
                    number,
                    fault,
                    NeverAlone::Task(never).into(),
                ));
            }
            bounds.push(if freed.contains(&number) {
                Bounds::Free
            } else {
                keep::bounds(self.method, agent, running, &terrain)
                    .map_err(|fault| Trouble::Held(number, fault))?
            });
        }
        let problem = Problem::bounded(&self.snapshot.instance, bounds.clone(), &self.budget);
        problem.map_err(|error| match error {
            ProblemError::Alone(agent, reason) => {
                Trouble::Alone(agent, self.alone(agent, freed, bounds), reason.into())
            }
            ProblemError::TooManyWaypoints(agent) => Trouble::TooManyWaypoints(agent),
            ProblemError::Stopped(stop) => Trouble::Stopped(stop),
        })
    }

    /// Why an agent cannot even alone: an obstacle on the path that it is held to, a rule of
    /// the scene's own or its battery where it could without, or nothing that has a name.
    fn alone(&self, number: usize, freed: &BTreeSet<usize>, bounds: Vec<Bounds>) -> MethodRefusal {
        let none = |kind| MethodRefusal {
            kind,
            cell: None,
            rule: None,
        };
        let Some((agent, running)) = self.agent(number) else {
            return none(CauseKind::NoWay);
        };
        if self.method == Method::Revise
            && !freed.contains(&number)
            && let Some(fault) = keep::obstacle(&running.cells(), &self.terrain())
        {
            return fault;
        }
        if let Some(fault) = self.unkept_rule(number, &bounds) {
            return fault;
        }
        none(
            if agent.battery.is_some() && self.could_without(number, bounds) {
                CauseKind::Battery
            } else {
                CauseKind::NoWay
            },
        )
    }

    /// Whether an agent could do its task alone, if it had no battery.
    fn could_without(&self, number: usize, bounds: Vec<Bounds>) -> bool {
        let mut instance = self.snapshot.instance.clone();
        instance.drop_battery(number);
        match Problem::bounded(&instance, bounds, &self.budget) {
            Ok(_) => true,
            Err(ProblemError::Alone(agent, _)) => agent != number,
            Err(ProblemError::TooManyWaypoints(_) | ProblemError::Stopped(_)) => false,
        }
    }

    /// The bounds of a plan in a problem.
    pub(super) fn bounded(&self, problem: &Problem) -> Bounded {
        let grid = self.snapshot.instance.grid();
        Bounded {
            horizon: Horizon::of(problem, grid, self.within, 0),
            limits: BTreeMap::new(),
        }
    }

    /// Whether there is a plan with these agents freed.
    pub(super) fn exists(&self, freed: &BTreeSet<usize>) -> Result<Exists, Stop> {
        if self.is_deadlocked(freed)? {
            return Ok(Exists::No { within: None });
        }
        let problem = match self.problem(freed) {
            Ok(problem) => problem,
            Err(Trouble::Stopped(stop)) => return Err(stop),
            Err(Trouble::TooManyWaypoints(_)) => return Err(Stop::ManyWaypoints),
            Err(Trouble::Alone(..) | Trouble::Held(..)) => return Ok(Exists::No { within: None }),
        };
        let bounded = self.bounded(&problem);
        let verdict = find(&problem, self.objective, &bounded, &Aim::Any, &self.budget);
        match (verdict.best, verdict.stop) {
            (Some(_), _) => Ok(Exists::Yes),
            (None, Some(stop)) => Err(stop),
            (None, None) => Ok(Exists::No {
                within: verdict.reach.and_then(Proved::within),
            }),
        }
    }

    /// Whether the agents that keep to their old paths block each other for
    /// good, all others, batteries and rules of the scene's own aside: without waits of
    /// all of them at once they would be done, or never, within two steps an edge.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn is_deadlocked(&self, freed: &BTreeSet<usize>) -> Result<bool, Stop> {
        let held = self.held(freed);
        if self.method != Method::Revise || held.len() < 2 {
            return Ok(false);
        }
        let terrain = self.terrain();
        let mut instance = self.snapshot.instance.clone();
        let names = sorting::set(held.iter().map(|&number| self.name(number)));
        instance.retain_agents(|agent| names.contains(agent.name.as_str()));
        instance.switch_off(|_| true);
        let mut bounds = Vec::new();
        let mut steps = 1;
        for (i, (agent, running)) in held.iter().filter_map(|&it| self.agent(it)).enumerate() {
            let Ok(own) = keep::bounds(self.method, agent, running, &terrain) else {
                return Ok(false);
            };
            let state = instance.start_state(&agent.name);
            let edges = running.cells().len().saturating_sub(1) as u32;
            let transit = u32::from(state.transit_from.is_some());
            steps += 2 * edges + state.not_before() + transit;
            instance.drop_battery(i);
            bounds.push(own);
        }
        let problem = match Problem::bounded(&instance, bounds, &self.budget) {
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
    fn core(
        &self,
        freed: &BTreeSet<usize>,
        within: &mut ShownUntil,
    ) -> Result<BTreeSet<usize>, Stop> {
        let all = sorting::set(self.held(&BTreeSet::new()));
        let mut core = sorting::set(all.difference(freed).copied());
        for agent in core.clone() {
            core.remove(&agent);
            let others = sorting::set(all.difference(&core).copied());
            match self.exists(&others)? {
                Exists::Yes => {
                    core.insert(agent);
                }
                Exists::No { within: own } => within.and(own),
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
        let agents = self.snapshot.agents.iter().enumerate();
        let old = agents
            .filter(|(_, running)| running.is_old)
            .map(|(number, _)| number);
        let all = sorting::set(old);
        if matches!(self.exists(&all)?, Exists::No { .. }) {
            return Ok(None);
        }
        let mut within = ShownUntil::default();
        let mut cores: Vec<BTreeSet<usize>> = vec![self.core(given, &mut within)?];
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
                    Ok(Exists::Yes) => good.push(freed),
                    Ok(Exists::No { within: own }) => {
                        within.and(own);
                        match self.core(&freed, &mut within) {
                            Ok(core) => cores.push(core),
                            Err(stop) if good.is_empty() => return Err(stop),
                            Err(stop) => left = Some(stop),
                        }
                    }
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
                    within: within.0,
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
    /// The latest arrival, from now on, up to which smaller sets were shown to leave no plan;
    /// `None` where they leave none at all.
    pub(super) within: Option<u32>,
}

/// Whether there is a plan.
pub(super) enum Exists {
    Yes,
    /// None up to a latest arrival, or none at all.
    No {
        within: Option<u32>,
    },
}

/// The latest arrival up to which several things are shown; without end where it is `None`.
#[derive(Default)]
struct ShownUntil(Option<u32>);

impl ShownUntil {
    fn and(&mut self, within: Option<u32>) {
        self.0 = self.0.into_iter().chain(within).min();
    }
}
