//! What a problem says: said when it is shown, in the language of that moment.

use giveway_model::{Cell, Fault, tr};

use crate::words::at;

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// Two agents have this name.
    SameName(String),
    /// Two agents start on one cell.
    SameStart([String; 2], Cell),
    /// Two agents end, and stay, on one cell.
    SameGoal([String; 2], Cell),
    /// A cell of a task is on an obstacle, or off the map.
    Ground { task: Task, is_off_map: bool },
    /// The start is walled in.
    WalledIn(Cell, Task),
    /// No way leads to a cell of a task.
    Closed(Task),
    /// The battery does not last to a cell of a task.
    Battery(Task),
    /// It does not last from there to the goal.
    BatteryBehind(Task),
    /// What validation found.
    Fault(Fault),
}

/// A cell that an agent has to do with: the agent's name, what the cell is to it, where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Task(pub(super) String, pub(super) Part, pub(super) Cell);

/// What a cell is to an agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Start,
    Goal,
    Waypoint,
}

impl Part {
    fn word(self) -> &'static str {
        match self {
            Self::Start => tr!("of a robot" => "start"),
            Self::Goal => tr!("of a robot" => "goal"),
            Self::Waypoint => tr!("of a robot" => "waypoint"),
        }
    }
}

impl Task {
    fn parts(&self) -> (&str, &'static str, String) {
        (&self.0, self.1.word(), at(self.2))
    }
}

impl What {
    pub(super) fn sentence(&self) -> String {
        match self {
            Self::SameName(name) => tr!("Two robots are called {name}.", name),
            Self::SameStart([other, name], cell) => tr!(
                "{other} and {name} both start at {cell}.",
                other,
                name,
                cell = at(*cell)
            ),
            Self::SameGoal([other, name], goal) => tr!(
                "{other} and {name} both end at {goal}, where only one can stay.",
                other,
                name,
                goal = at(*goal)
            ),
            Self::Ground { task, is_off_map } => {
                let (agent, what, cell) = task.parts();
                let is = if *is_off_map {
                    tr!("a cell" => "off the map")
                } else {
                    tr!("a cell" => "on an obstacle")
                };
                tr!(
                    "The {what} of {agent} is {is}, at {cell}.",
                    what,
                    agent,
                    is,
                    cell
                )
            }
            Self::WalledIn(here, task) => {
                let ((name, what, there), here) = (task.parts(), at(*here));
                tr!(
                    "{name} is walled in at {here}: no way leads to its {what} {there}.",
                    name,
                    here,
                    what,
                    there
                )
            }
            Self::Closed(task) => {
                let (name, what, cell) = task.parts();
                tr!(
                    "{name} cannot reach its {what} {cell}: every way is closed.",
                    name,
                    what,
                    cell
                )
            }
            Self::Battery(task) => {
                let (name, what, place) = task.parts();
                tr!(
                    "The battery of {name} does not last to its {what} {place}.",
                    name,
                    what,
                    place
                )
            }
            Self::BatteryBehind(task) => {
                let (name, what, place) = task.parts();
                tr!(
                    "The battery of {name} lasts to its {what} {place}, but not on to its goal.",
                    name,
                    what,
                    place
                )
            }
            Self::Fault(fault) => format!("{fault}."),
        }
    }
}
