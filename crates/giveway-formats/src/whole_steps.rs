//! A plan as a cell for each robot at each time, for the formats that have just
//! that.

use crate::limits::refuse;
use crate::{Format, Move};
use giveway_model::{Cell, Fault, Instance, Plan, tr};

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
                    return refuse(found, expected);
                };
                if cells.is_empty() {
                    cells.resize(time as usize, *at);
                }
                cells.push(*at);
            }
            if cells.is_empty() {
                let found = tr!("no path of {name}", name);
                return refuse(found, tr!("a path of every robot"));
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
            return refuse(tr!("a plan without robots"), expected);
        }
        Ok(())
    }

    /// The moves of each agent, for formats that have its start in another place.
    ///
    /// # Errors
    /// When a path does not begin at the start of its agent, or jumps.
    pub(super) fn moves(&self, instance: &Instance) -> Result<Vec<Vec<Move>>, Fault> {
        let mut all = Vec::with_capacity(self.paths.len());
        for (agent, cells) in instance.agents().iter().zip(&self.paths) {
            let (name, start) = (&agent.name, agent.start);
            let first = cells.first().copied().unwrap_or(start);
            if first != start {
                let found = tr!("{name} at {first} at time 0", name, first);
                return refuse(found, tr!("its start {start}", start));
            }
            let steps = cells.windows(2).enumerate();
            let moves = steps.filter_map(|(time, pair)| {
                let &[from, to] = pair else { return None };
                Some(step(from, to).ok_or_else(|| {
                    let found = tr!(
                        "{name} jumping from {from} to {to} at time {time}",
                        name,
                        from,
                        to,
                        time = time + 1
                    );
                    Fault::at("", found, tr!("a move to a cell beside it, or a wait"))
                }))
            });
            all.push(moves.collect::<Result<_, Fault>>()?);
        }
        Ok(all)
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

/// The move between two cells that touch.
fn step(from: Cell, to: Cell) -> Option<Move> {
    let difference = |to: u32, from: u32| i64::from(to) - i64::from(from);
    Move::of_offset((difference(to.x, from.x), difference(to.y, from.y)))
}
