//! Imposes a condition on one agent, as part of its task.

use giveway_model::{
    Cell, Condition, Instance,
    condition::{Act as Kind, Times},
    sorting::sort,
};

use super::{Precedence, Unmeetable, number};
use crate::{
    encode::collisions::AgentId,
    problem::Problem,
    single::{Act, Area, Counter, Forbidden, LongWait, Required, Task},
    terrain::{Terrain, Vertex},
};

/// Puts a condition into the task of the agent that bears it, and makes the order between
/// agents that it asks for.
///
/// # Errors
/// Where that agent cannot meet it.
pub(super) fn require(
    condition: &Condition,
    instance: &Instance,
    problem: &Problem,
    agent: AgentId,
    task: &mut Task,
) -> Result<Option<Precedence>, Unmeetable> {
    let terrain = &problem.terrain;
    let vertex = |cell: Cell| terrain.vertex(cell).ok_or(Unmeetable(()));
    match *condition {
        Condition::Never { act, times, .. } => {
            match act {
                Kind::Visit(cell) => {
                    if let Some(v) = terrain.vertex(cell)
                        && problem.rests(agent)
                    {
                        forbid_rest(task, v, times);
                    }
                }
                // An agent that rests does none of these.
                Kind::Move(..) | Kind::SlowMove(_) | Kind::Wait { .. } | Kind::Charge(_) => {}
            }
            forbid(task, terrain, act, times);
        }
        Condition::Visit { cell, .. } => {
            task.visit(vertex(cell)?);
        }
        Condition::Move {
            from, to, times, ..
        } => {
            let arcs = vec![arc(terrain, from, to).ok_or(Unmeetable(()))?];
            let required = Required::Cross { arcs, times };
            task.conditions.required.push(required);
        }
        Condition::Charge { cell, .. } => {
            if task.reserve.is_none() {
                return Err(Unmeetable(()));
            }
            let at = vertex(cell)?;
            let leaving = terrain.arcs(at).iter().map(|arc| arc.id).collect();
            let required = Required::Charge { at, leaving };
            task.conditions.required.push(required);
        }
        Condition::Before {
            ref first,
            ref second,
        } => {
            if first == second {
                return Err(Unmeetable(())); // nobody is somewhere before being there
            }
            let here = vertex(first.cell)?;
            let unless = task.visit(here);
            let Some(there) = terrain.vertex(second.cell) else {
                return Ok(None); // nobody is ever there
            };
            if first.agent != second.agent {
                let other = number(instance, &second.agent);
                return Ok(other.map(|other| Precedence {
                    first: (agent, here),
                    second: (other, there),
                    is_required: true,
                }));
            }
            task.conditions.forbidden.push(Forbidden {
                act: Act::Stand(Area::One(there)),
                times: Times::default(),
                unless,
            });
        }
        // It is one of the instance's own.
        Condition::Keeps(_) => {}
        Condition::Below { cost, limit, .. } => {
            let most = limit.checked_sub(1).ok_or(Unmeetable(()))?;
            task.conditions.limit(cost, most);
        }
    }
    Ok(None)
}

/// Resting at a vertex is being there, so the agent does not rest there until the times
/// are over. (Nothing is looked for at the end of time.)
fn forbid_rest(task: &mut Task, v: Vertex, times: Times) {
    if times.are_all() {
        return; // it is never there at all
    }
    let last = times.last();
    if task.goal.is_none() {
        task.not_resting.push((v, last));
    } else if task.goal == Some(v) {
        task.not_before = task.not_before.max(last.saturating_add(1));
    }
}

fn forbid(task: &mut Task, terrain: &Terrain, act: Kind, times: Times) {
    // No agent can be in an obstacle, nor wait or charge there.
    let vertex = |cell: Option<Cell>| match cell {
        Some(cell) => terrain.vertex(cell).map(Some),
        None => Some(None),
    };
    let act = match act {
        Kind::Visit(cell) => terrain.vertex(cell).map(|v| Act::Stand(Area::One(v))),
        Kind::Move(from, to) => arc(terrain, from, to).map(|arc| Act::Cross(vec![arc])),
        Kind::SlowMove(edge) => {
            let is_asked = |id: u32| {
                let (u, v) = terrain.ends(id);
                let ends = (terrain.cell(u), terrain.cell(v));
                edge.is_none_or(|(u, v)| ends == (u, v) || ends == (v, u))
            };
            let arcs = (0..terrain.size() as Vertex).flat_map(|u| terrain.arcs(u));
            let slow = arcs.filter(|arc| arc.slow && is_asked(arc.id));
            let mut arcs: Vec<u32> = slow.map(|arc| arc.id).collect();
            sort(&mut arcs);
            Some(Act::Cross(arcs))
        }
        Kind::Charge(cell) => vertex(cell).map(Act::Charge),
        Kind::Wait { cell, steps } => {
            // A step begins before the last of the times.
            let last = times.to.map(|to| to.checked_sub(1));
            if let (Some(at), None | Some(Some(_))) = (vertex(cell), last) {
                let to = last.flatten();
                let steps = steps.max(1);
                let goes_on = times.first() == 0 && at.is_none_or(|v| v == task.start);
                let begun = if goes_on { task.waits_begun } else { 0 };
                task.conditions.counters.push(Counter::LongWait(LongWait {
                    at: at.map(Area::One),
                    times: Times { to, ..times },
                    steps,
                    begun: begun.min(steps - 1),
                    held: 0,
                }));
            }
            None
        }
    };
    task.conditions.forbidden.extend(act.map(|act| Forbidden {
        act,
        times,
        unless: 0,
    }));
}

fn arc(terrain: &Terrain, from: Cell, to: Cell) -> Option<u32> {
    let (u, v) = (terrain.vertex(from)?, terrain.vertex(to)?);
    let arc = terrain.arcs(u).iter().find(|arc| arc.to == v)?;
    Some(arc.id)
}
