//! A plan as a cell for each robot at each time, for the formats that have just
//! that.

use crate::format::loss::{Part, losses};
use crate::format::movingai;
use crate::{Cell, Fault, Instance, Plan, tr};

use super::{Format, Written};

/// The cells of each agent, in the order of the instance.
pub(super) struct WholeSteps {
    /// From time 0 to the arrival; never empty.
    pub(super) paths: Vec<Vec<Cell>>,
}

impl WholeSteps {
    /// The cells of a plan. An agent that joins later waits where it enters; one
    /// that is removed remains. Repeats of the goal are cut from the ends.
    ///
    /// # Errors
    /// When an agent has no path, or is between two cells.
    pub(super) fn new(instance: &Instance, plan: &Plan, format: Format) -> Result<Self, Fault> {
        let mut plan = plan.clone();
        plan.cut_trailing_goals(instance);
        let mut paths = Vec::with_capacity(instance.agents().len());
        for agent in instance.agents() {
            let name = &agent.name;
            let from = plan.from.get(name).copied().unwrap_or_default();
            let mut cells = Vec::new();
            for (time, at) in (from..).zip(plan.path(name)) {
                let Some(at) = at else {
                    let found = tr!("{name} between two cells at time {time}", name, time);
                    let expected = tr!(
                        "a cell at each time, since {format} knows no moves that take two steps",
                        format
                    );
                    return Err(Fault::at("", found, expected));
                };
                if cells.is_empty() {
                    cells.resize(time as usize, *at);
                }
                cells.push(*at);
            }
            if cells.is_empty() {
                let found = tr!("no path of {name}", name);
                return Err(Fault::at("", found, tr!("a path of every robot")));
            }
            paths.push(cells);
        }
        Ok(Self { paths })
    }

    /// Whether there is a path at all, for formats in which none is no text.
    ///
    /// # Errors
    /// When the plan has no robot.
    pub(super) fn some(&self, format: Format) -> Result<(), Fault> {
        if self.paths.is_empty() {
            let expected = tr!(
                "one of a robot at least, since {format} has nothing else",
                format
            );
            return Err(Fault::at("", tr!("a plan without robots"), expected));
        }
        Ok(())
    }

    /// The largest arrival.
    pub(super) fn makespan(&self) -> usize {
        let arrivals = self.paths.iter().map(|path| path.len() - 1);
        arrivals.max().unwrap_or(0)
    }

    /// The sum of arrivals.
    pub(super) fn sum_of_costs(&self) -> usize {
        self.paths.iter().map(|path| path.len() - 1).sum()
    }

    /// Where an agent is at a time: at the end of its path after its arrival.
    pub(super) fn at(&self, agent: usize, time: usize) -> Option<Cell> {
        let path = self.paths.get(agent)?;
        path.get(time).or(path.last()).copied()
    }
}

/// An instance and a plan for it, which a format of plans needs both.
///
/// # Errors
/// When one of them is missing.
pub(super) fn both<'a>(
    format: Format,
    instance: Option<&'a Instance>,
    plan: Option<&'a Plan>,
) -> Result<(&'a Instance, &'a Plan), Fault> {
    match (instance, plan) {
        (Some(instance), Some(plan)) => Ok((instance, plan)),
        (Some(_), None) => {
            let expected = tr!("a plan, too, since {format} holds nothing else", format);
            Err(Fault::at("", tr!("an instance"), expected))
        }
        (None, _) => {
            let expected = tr!(
                "its instance, too, since {format} has robots in its order",
                format
            );
            Err(Fault::at("", tr!("a plan"), expected))
        }
    }
}

/// The file of a plan, with the map and the scenario that it is for, and what is
/// lost in them.
///
/// # Errors
/// When the name of the files cannot be that of a map.
pub(super) fn with_map(
    stem: &str,
    ending: &str,
    text: String,
    (instance, plan): (&Instance, &Plan),
    holds: &[Part],
) -> Result<Written, Fault> {
    let map = format!("{stem}.map");
    let scenario = movingai::write_scenario(&map, instance)?;
    let losses = losses(holds, Some(instance), Some(plan));
    Ok(Written {
        files: vec![
            (map, movingai::write_map(instance.grid())),
            (format!("{stem}.scen"), scenario),
            (format!("{stem}{ending}"), text),
        ],
        losses: losses.iter().map(ToString::to_string).collect(),
    })
}
