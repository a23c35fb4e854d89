//! A problem made to keep to what a question asks for.

use giveway_model::{Cell, Cost, Instance, Question};

use super::{Counterfactual, Precedence, Unmeetable, index};
use crate::{
    budget::Budget,
    problem::{Problem, ProblemError},
    single::{Task, TaskConstraint},
    terrain::Vertex,
};

impl Counterfactual {
    /// Makes a problem keep to it.
    ///
    /// # Errors
    /// Where the agent alone cannot, or the budget is spent.
    pub(crate) fn impose(
        &self,
        instance: &Instance,
        problem: &mut Problem,
        budget: &Budget,
    ) -> Result<(), ProblemError> {
        let Some(agent) = self.agent().and_then(|name| index(instance, name)) else {
            return Ok(());
        };
        let impossible = || ProblemError::Alone(agent, Unmeetable(()).into());
        let mut task = problem.tasks[agent].clone();
        let to = match &self.question {
            Question::Yield { to, .. } => index(instance, to),
            _ => None,
        };
        if self.demand(problem, agent, &mut task).is_none() {
            return Err(impossible());
        }
        if let (Some(second), Question::Yield { at, .. }) = (to, &self.question) {
            let at = problem.terrain.vertex(*at).ok_or_else(impossible)?;
            problem.precedence = Some(Precedence {
                first: agent,
                second,
                at,
            });
        }
        Ok(problem.add(agent, task, budget)?)
    }

    /// Puts the demand into the agent's task; `None` where it cannot be kept.
    fn demand(&self, problem: &Problem, agent: usize, task: &mut Task) -> Option<()> {
        let terrain = &problem.terrain;
        let vertex = |cell: Cell| terrain.vertex(cell);
        let arc = |from: Cell, to: Cell| {
            let (u, v) = (vertex(from)?, vertex(to)?);
            let arc = terrain.arcs(u).iter().find(|arc| arc.to == v)?;
            Some(arc.id)
        };
        let fewer = |cost| {
            let most = self.below.checked_sub(1)?;
            Some(TaskConstraint::AtMost { cost, most })
        };
        task.demand = match self.question {
            Question::Wait {
                at,
                from,
                to,
                at_least,
                ..
            } => match at.map(vertex) {
                Some(None) => None, // nobody waits in an obstacle
                v => Some(TaskConstraint::Wait {
                    v: v.flatten(),
                    from: from.unwrap_or(0),
                    to: to.unwrap_or(u32::MAX),
                    steps: at_least.unwrap_or(1).max(1),
                }),
            },
            Question::Charge { at, time, .. } => Some(TaskConstraint::NotCharge {
                v: at.and_then(vertex),
                time,
            }),
            Question::NoCharge { at, .. } => {
                task.reserve?;
                let v = vertex(at)?;
                let leaving = terrain.arcs(v).iter().map(|arc| arc.id).collect();
                Some(TaskConstraint::Charge { v, leaving })
            }
            Question::Visit { at, time, .. } => {
                let v = vertex(at);
                if let (Some(time), Some(v)) = (time, v)
                    && v == task.goal
                    && problem.rests(agent)
                {
                    // Resting there is being there.
                    // (Nothing is looked for at the end of time.)
                    task.not_before = time.saturating_add(1);
                }
                v.map(|v| TaskConstraint::Avoid { v, time })
            }
            Question::NoVisit { at, .. } | Question::Yield { at, .. } => {
                task.visit(vertex(at)?);
                None
            }
            Question::Move {
                from_cell,
                to_cell,
                time,
                ..
            } => Some(TaskConstraint::NotCross {
                arcs: arc(from_cell, to_cell).into_iter().collect(),
                time,
            }),
            Question::NoMove {
                from_cell,
                to_cell,
                time,
                ..
            } => Some(TaskConstraint::Cross {
                arcs: vec![arc(from_cell, to_cell)?],
                time,
            }),
            Question::Slow {
                from_cell, to_cell, ..
            } => {
                let edge = from_cell.zip(to_cell);
                let is_asked = |id: u32| {
                    let (u, v) = terrain.ends(id);
                    let ends = (terrain.cell(u), terrain.cell(v));
                    edge.is_none_or(|(u, v)| ends == (u, v) || ends == (v, u))
                };
                let arcs = (0..terrain.size() as Vertex).flat_map(|u| terrain.arcs(u));
                let slow = arcs.filter(|arc| arc.slow && is_asked(arc.id));
                Some(TaskConstraint::NotCross {
                    arcs: slow.map(|arc| arc.id).collect(),
                    time: None,
                })
            }
            Question::Order { first, second, .. } => {
                let waypoint = task.visit(vertex(second)?);
                let v = vertex(first);
                v.map(|v| TaskConstraint::After { v, waypoint })
            }
            Question::Arrival { .. } => Some(TaskConstraint::ArriveBy(self.below.checked_sub(1)?)),
            Question::Length { .. } | Question::Moves { .. } => Some(fewer(Cost::Moves)?),
            Question::Charges { .. } => Some(fewer(Cost::Charges)?),
            Question::Waits { .. } => Some(fewer(Cost::Waits)?),
            Question::Makespan | Question::SumOfCosts | Question::Unsolvable | Question::Plan => {
                None
            }
        };
        Some(())
    }
}
