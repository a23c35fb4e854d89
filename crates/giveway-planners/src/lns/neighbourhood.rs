//! Which agents to plan anew together.

use std::collections::BTreeSet;

use fastrand::Rng;

use super::{adaptive::Neighbourhood, replan::Plan};
use crate::{
    AgentId,
    chance::{below, shuffle},
    local::OtherAgents,
    single::Place,
    terrain::Vertex,
    walk::arrival,
};

/// The fewest and the most agents of a neighbourhood.
const SIZES: (usize, usize) = (5, 12);
/// Random walks that look for agents in the way.
const WALKS: usize = 10;

/// The plan from which neighbourhoods are chosen.
pub(super) struct Neighbourhoods<'a, 'w, O> {
    pub(super) plan: &'a Plan<'w, O>,
    pub(super) rng: &'a mut Rng,
    pub(super) tabu: &'a mut BTreeSet<AgentId>,
}

impl<O: OtherAgents> Neighbourhoods<'_, '_, O> {
    /// Agents in the order in which they are planned; `None` where no agent is
    /// delayed, so that nothing is to be gained.
    pub(super) fn choose(&mut self, kind: Neighbourhood) -> Option<Vec<AgentId>> {
        let agents = self.plan.walks.len();
        let seed = self.delayed()?;
        let (fewest, most) = SIZES;
        let size = (fewest + below(self.rng, most + 1 - fewest)).min(agents);
        let mut group = match kind {
            Neighbourhood::Delay => self.by_delay(seed, size),
            Neighbourhood::OwnWay => self.by_own_way(seed),
            Neighbourhood::Crossing => self.by_crossing(size),
            Neighbourhood::Random => Vec::new(),
        };
        group.truncate(size);
        while group.len() < size.min(2) || (kind == Neighbourhood::Random && group.len() < size) {
            let other = below(self.rng, agents);
            if !group.contains(&other) {
                group.push(other);
            }
        }
        shuffle(self.rng, &mut group);
        Some(group)
    }

    /// The most delayed agent that no neighbourhood began with of late; now and then
    /// one of those that arrive last.
    fn delayed(&mut self) -> Option<AgentId> {
        let tally = &self.plan.tally;
        if self.rng.u8(..4) == 0
            && let Some(last) = tally.last().filter(|&agent| self.plan.delay(agent) > 0)
        {
            return Some(last);
        }
        let fresh = tally.delayed().find(|agent| !self.tabu.contains(agent));
        let seed = fresh.or_else(|| {
            self.tabu.clear();
            tally.delayed().next()
        })?;
        self.tabu.insert(seed);
        Some(seed)
    }

    /// The agent, and those that are met where it walks about at random from
    /// somewhere on its way, as long as it could still arrive sooner.
    fn by_delay(&mut self, seed: AgentId, size: usize) -> Vec<AgentId> {
        let mut group = vec![seed];
        let mut agent = seed;
        for _ in 0..WALKS {
            if group.len() >= size {
                break;
            }
            self.wander(agent, size, &mut group);
            agent = group[below(self.rng, group.len())];
        }
        group
    }

    fn wander(&mut self, agent: AgentId, size: usize, group: &mut Vec<AgentId>) {
        let plan = self.plan;
        let problem = plan.problem();
        let (task, cost_to_go) = (&problem.tasks[agent], &problem.cost_to_go[agent]);
        let walk = &plan.walks[agent];
        let level = task.reserve.map_or(0, |reserve| reserve.full);
        let begin = below(self.rng, walk.len().max(1));
        let mut mask = 0;
        for place in walk.iter().take(begin + 1) {
            if let Place::At(v) = *place {
                mask |= task.bit(v);
            }
        }
        let Some(&Place::At(mut v)) = walk.get(begin) else {
            return;
        };
        let mut time = begin as u32;
        let latest = arrival(walk);
        while group.len() < size {
            let arcs = problem.terrain.arcs(v);
            let mut steps: Vec<Option<usize>> = (0..arcs.len()).map(Some).collect();
            steps.push(None);
            shuffle(self.rng, &mut steps);
            let next = steps.into_iter().find_map(|step| {
                let arc = step.map(|i| arcs[i]);
                if arc.is_some_and(|arc| !task.may_cross(arc.id, None)) {
                    return None;
                }
                let to = arc.map_or(v, |arc| arc.to);
                let then = time + 1 + u32::from(arc.is_some_and(|arc| arc.slow));
                let rest = cost_to_go.from(to, mask | task.bit(to), level)?;
                (then + rest < latest).then_some((arc, to, then))
            });
            let Some((arc, to, then)) = next else { return };
            let mut meet = |other: AgentId| {
                if other != agent && !group.contains(&other) {
                    group.push(other);
                }
            };
            plan.others.at(then, to).for_each(&mut meet);
            let kept_away_by = plan.others.kept_away_by(agent, then, to);
            kept_away_by.into_iter().for_each(&mut meet);
            if let Some(arc) = arc {
                plan.others.against(time, arc.id).for_each(&mut meet);
            }
            (v, time) = (to, then);
            mask |= task.bit(to);
        }
    }

    /// The agent, and those that it would meet on a best way of its own, or that rules keep it
    /// from that way for.
    fn by_own_way(&mut self, seed: AgentId) -> Vec<AgentId> {
        let plan = self.plan;
        let problem = plan.problem();
        let (task, cost_to_go) = (&problem.tasks[seed], &problem.cost_to_go[seed]);
        let level = task.reserve.map_or(0, |reserve| reserve.full);
        let mut met = Vec::new();
        let (mut v, mut mask, mut time) = (task.start, task.first_mask(), task.delay());
        while let Some(rest) = cost_to_go.from(v, mask, level).filter(|&rest| rest > 0) {
            let arcs = problem.terrain.arcs(v);
            let first = below(self.rng, arcs.len().max(1));
            let arcs = arcs[first..].iter().chain(&arcs[..first]);
            let best = arcs.copied().find(|arc| {
                if !task.may_cross(arc.id, None) {
                    return false;
                }
                let steps = 1 + u32::from(arc.slow);
                let onward = cost_to_go.from(arc.to, mask | task.bit(arc.to), level);
                onward.is_some_and(|onward| onward + steps <= rest)
            });
            let Some(arc) = best else { break };
            met.extend(plan.others.against(time, arc.id));
            time += 1 + u32::from(arc.slow);
            v = arc.to;
            mask |= task.bit(v);
            met.extend(plan.others.at(time, v));
            met.extend(plan.others.kept_away_by(seed, time, v));
        }
        met.extend(plan.others.after(time, task.goal.unwrap_or(v)));
        shuffle(self.rng, &mut met);
        let mut group = vec![seed];
        for other in met {
            if !group.contains(&other) {
                group.push(other);
            }
        }
        group
    }

    /// The agents that pass a crossing, and those of the crossings nearest to it.
    fn by_crossing(&mut self, size: usize) -> Vec<AgentId> {
        let terrain = &self.plan.problem().terrain;
        let first = below(self.rng, terrain.size()) as Vertex;
        let mut group = Vec::new();
        let mut reached = vec![first];
        let mut seen = BTreeSet::from([first]);
        let mut next = 0;
        while let Some(&v) = reached.get(next) {
            next += 1;
            if terrain.arcs(v).len() > 2 {
                let mut visitors = self.plan.others.visitors(v);
                if !visitors.is_empty() {
                    let begin = below(self.rng, visitors.len());
                    visitors.rotate_left(begin);
                }
                for other in visitors {
                    if group.len() < size && !group.contains(&other) {
                        group.push(other);
                    }
                }
            }
            if group.len() >= size {
                break;
            }
            for arc in terrain.arcs(v) {
                if seen.insert(arc.to) {
                    reached.push(arc.to);
                }
            }
        }
        group
    }
}
