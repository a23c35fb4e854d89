//! What MovingAI files cannot hold.

use std::fmt;

use crate::words::count;
use crate::{AtGoal, Instance, Objective};

/// A part of an instance that is lost when it is written as MovingAI files.
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
        }
    }
}

/// What of an instance is lost in MovingAI files; empty where nothing is. The
/// name of the instance is that of the files.
pub fn losses(instance: &Instance) -> Vec<Loss> {
    let cells = |is: fn(crate::Ground) -> bool| {
        let grounds = instance.grid().cells().map(|(_, ground)| ground);
        grounds.filter(|&ground| is(ground)).count()
    };
    let agents = |is: fn(usize, &crate::Agent) -> bool| {
        let agents = instance.agents().iter().enumerate();
        agents.filter(|&(i, agent)| is(i, agent)).count()
    };
    let slow = cells(crate::Ground::is_slow);
    let chargers = cells(crate::Ground::is_charger);
    let waypoints = agents(|_, agent| !agent.waypoints.is_empty());
    let batteries = agents(|_, agent| agent.battery.is_some());
    let names = agents(|i, agent| agent.name != format!("A{}", i + 1));
    let candidates = [
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
    ];
    candidates
        .into_iter()
        .filter_map(|(lost, loss)| lost.then_some(loss))
        .collect()
}
