//! A method at the time of a change: the agents that are held to it, and the problem
//! from then on.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Agent, Objective,
    snapshot::{RunningAgent, Snapshot},
};

use super::{
    CauseKind, Method,
    keep::{self, MethodRefusal},
};
use crate::{
    budget::{Budget, Stop},
    problem::{NeverAlone, Problem, ProblemError},
    search::{Bounded, ForEver, Horizon, NoPlan},
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
}
