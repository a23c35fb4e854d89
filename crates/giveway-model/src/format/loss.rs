//! What a format cannot hold of an instance and of a plan.
//!
//! Each writer declares the [`Part`]s that its format holds; everything else that
//! is there is a [`Loss`], which is named when it writes.

use std::fmt;

use crate::words::count;
use crate::{Agent, AtGoal, Ground, Instance, Objective, Plan};

/// A part of an instance or a plan that not every format holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Cells of the slow zone.
    SlowZone,
    /// Chargers.
    Chargers,
    /// Waypoints.
    Waypoints,
    /// Batteries, and the floor with them.
    Batteries,
    /// That agents vanish at their goals.
    Vanish,
    /// The objective.
    Objective,
    /// The names of agents.
    Names,
    /// When agents charge.
    Charges,
    /// That an agent joins later than at time 0.
    Joining,
    /// That an agent is removed.
    Removal,
    /// Which changes of the world a plan knows, and how long agents slept before.
    Past,
}

/// A part of an instance or a plan that is lost when it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// The slow zone: its cells become free cells.
    SlowZone {
        /// How many.
        cells: usize,
    },
    /// Chargers: they become free cells.
    Chargers {
        /// How many.
        cells: usize,
    },
    /// Waypoints.
    Waypoints {
        /// How many agents have some.
        agents: usize,
    },
    /// Batteries, and the floor with them.
    Batteries {
        /// How many agents have one.
        agents: usize,
    },
    /// That agents vanish at their goals.
    Vanish,
    /// An objective other than the default.
    Objective,
    /// Names other than `A1`, `A2` and so on in order.
    Names {
        /// How many agents have one.
        agents: usize,
    },
    /// The times at which agents charge.
    Charges {
        /// How many agents do.
        agents: usize,
    },
    /// That agents join later than at time 0: they wait where they enter.
    Joining {
        /// How many do.
        agents: usize,
    },
    /// That agents are removed: they remain where they were.
    Removal {
        /// How many are.
        agents: usize,
    },
    /// The last change of the world that the plan takes into account.
    Knows,
    /// The times that agents slept through, arrived, before a change.
    Slept {
        /// How many did.
        agents: usize,
    },
}

impl Loss {
    const fn part(self) -> Part {
        match self {
            Self::SlowZone { .. } => Part::SlowZone,
            Self::Chargers { .. } => Part::Chargers,
            Self::Waypoints { .. } => Part::Waypoints,
            Self::Batteries { .. } => Part::Batteries,
            Self::Vanish => Part::Vanish,
            Self::Objective => Part::Objective,
            Self::Names { .. } => Part::Names,
            Self::Charges { .. } => Part::Charges,
            Self::Joining { .. } => Part::Joining,
            Self::Removal { .. } => Part::Removal,
            Self::Knows | Self::Slept { .. } => Part::Past,
        }
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::SlowZone { cells } => write!(f, "the slow zone ({})", count(cells, "cell")),
            Self::Chargers { cells } => write!(f, "the chargers ({})", count(cells, "cell")),
            Self::Waypoints { agents } => write!(f, "the waypoints of {}", count(agents, "robot")),
            Self::Batteries { agents } => write!(f, "the batteries of {}", count(agents, "robot")),
            Self::Vanish => f.write_str("that robots vanish at their goals"),
            Self::Objective => f.write_str("the objective"),
            Self::Names { agents } => write!(f, "the names of {}", count(agents, "robot")),
            Self::Charges { agents } => write!(f, "the charges of {}", count(agents, "robot")),
            Self::Joining { agents } => write!(f, "the later entry of {}", count(agents, "robot")),
            Self::Removal { agents } => write!(f, "the removal of {}", count(agents, "robot")),
            Self::Knows => f.write_str("which changes the plan takes into account"),
            Self::Slept { agents } => {
                write!(f, "the sleep of {} before a change", count(agents, "robot"))
            }
        }
    }
}

/// What is lost of an instance and of a plan in a format that holds some parts;
/// empty where nothing is. The name of the instance is that of the files.
pub fn losses(holds: &[Part], instance: Option<&Instance>, plan: Option<&Plan>) -> Vec<Loss> {
    let of_instance = instance.map(of_instance).into_iter().flatten();
    let of_plan = plan.map(of_plan).into_iter().flatten();
    of_instance
        .chain(of_plan)
        .filter_map(|(is_there, loss)| is_there.then_some(loss))
        .filter(|loss| !holds.contains(&loss.part()))
        .collect()
}

/// What an instance has that may be lost.
fn of_instance(instance: &Instance) -> [(bool, Loss); 7] {
    let cells = |is: fn(Ground) -> bool| {
        let grounds = instance.grid().cells().map(|(_, ground)| ground);
        grounds.filter(|&ground| is(ground)).count()
    };
    let agents = |is: fn(usize, &Agent) -> bool| {
        let agents = instance.agents().iter().enumerate();
        agents.filter(|&(i, agent)| is(i, agent)).count()
    };
    let slow = cells(Ground::is_slow);
    let chargers = cells(Ground::is_charger);
    let waypoints = agents(|_, agent| !agent.waypoints.is_empty());
    let batteries = agents(|_, agent| agent.battery.is_some());
    let names = agents(|i, agent| agent.name != format!("A{}", i + 1));
    [
        (slow > 0, Loss::SlowZone { cells: slow }),
        (chargers > 0, Loss::Chargers { cells: chargers }),
        (waypoints > 0, Loss::Waypoints { agents: waypoints }),
        (batteries > 0, Loss::Batteries { agents: batteries }),
        (instance.rules().at_goal == AtGoal::Vanish, Loss::Vanish),
        (
            *instance.objective() != Objective::default(),
            Loss::Objective,
        ),
        (names > 0, Loss::Names { agents: names }),
    ]
}

/// What a plan has that may be lost.
fn of_plan(plan: &Plan) -> [(bool, Loss); 5] {
    let charges = plan.charges.values().filter(|all| !all.is_empty()).count();
    let joining = plan.from.values().filter(|&&from| from > 0).count();
    let removed = plan.until.len();
    let slept = plan.slept.values().filter(|all| !all.is_empty()).count();
    [
        (charges > 0, Loss::Charges { agents: charges }),
        (joining > 0, Loss::Joining { agents: joining }),
        (removed > 0, Loss::Removal { agents: removed }),
        (plan.knows.is_some(), Loss::Knows),
        (slept > 0, Loss::Slept { agents: slept }),
    ]
}
