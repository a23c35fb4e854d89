//! An instance as planners see it: a graph, tasks, exact distances.

use std::collections::BTreeSet;

use giveway_model::{Cost, Costs, Grid, Instance};

use crate::{
    bottleneck::Bottlenecks,
    budget::{Budget, Stop, Unlimited},
    rules::{Between, OwnRules, Precedence},
    single::{
        Bounds, CostToGo, MAX_WAYPOINTS, Mask, Metric, NoPlanAlone, Part, Place, Required, Task,
        earliest,
    },
    terrain::Terrain,
    walk::{Walk, costs_of},
};

/// The least agents of which it is counted what they need at a bottleneck, for the horizon.
const FEWEST_IN_QUEUE: usize = 4;

/// Rules between agents that do not count, by the agents' numbers: what an
/// explanation leaves out to see whether a plan exists without it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Relaxed {
    /// Pairs that ignore each other, the lower number first.
    pub ignored: BTreeSet<(usize, usize)>,
    /// Agents that are gone on arrival, where they would stay.
    pub gone: BTreeSet<usize>,
}

impl Relaxed {
    /// Whether two agents ignore each other.
    pub fn ignores(&self, a: usize, b: usize) -> bool {
        self.ignored.contains(&(a.min(b), a.max(b)))
    }
}

/// Everything that is known of an instance before agents meet.
pub struct Problem {
    /// The map as a graph.
    pub terrain: Terrain,
    /// Whether arrived agents stay at their goals, but for those that the
    /// relaxation lets go; [`Problem::rests`] tells it of an agent.
    pub stays: bool,
    /// Rules between agents that do not count.
    pub relaxed: Relaxed,
    /// The task of each agent.
    pub tasks: Vec<Task>,
    /// The time that each agent alone still needs, from anywhere.
    pub cost_to_go: Vec<CostToGo>,
    /// The earliest arrival of each agent alone; a lower bound of it where conditions are about
    /// very late times (see [`earliest`]).
    pub optima: Vec<u32>,
    /// Whether rules of the scene's own are in force, or obstacles move.
    pub is_constrained: bool,
    /// Rules of the scene's own between agents.
    pub between: Between,
    /// Which agents must be at a vertex before others.
    pub precedences: Vec<Precedence>,
    /// The largest of the optima and of the ends of breakdowns, without
    /// conditions; and the last time that a rule of the scene's own names.
    longest: u32,
}

/// Why an instance has no [`Problem`].
pub enum ProblemError {
    /// This agent cannot do its task, or what a question asks of it, even alone.
    Alone(usize, NoPlanAlone),
    /// This agent has more waypoints than the exact tables can bear.
    TooManyWaypoints(usize),
    /// The budget was spent.
    Stopped(Stop),
}

impl From<Stop> for ProblemError {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Problem {
    /// The problem of an instance.
    ///
    /// # Errors
    /// Where an agent alone decides it, or the budget is spent.
    pub fn new(instance: &Instance, budget: &dyn Budget) -> Result<Self, ProblemError> {
        Self::relaxed(instance, Relaxed::default(), budget)
    }

    /// The same with some rules between agents left out.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn relaxed(
        instance: &Instance,
        relaxed: Relaxed,
        budget: &dyn Budget,
    ) -> Result<Self, ProblemError> {
        Self::bounded(instance, relaxed, Vec::new(), budget)
    }

    /// The same with bounds on where the agents may go, in their order; without a bound
    /// an agent may go anywhere.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn bounded(
        instance: &Instance,
        relaxed: Relaxed,
        bounds: Vec<Bounds>,
        budget: &dyn Budget,
    ) -> Result<Self, ProblemError> {
        let mut bounds = bounds.into_iter();
        let mut problem = Self {
            terrain: Terrain::new(instance.grid()),
            stays: instance.stays(),
            relaxed,
            tasks: Vec::new(),
            cost_to_go: Vec::new(),
            optima: Vec::new(),
            is_constrained: instance.is_constrained() || instance.has_moving_obstacles(),
            between: Between::default(),
            precedences: Vec::new(),
            longest: 0,
        };
        let rules = OwnRules::new(instance, &problem.terrain);
        problem.between = rules.between();
        problem.precedences = rules.precedences(&problem.terrain);
        for (i, agent) in instance.agents().iter().enumerate() {
            let bounds = bounds.next().unwrap_or_default();
            let is_along = matches!(bounds, Bounds::Along(_));
            if agent.waypoints.len() > MAX_WAYPOINTS && !is_along {
                return Err(ProblemError::TooManyWaypoints(i));
            }
            let state = instance.start_state(&agent.name);
            let mut task =
                Task::resumed(agent, state, bounds, instance.rules(), &mut problem.terrain)
                    .map_err(|no_plan| ProblemError::Alone(i, no_plan))?;
            rules
                .impose(i, &mut task, &problem.terrain)
                .map_err(|no_plan| ProblemError::Alone(i, no_plan))?;
            problem.add(i, task, budget)?;
        }
        problem.longest = problem.longest().saturating_add(rules.last_time());
        Ok(problem)
    }

    /// The largest of the earliest arrivals and of the ends of breakdowns: others
    /// may have to wait for an agent that has arrived and broken down.
    fn longest(&self) -> u32 {
        let held = self.tasks.iter().map(|task| task.earliest_move);
        self.optima.iter().copied().chain(held).max().unwrap_or(0)
    }

    /// An agent's least part of the sum of costs, alone.
    pub fn least_cost(&self, agent: usize) -> u32 {
        match self.optima[agent] {
            0 => 0,
            optimum => optimum.saturating_add(self.tasks[agent].cost_if_it_leaves_goal),
        }
    }

    /// The latest arrival of an agent at which its part of the sum of costs is
    /// no more than this.
    pub fn time_of(&self, agent: usize, cost: u32) -> u32 {
        cost.saturating_sub(self.tasks[agent].cost_if_it_leaves_goal)
    }

    /// Adds an agent, or gives it another task.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn add(
        &mut self,
        agent: usize,
        task: Task,
        budget: &dyn Budget,
    ) -> Result<(), ProblemError> {
        if task.bits() > MAX_WAYPOINTS || !task.conditions.fits_into_masks() {
            return Err(ProblemError::TooManyWaypoints(agent));
        }
        let cost_to_go = CostToGo::new(&task, &self.terrain, Metric::Time, budget)?;
        let optimum = earliest(&task, &self.terrain, &cost_to_go, budget)?;
        let optimum = optimum.map_err(|no_plan| ProblemError::Alone(agent, no_plan))?;
        if agent < self.tasks.len() {
            self.tasks[agent] = task;
            self.cost_to_go[agent] = cost_to_go;
            self.optima[agent] = optimum;
        } else {
            self.tasks.push(task);
            self.cost_to_go.push(cost_to_go);
            self.optima.push(optimum);
        }
        Ok(())
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.tasks.len()
    }

    /// Whether an agent stays where it arrives and blocks that vertex; one without a
    /// goal does so also where the others vanish.
    pub fn rests(&self, agent: usize) -> bool {
        let keeps = self.stays || self.tasks[agent].goal.is_none();
        keeps && !self.relaxed.gone.contains(&agent)
    }

    /// Whether two agents must not collide.
    pub fn collide(&self, a: usize, b: usize) -> bool {
        a != b && !self.relaxed.ignores(a, b)
    }

    /// The latest arrival of an agent that its conditions allow.
    pub fn not_after(&self, agent: usize) -> u32 {
        self.tasks[agent].not_after()
    }

    /// Whether a walk of an agent, with so many charges, keeps to what is asked for
    /// beside its task, as far as walks made outside the SAT solver may fail to.
    pub fn keeps_alone(&self, agent: usize, walk: &Walk, charges: u32) -> bool {
        let task = &self.tasks[agent];
        task.conditions.parts().all(|part| match part {
            // Every search keeps to these.
            Part::Forbidden(_) | Part::Required(_, Required::Cross { .. }) => true,
            Part::Counter(_) => self.keeps_counts(agent, walk),
            Part::Required(_, Required::Charge { .. }) => {
                crate::walk::charges(task, &self.terrain, walk).is_some()
            }
            Part::Limit(cost, most) => {
                let own = Costs {
                    charges,
                    ..costs_of(self, agent, walk)
                };
                own.get(cost) <= most
            }
        })
    }

    /// Whether the counters of an agent allow all steps of a walk, and its end.
    fn keeps_counts(&self, agent: usize, walk: &Walk) -> bool {
        let task = &self.tasks[agent];
        let masks = self.follow(agent, walk);
        match (masks.last(), walk.last()) {
            (Some(&mask), Some(&Place::At(v))) if masks.len() == walk.len() => {
                let now = walk.len() as u32 - 1;
                task.conditions.may_end(mask, v, now)
            }
            _ => false,
        }
    }

    /// How far an agent has come at each time of a walk; up to a step that its counters
    /// forbid.
    fn follow(&self, agent: usize, walk: &[Place]) -> Vec<Mask> {
        let task = &self.tasks[agent];
        let first = task.first().map(|state| state.mask);
        let mut masks = Vec::from_iter(first);
        for (pair, now) in walk.windows(2).zip(0..) {
            let Some(&mask) = masks.last() else { break };
            let counted = task.counted(&self.terrain, mask, [pair[0], pair[1]], now);
            let Some(mut mask) = counted else { break };
            if let Place::At(v) = pair[1] {
                mask |= task.bit(v);
            }
            masks.push(mask);
        }
        masks
    }

    /// The same, where rules between agents ask for it; else nothing is known of how far it
    /// came.
    pub(crate) fn masks_of(&self, agent: usize, walk: &[Place]) -> Vec<Mask> {
        let mut rules = self.between.rules.iter();
        let asks = !self.precedences.is_empty() || rules.any(|rule| !rule.uncounted.is_empty());
        if !asks {
            return vec![0; walk.len()];
        }
        let mut masks = self.follow(agent, walk);
        masks.resize(walk.len(), masks.last().copied().unwrap_or(0));
        masks
    }

    /// The largest number of which each weight of a penalty is a multiple; 1 where there is
    /// none.
    pub fn penalty_unit(&self) -> u32 {
        let weights = self.tasks.iter().flat_map(Task::weights);
        weights.fold(0, greatest_common_divisor).max(1)
    }

    /// Whether there are rules between agents beside that they must not collide.
    pub fn has_rules_between(&self) -> bool {
        !self.between.is_empty() || !self.precedences.is_empty()
    }

    /// Whether such a rule binds an agent.
    pub fn has_rules_between_with(&self, agent: usize) -> bool {
        let orders = &mut self.precedences.iter();
        self.between.rules.iter().any(|rule| rule.binds(agent))
            || orders.any(|order| order.first.0 == agent || order.second.0 == agent)
    }

    /// A number of steps that no plan needs to exceed: one with more comes to
    /// the same joint state twice, and what lies between can be left out, which
    /// makes no cost higher. `None` where the number is too large to be of use.
    pub fn sufficient_horizon(&self) -> Option<u32> {
        let slow = (0..self.terrain.size() as u32).flat_map(|v| self.terrain.arcs(v));
        let places = self.terrain.size() + slow.filter(|arc| arc.slow).count();
        let mut states: u32 = 1;
        let mut timed = self.between.last_time().unwrap_or(0);
        for task in &self.tasks {
            // On the way; and at the end, one step or more.
            let way = [
                places + 1,
                task.masks(),
                task.levels(),
                task.conditions.counts(),
            ]
            .iter()
            .try_fold(1u32, |product, &factor| {
                product.checked_mul(u32::try_from(factor).ok()?)
            })?;
            let ends = u32::try_from(task.goal.map_or(self.terrain.size(), |_| 1)).ok()?;
            states = states.checked_mul(way.checked_add(ends.checked_mul(2)?)?)?;
            let resting = task.not_resting.iter().map(|&(_, time)| time);
            let times = resting.chain(task.last_time()).chain([task.not_before]);
            timed = times.fold(timed, u32::max);
        }
        // A gap remembers where the agents were, a precedence whether the first has been there.
        states = states.checked_pow(self.between.gap().checked_add(1)?)?;
        states = states.checked_mul(2u32.checked_pow(self.precedences.len() as u32)?)?;
        // The conditions differ at each of these times.
        states.checked_add(timed)?.checked_add(2)
    }

    /// The makespan beyond which nothing is looked for, by default. Where agents under rules need
    /// more at a bottleneck, it is as much later than that.
    pub fn default_horizon(&self, grid: &Grid) -> u32 {
        let around = 4 * (grid.width() + grid.height()) + 10;
        let default = self.longest.saturating_add(around);
        if !self.has_rules_between() {
            return default;
        }
        let queues = Bottlenecks::of(self, FEWEST_IN_QUEUE, &Unlimited::default());
        let queues = queues.unwrap_or_default();
        match queues.bound(self, Cost::Makespan, None) {
            Some(queue) if queue.at_least > default => queue.at_least.saturating_add(around),
            _ => default,
        }
    }
}

const fn greatest_common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
