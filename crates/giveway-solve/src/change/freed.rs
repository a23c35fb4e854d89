//! Which agents to free, where a method leaves no plan: as few as can be.
//!
//! Freeing more agents never takes a plan away. So every set of agents that are
//! held to the method and have no plan, a *core*, must have one of them freed:
//! the fewest to free are a smallest set that meets all cores. Cores are found
//! as they are needed (the implicit hitting set algorithm), each made minimal
//! by freeing its agents one by one.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::sorting;

use super::{
    Method, keep,
    method_case::{MethodCase, Trouble},
};
use crate::{
    budget::Stop,
    hitting::{MOST_SETS, hitting},
    problem::{Problem, ProblemError},
    search::{Aim, Bounded, Horizon, Proved, find},
};

impl MethodCase<'_, '_> {
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
