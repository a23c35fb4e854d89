//! The parts of an instance and of a plan that a format cannot hold.
//!
//! Each writer declares the [`Part`]s that its format holds; everything else that
//! is there is a [`Loss`], which is named when it writes.

use std::fmt;

use giveway_model::words::count;
use giveway_model::{Agent, Assumption, AtGoal, Ground, Instance, Objective, Plan};

/// A part of an instance or a plan that not every format holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Cells of the slow zone: they become free cells.
    SlowZone,
    /// Chargers: they become free cells.
    Chargers,
    /// Waypoints of agents.
    Waypoints,
    /// Batteries of agents, and the floor with them.
    Batteries,
    /// Agents that may rest at any cell: the end of the plan becomes their goal.
    NoGoal,
    /// Agents that vanish at their goals.
    Vanish,
    /// An objective other than the default.
    Objective,
    /// Names of agents other than `A1`, `A2` and so on in order.
    Names,
    /// Obstacles that move.
    Moving,
    /// Named parts of the map.
    Zones,
    /// Rules of the scene's own.
    Constraints,
    /// Directions in which agents face at first.
    Headings,
    /// The times at which agents charge.
    Charges,
    /// Agents that join later than at time 0: they wait where they enter.
    Joining,
    /// Agents that are removed: they remain where they were.
    Removal,
    /// The last change of the world that the plan takes into account.
    Knows,
    /// The times that agents slept through, arrived, before a change.
    Slept,
}

/// A part of an instance or a plan that is lost when it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loss {
    /// The part.
    pub part: Part,
    /// How many cells, agents or obstacles have it; 1 for the whole.
    pub count: usize,
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cells = || count(self.count, "cell");
        let robots = || count(self.count, "robot");
        match self.part {
            Part::SlowZone => write!(f, "the slow zone ({})", cells()),
            Part::Chargers => write!(f, "the chargers ({})", cells()),
            Part::Waypoints => write!(f, "the waypoints of {}", robots()),
            Part::Batteries => write!(f, "the batteries of {}", robots()),
            Part::NoGoal => write!(
                f,
                "that {} may rest at any cell (the end of the plan is the goal)",
                robots()
            ),
            Part::Vanish => f.write_str("that robots vanish at their goals"),
            Part::Objective => f.write_str("the objective"),
            Part::Names => write!(f, "the names of {}", robots()),
            Part::Moving => f.write_str(&count(self.count, "moving obstacle")),
            Part::Zones => f.write_str(&count(self.count, "zone")),
            Part::Constraints => write!(f, "{} of the scene's own", count(self.count, "rule")),
            Part::Headings => write!(f, "where {} face at first", robots()),
            Part::Charges => write!(f, "the charges of {}", robots()),
            Part::Joining => write!(f, "the later entry of {}", robots()),
            Part::Removal => write!(f, "the removal of {}", robots()),
            Part::Knows => f.write_str("which changes the plan takes into account"),
            Part::Slept => write!(f, "the sleep of {} before a change", robots()),
        }
    }
}

/// The parts of an instance and of a plan that are lost in a format that holds these parts. The name of the
/// instance is that of the files.
pub fn losses(holds: &[Part], instance: Option<&Instance>, plan: Option<&Plan>) -> Vec<Loss> {
    let of_instance = instance.map(instance_parts).into_iter().flatten();
    of_instance
        .chain(plan.map(plan_parts).into_iter().flatten())
        .map(|(part, count)| Loss { part, count })
        .filter(|loss| loss.count > 0 && !holds.contains(&loss.part))
        .collect()
}

/// How much an instance has of each part.
fn instance_parts(instance: &Instance) -> [(Part, usize); 12] {
    let cells = |is: fn(Ground) -> bool| {
        let grounds = instance.grid().cells().map(|(_, ground)| ground);
        grounds.filter(|&ground| is(ground)).count()
    };
    let agents = |is: fn(usize, &Agent) -> bool| {
        let agents = instance.agents().iter().enumerate();
        agents.filter(|&(i, agent)| is(i, agent)).count()
    };
    let is_moving = |one: &&Assumption| matches!(one, Assumption::MovingObstacle { .. });
    let vanish = instance.rules().at_goal == AtGoal::Vanish;
    let objective = *instance.objective() != Objective::default();
    [
        (Part::SlowZone, cells(Ground::is_slow)),
        (Part::Chargers, cells(Ground::is_charger)),
        (Part::Waypoints, agents(|_, it| !it.waypoints.is_empty())),
        (Part::Batteries, agents(|_, it| it.battery.is_some())),
        (Part::NoGoal, agents(|_, it| it.goal.is_none())),
        (Part::Vanish, usize::from(vanish)),
        (Part::Objective, usize::from(objective)),
        (
            Part::Names,
            agents(|i, it| it.name != format!("A{}", i + 1)),
        ),
        (
            Part::Moving,
            instance.assumptions().iter().filter(is_moving).count(),
        ),
        (Part::Zones, instance.zones().len()),
        (Part::Constraints, instance.constraints().len()),
        (Part::Headings, agents(|_, it| it.heading.is_some())),
    ]
}

/// How much a plan has of each part.
fn plan_parts(plan: &Plan) -> [(Part, usize); 5] {
    let charges = plan.charges.values().filter(|all| !all.is_empty());
    let slept = plan.slept.values().filter(|all| !all.is_empty());
    [
        (Part::Charges, charges.count()),
        (
            Part::Joining,
            plan.from.values().filter(|&&from| from > 0).count(),
        ),
        (Part::Removal, plan.until.len()),
        (Part::Knows, usize::from(plan.knows.is_some())),
        (Part::Slept, slept.count()),
    ]
}
