//! The low level of CBS: all shortest walks of one agent that keep its rules, as an MDD.
//!
//! Layer by layer, one a time step, all states are listed from which the agent
//! could still arrive by a bound; it is raised, by more each time, until a layer has
//! an end.
//! What does not lead to that end is dropped. The MDD (Sharon et al. 2013) then
//! tells where every shortest walk passes, which makes a conflict cardinal, and
//! of its walks the one with the fewest collisions is taken.

use std::collections::BTreeMap;

use super::rulebook::Rulebook;
use crate::{
    AgentId,
    budget::{Budget, MemoryUse, Stop},
    local::{OtherAgents, Reservations},
    problem::Problem,
    single::{Place, State},
    terrain::Vertex,
    walk::Walk,
};

struct Node {
    state: State,
    /// The nodes of the next layer that it leads to, and the arcs crossed.
    steps: Vec<(usize, Option<u32>)>,
}

/// All shortest walks of one agent: its layers end with the least arrival.
pub(super) struct Mdd {
    agent: AgentId,
    layers: Vec<Vec<Node>>,
    _held: MemoryUse,
}

impl Mdd {
    /// The shortest walks that keep the rules and arrive by the horizon; `None`
    /// where there is none. None arrives before `earliest`, which is known.
    pub(super) fn new(
        problem: &Problem,
        agent: AgentId,
        rules: &Rulebook,
        earliest: u32,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Option<Self>, Stop> {
        let Some(latest) = rules.latest(horizon.min(problem.not_after(agent))) else {
            return Ok(None);
        };
        let earliest = earliest.max(rules.earliest()).max(problem.optima[agent]);
        let mut bound = earliest;
        let mut more = 1;
        while bound <= latest {
            if let Some((layers, ends)) = layers(problem, agent, rules, bound, budget)? {
                return Ok(Some(Self::leading_to(&ends, agent, layers, budget)));
            }
            if bound == latest {
                break;
            }
            bound = latest.min(bound.saturating_add(more));
            more *= 2;
        }
        Ok(None)
    }

    /// Drops what does not lead to the ends, which are some nodes of the last layer.
    fn leading_to(
        ends: &[bool],
        agent: AgentId,
        mut layers: Vec<Vec<Node>>,
        budget: &dyn Budget,
    ) -> Self {
        let mut bytes = 0;
        let mut ends = ends.iter();
        // The new number of each node of the layer after, where it is kept.
        let mut after: Vec<Option<usize>> = Vec::new();
        for layer in layers.iter_mut().rev() {
            let mut kept = 0;
            let mut numbers = Vec::with_capacity(layer.len());
            layer.retain_mut(|node| {
                let steps = node.steps.iter();
                let steps = steps.filter_map(|&(next, arc)| Some(((*after.get(next)?)?, arc)));
                node.steps = steps.collect();
                node.steps.shrink_to_fit();
                let leads = ends.next() == Some(&true) || !node.steps.is_empty();
                numbers.push(leads.then_some(kept));
                if leads {
                    kept += 1;
                    let steps = size_of::<(usize, Option<u32>)>() * node.steps.capacity();
                    bytes += size_of::<Node>() + 16 + steps; // 16: what an allocation takes besides
                }
                leads
            });
            layer.shrink_to_fit();
            bytes += size_of::<Vec<Node>>() + 16;
            after = numbers;
        }
        Self {
            agent,
            layers,
            _held: budget.hold(bytes),
        }
    }

    /// When its walks arrive.
    pub(super) fn arrival(&self) -> u32 {
        (self.layers.len() - 1) as u32
    }

    /// Whether all its walks are at a vertex at a time.
    pub(super) fn is_always_at(&self, problem: &Problem, v: Vertex, time: u32) -> bool {
        match self.layers.get(time as usize) {
            Some(layer) => layer.iter().all(|node| node.state.place == Place::At(v)),
            None => problem.rests(self.agent) && problem.tasks[self.agent].goal == Some(v),
        }
    }

    /// Whether all its walks cross an arc in the step that begins at a time.
    pub(super) fn always_crosses(&self, arc: u32, time: u32) -> bool {
        let layer = self
            .layers
            .get(time as usize)
            .map_or(&[][..], Vec::as_slice);
        let mut steps = layer.iter().flat_map(|node| &node.steps);
        !layer.is_empty() && steps.all(|&(_, crossed)| crossed == Some(arc))
    }

    /// A walk with the fewest collisions among the others, each counted by time.
    pub(super) fn calmest(&self, problem: &Problem, others: &Reservations) -> Walk {
        let met = |agents: &mut dyn Iterator<Item = AgentId>| {
            agents
                .filter(|&other| problem.collide(self.agent, other))
                .count()
        };
        // Of each node the fewest collisions from there on, and the step to take.
        let mut plan: Vec<Vec<(usize, usize)>> = Vec::new();
        for (time, layer) in self.layers.iter().enumerate().rev() {
            let now = time as u32;
            let best = layer.iter().map(|node| {
                let here = match node.state.place {
                    Place::At(v) => met(&mut others.at(now, v)),
                    Place::Along(_) => 0,
                };
                let onward = node.steps.iter().map(|&(next, arc)| {
                    let against = arc.map_or(0, |arc| met(&mut others.against(now, arc)));
                    let rest = plan.last().and_then(|layer| layer.get(next));
                    (against + rest.map_or(0, |rest| rest.0), next)
                });
                let at_rest = || match node.state.place {
                    Place::At(v) if problem.rests(self.agent) => {
                        (met(&mut others.after(now, v)), 0)
                    }
                    _ => (0, 0),
                };
                let (rest, next) = onward.min().unwrap_or_else(at_rest);
                (here + rest, next)
            });
            let best = best.collect();
            plan.push(best);
        }
        let mut at = 0;
        let steps = self.layers.iter().zip(plan.iter().rev());
        steps
            .filter_map(|(layer, best)| {
                let place = layer.get(at)?.state.place;
                at = best.get(at)?.1;
                Some(place)
            })
            .collect()
    }
}

/// The layers, and which nodes of the last are ends.
type Layers = (Vec<Vec<Node>>, Vec<bool>);

/// All states from which the agent could still arrive by a bound, up to the
/// first time at which it may end.
fn layers(
    problem: &Problem,
    agent: AgentId,
    rules: &Rulebook,
    bound: u32,
    budget: &dyn Budget,
) -> Result<Option<Layers>, Stop> {
    let (task, terrain) = (&problem.tasks[agent], &problem.terrain);
    let node = |state| Node {
        state,
        steps: Vec::new(),
    };
    let first = task.first().filter(|first| rules.may_be(first.place, 0));
    let mut layer: Vec<Node> = first.into_iter().map(node).collect();
    let mut layers = Vec::new();
    for time in 0..=bound {
        let ends = layer
            .iter()
            .map(|node| rules.may_end(problem, agent, node.state, time));
        let ends: Vec<bool> = ends.collect();
        if ends.contains(&true) {
            layers.push(layer);
            return Ok(Some((layers, ends)));
        }
        let mut numbers: BTreeMap<State, usize> = BTreeMap::new();
        let mut next = Vec::new();
        for from in &mut layer {
            budget.tick()?;
            task.onward(terrain, from.state, time, true, |step| {
                let soonest = soonest(problem, agent, step.to, time + 1);
                let soon_enough = soonest.is_some_and(|arrival| arrival <= bound);
                if soon_enough && rules.may_go(&step, time) {
                    let number = *numbers.entry(step.to).or_insert(next.len());
                    if number == next.len() {
                        next.push(node(step.to));
                    }
                    from.steps.push((number, step.arc));
                }
            });
        }
        layers.push(std::mem::replace(&mut layer, next));
    }
    Ok(None)
}

/// The soonest arrival from a state, whatever the rules.
fn soonest(problem: &Problem, agent: AgentId, state: State, time: u32) -> Option<u32> {
    let (v, delay) = match state.place {
        Place::At(v) => (v, 0),
        Place::Along(arc) => (problem.terrain.ends(arc).1, 1),
    };
    let mask = state.mask | problem.tasks[agent].bit(v);
    let rest = problem.cost_to_go[agent].from(v, mask, state.battery)?;
    Some(time + delay + rest)
}
