//! How far an agent comes that has no way: the longest walk around those before it.

use std::collections::BTreeMap;

use crate::{
    AgentId,
    budget::{Budget, Stop},
    local::OtherAgents,
    single::Place,
    terrain::Vertex,
    walk::Walk,
};

/// Where an agent can be at a time, and from where and when it came there.
type Layer = BTreeMap<Vertex, (Vertex, usize)>;

/// The walk of an agent that lasts longest without a collision, and whether it ends
/// for lack of a free vertex. An agent that can keep out of the way for ever goes as
/// near to its goal as it can, and no further.
///
/// # Errors
/// When the budget is spent.
pub(super) fn furthest(
    others: &impl OtherAgents,
    agent: AgentId,
    horizon: u32,
    budget: &dyn Budget,
) -> Result<(Walk, bool), Stop> {
    let problem = others.problem();
    let task = &problem.tasks[agent];
    let is_free = |time: usize, v: Vertex| {
        let mut there = others.at(time as u32, v);
        !there.any(|other| problem.collide(agent, other))
    };
    let mut layers: Vec<Layer> = vec![BTreeMap::from([(task.start, (task.start, 0))])];
    for time in 0..horizon as usize {
        let here: Vec<Vertex> = match layers.get(time) {
            Some(layer) => layer.keys().copied().collect(),
            None => break,
        };
        for v in here {
            budget.tick()?;
            let mut reach = |to: Vertex, steps: usize| {
                if is_free(time + steps, to) {
                    while layers.len() <= time + steps {
                        layers.push(Layer::new());
                    }
                    let layer = &mut layers[time + steps];
                    // An agent that can be there earlier and wait does so.
                    if to == v {
                        layer.insert(to, (v, time));
                    } else {
                        layer.entry(to).or_insert((v, time));
                    }
                }
            };
            reach(v, 1);
            for arc in problem.terrain.arcs(v) {
                let steps = 1 + usize::from(arc.slow);
                let is_against = |time: usize| {
                    let mut against = others.against(time as u32, arc.id);
                    against.any(|other| problem.collide(agent, other))
                };
                let is_blocked = is_against(time) || (arc.slow && is_against(time + 1));
                if !is_blocked {
                    reach(arc.to, steps);
                }
            }
        }
    }
    let to_go = |v: Vertex| {
        let least = problem.cost_to_go[agent].from(v, task.first_mask(), 0);
        least.unwrap_or(u32::MAX)
    };
    let nearest = |time: usize| {
        let layer = layers.get(time)?.keys().copied();
        layer.map(|v| (to_go(v), time, v)).min()
    };
    let lasts = layers.len() > horizon as usize && layers.last().is_some_and(|l| !l.is_empty());
    let end = if lasts {
        (0..layers.len()).filter_map(nearest).min()
    } else {
        (0..layers.len()).rev().find_map(nearest)
    };
    let mut walk = Walk::new();
    let Some((_, mut time, mut v)) = end else {
        return Ok((walk, !lasts));
    };
    loop {
        walk.push(Place::At(v));
        let Some(&(from, before)) = layers[time].get(&v).filter(|_| time > 0) else {
            break;
        };
        if time - before == 2 {
            let mut arcs = problem.terrain.arcs(from).iter();
            walk.extend(arcs.find(|arc| arc.to == v).map(|arc| Place::Along(arc.id)));
        }
        (v, time) = (from, before);
    }
    walk.reverse();
    Ok((walk, !lasts))
}
