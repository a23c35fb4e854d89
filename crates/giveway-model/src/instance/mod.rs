//! A checked instance of the problem.

mod faults;
mod start_state;
mod variant;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use faults::{check_agent, check_shared, map_fault};
pub use start_state::{Breakdown, ClosedCell, StartState};

use crate::assumption::MAX_ASSUMPTIONS;
use crate::sorting::set;
use crate::{
    Agent, Assumption, AtGoal, Constraint, Cost, Fault, Grid, Objective, Rules, Scene, Units,
    Version, Zone,
    constraint::{InForce, TimedConstraint, in_force},
    tr,
};

/// The largest map side that is accepted, in cells.
pub const MAX_SIDE: u32 = 2048;
/// The largest number of agents that is accepted.
pub const MAX_AGENTS: usize = 10_000;
/// The largest battery capacity that is accepted, in time steps.
pub const MAX_CAPACITY: u32 = 1_000_000;

/// An instance that keeps all the promises of the problem: names are unique,
/// starts (and goals, where agents stay) are pairwise different, and every
/// start, goal and waypoint is a vertex. It is only built through [`Instance::new`];
/// its other methods keep the promises, so that a variant needs no second check.
///
/// ```
/// use giveway_model::{Instance, Scene};
/// let scene: Scene = serde_json::from_str(r#"{
///     "giveway": 1,
///     "map": ["..", ".."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 1] }]
/// }"#).unwrap();
/// let instance = Instance::new(scene).unwrap();
/// assert_eq!(instance.agents()[0].name, "A1");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instance {
    name: String,
    grid: Grid,
    rules: Rules,
    objective: Objective,
    agents: Vec<Agent>,
    assumptions: Vec<Assumption>,
    zones: Vec<Zone>,
    constraints: Vec<Constraint>,
    units: Option<Units>,
    /// The same rules as a person wrote them, of the rest of a running plan; else none.
    as_written: Arc<[TimedConstraint]>,
    /// By the agents' names; an agent that is not here has nothing behind it.
    start_states: BTreeMap<String, StartState>,
}

impl Instance {
    /// Checks a scene.
    ///
    /// # Errors
    /// Every fault that the scene has, in the order of its text: a map that is
    /// no rectangle, a name that is empty or used twice, a start, goal or
    /// waypoint off the map or in an obstacle, a waypoint listed twice, a start
    /// (or, where agents stay, a goal) shared by two agents, a battery that
    /// begins above its capacity, a size beyond the limits.
    pub fn new(scene: Scene) -> Result<Self, Vec<Fault>> {
        let grid = Grid::from_rows(&scene.map).map_err(|error| vec![map_fault(&scene, &error)])?;
        let mut faults = Vec::new();
        if grid.width() > MAX_SIDE || grid.height() > MAX_SIDE {
            faults.push(Fault::at(
                "map",
                tr!(
                    "a map of {width} x {height} cells",
                    width = grid.width(),
                    height = grid.height()
                ),
                tr!("at most {most} x {most}", most = MAX_SIDE),
            ));
        }
        if scene.agents.len() > MAX_AGENTS {
            faults.push(Fault::at(
                "agents",
                tr!("{n} robot" | "{n} robots" % scene.agents.len()),
                tr!("at most {most}", most = MAX_AGENTS),
            ));
        }
        if scene.assumptions.len() > MAX_ASSUMPTIONS {
            faults.push(Fault::at(
                "assumptions",
                scene.assumptions.len().to_string(),
                tr!("at most {most}", most = MAX_ASSUMPTIONS),
            ));
        }
        if faults.is_empty() {
            for i in 0..scene.agents.len() {
                check_agent(&scene.agents, i, &grid, &mut faults);
            }
            check_shared(&scene, &mut faults);
            crate::constraint::find(&scene, &grid, &mut faults);
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self {
            name: scene.name,
            grid,
            rules: scene.rules,
            objective: scene.objective,
            agents: scene.agents,
            assumptions: scene.assumptions,
            zones: scene.zones,
            constraints: scene.constraints,
            units: scene.units,
            as_written: Arc::default(),
            start_states: BTreeMap::new(),
        })
    }

    /// The name that a person gave it; may be empty.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The map.
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The rules.
    pub const fn rules(&self) -> Rules {
        self.rules
    }

    /// Whether arrived agents stay and block their goals.
    pub fn stays(&self) -> bool {
        self.rules.at_goal == AtGoal::Stay
    }

    /// Whether an agent remains where it arrives: all do where arrived agents stay,
    /// and one without a goal does in any case.
    pub fn keeps(&self, agent: &Agent) -> bool {
        self.rules.at_end_of(agent) == AtGoal::Stay
    }

    /// The costs to minimise, the most important first.
    pub const fn objective(&self) -> &Objective {
        &self.objective
    }

    /// The agents, in the order of the file.
    pub fn agents(&self) -> &[Agent] {
        &self.agents
    }

    /// The assumptions of the scene.
    pub fn assumptions(&self) -> &[Assumption] {
        &self.assumptions
    }

    /// The named parts of the map.
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// What a cell and a time step are in the world, where the scene says so.
    pub const fn units(&self) -> Option<Units> {
        self.units
    }

    /// The zone of a name.
    pub fn zone(&self, name: &str) -> Option<&Zone> {
        self.zones.iter().find(|zone| zone.name == name)
    }

    /// The rules of its own, in force or not.
    pub fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    /// A rule of its own as a person wrote it, by its number: of the rest of a running plan in
    /// times of the whole plan, with all that was to be done.
    pub fn rule_as_written(&self, rule: usize) -> Option<&Constraint> {
        let timed = self.as_written.get(rule);
        timed.map_or_else(|| self.constraints.get(rule), |it| Some(&it.constraint))
    }

    /// The time at which a change added a rule, by its number; `None` for one of the scene.
    pub fn rule_added_at(&self, rule: usize) -> Option<u32> {
        self.as_written.get(rule)?.since
    }

    /// The rules that forbid something, by number, ascending: those in force, and those of
    /// which only cells are left that are closed to an agent for what others did before.
    pub fn rules_in_effect(&self) -> BTreeSet<usize> {
        let in_force = self.constraints_in_force().map(|rule| rule.index);
        let states = self.agents.iter().map(|it| self.start_state(&it.name));
        let closed = states.flat_map(|state| &state.closed_cells);
        let closed = closed.map(|it| it.rule);
        set(in_force.chain(closed.filter(|&rule| rule < self.constraints.len())))
    }

    /// The rules of its own that are in force, with the agents that they bind.
    pub fn constraints_in_force(&self) -> impl Iterator<Item = InForce<'_>> {
        in_force(&self.constraints, &self.agents)
    }

    /// An objective as it is in force: where a rule makes something cost a penalty, and the
    /// objective does not name it, that comes last.
    #[must_use]
    pub fn in_force(&self, objective: Objective) -> Objective {
        let mut rules = self.constraints_in_force();
        if rules.any(|rule| rule.constraint.is_penalty()) {
            objective.with_last(Cost::Penalty)
        } else {
            objective
        }
    }

    /// Whether a rule of its own is in force.
    pub fn is_constrained(&self) -> bool {
        self.constraints_in_force().next().is_some()
    }

    /// Whether there are obstacles that move.
    pub fn has_moving_obstacles(&self) -> bool {
        let moves = |one: &Assumption| matches!(one, Assumption::MovingObstacle { .. });
        self.assumptions.iter().any(moves)
    }

    /// The same instance with more that it takes for granted; what it takes for granted already
    /// is not said twice.
    #[must_use]
    pub fn assuming(mut self, more: impl IntoIterator<Item = Assumption>) -> Self {
        for assumption in more {
            if !self.assumptions.contains(&assumption) && self.assumptions.len() < MAX_ASSUMPTIONS {
                self.assumptions.push(assumption);
            }
        }
        self
    }

    /// The same instance with another objective.
    #[must_use]
    pub fn with_objective(mut self, objective: Objective) -> Self {
        self.objective = objective;
        self
    }

    /// The instance as plain data again.
    pub fn to_scene(&self) -> Scene {
        Scene {
            giveway: Version,
            name: self.name.clone(),
            map: self.grid.rows(),
            rules: self.rules,
            objective: self.objective.clone(),
            agents: self.agents.clone(),
            assumptions: self.assumptions.clone(),
            zones: self.zones.clone(),
            constraints: self.constraints.clone(),
            units: self.units,
        }
    }
}
