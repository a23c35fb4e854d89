//! Zones of the scene's own in which only so many agents may be, and who cannot go round them.

use giveway_model::condition::Times;

use super::{
    Bottleneck, Gate, Job, Machine, Way,
    passages::{gap_of, goal_of, rest},
    reach::{Steps, steps_from, times_inside},
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    rules::SharedKind,
    single::Area,
    terrain::{Terrain, Vertex},
};

/// A zone with a limit at all times.
struct Zone<'p> {
    problem: &'p Problem,
    rule: usize,
    area: &'p Area,
    most: u32,
    /// The agents that the limit binds and counts.
    agents: Vec<AgentId>,
}

/// The bottlenecks of all limits that hold at all times.
pub(super) fn find(
    problem: &Problem,
    fewest: usize,
    budget: &dyn Budget,
) -> Result<Vec<Bottleneck>, Stop> {
    let mut found = Vec::new();
    for rule in &problem.between.rules {
        let SharedKind::Capacity { area, most, times } = &rule.kind else {
            continue;
        };
        let Times { to, .. } = times;
        if times.first() > 0 || to.is_some() {
            continue;
        }
        let agents = 0..problem.agents();
        let zone = Zone {
            problem,
            rule: rule.index,
            area,
            most: *most,
            agents: agents
                .filter(|&agent| rule.binds(agent) && !rule.begins_uncounted(agent))
                .filter(|&agent| goal_of(&problem.tasks[agent]).is_some())
                .collect(),
        };
        if zone.agents.len() < fewest {
            continue;
        }
        found.push(zone.by_places(budget)?);
        if zone.most == 1 {
            found.extend(zone.by_turns(budget)?);
        }
    }
    found.retain(|found| found.jobs.len() >= fewest);
    Ok(found)
}

impl Zone<'_> {
    fn terrain(&self) -> &Terrain {
        &self.problem.terrain
    }

    fn vertices(&self) -> impl Iterator<Item = Vertex> + '_ {
        (0..self.terrain().size() as Vertex).filter(|&v| self.area.has(v))
    }

    /// Whether a way into the area or through it is slow: half way an agent counts at both ends.
    fn has_slow_arcs(&self) -> bool {
        let mut arcs = self.vertices().flat_map(|v| self.terrain().arcs(v));
        arcs.any(|arc| arc.slow)
    }

    fn bottleneck(&self, machine: Machine, jobs: Vec<Job>) -> Bottleneck {
        let gate = Gate::Zone {
            rule: self.rule,
            most: self.most,
        };
        Bottleneck {
            gate,
            machine,
            jobs,
        }
    }

    /// Each agent takes its least time in the area, in one of the places.
    fn by_places(&self, budget: &dyn Budget) -> Result<Bottleneck, Stop> {
        let terrain = self.terrain();
        let near = steps_from(terrain, self.vertices(), |_| true, budget)?;
        let early = u32::from(self.has_slow_arcs());
        let mut jobs = Vec::new();
        for &agent in &self.agents {
            let task = &self.problem.tasks[agent];
            let Some(goal) = goal_of(task) else { continue };
            let from = times_inside(terrain, task.start, self.area, budget)?;
            let Some(mut work) = from[goal as usize] else {
                continue;
            };
            if !task.waypoints.is_empty() {
                let to = times_inside(terrain, goal, self.area, budget)?;
                for &v in &task.waypoints {
                    let both = from[v as usize].zip(to[v as usize]);
                    let twice = u32::from(self.area.has(v));
                    work = work.max(both.map_or(0, |(from, to)| from + to - twice));
                }
            }
            let steps = |v: Vertex| near[v as usize].map(|steps| steps.saturating_sub(early));
            if work > 0
                && let (Some(there), Some(tail)) = (steps(task.start), steps(goal))
            {
                let held = if self.area.has(task.start) {
                    task.delay()
                } else {
                    task.delay().max(task.earliest_move)
                };
                jobs.push(Job {
                    agent,
                    way: Way::Forth,
                    release: there.saturating_add(held),
                    work,
                    tail,
                });
            }
        }
        Ok(self.bottleneck(Machine::Places(self.most), jobs))
    }

    /// One agent after the other crosses an area that parts the map in two.
    fn by_turns(&self, budget: &dyn Budget) -> Result<Option<Bottleneck>, Stop> {
        if self.has_slow_arcs() {
            return Ok(None);
        }
        let Some(sides) = self.sides(budget)? else {
            return Ok(None);
        };
        let [forth, back] = &sides;
        let Some(length) = self.length(&sides, budget)? else {
            return Ok(None);
        };
        let stays = self.problem.stays;
        let gap = if stays {
            gap_of(self.problem, &self.agents)
        } else {
            0
        };
        // Who comes out of the only way out is met there by who goes in.
        let opposed = |exits: usize| match exits {
            1 => length + 2 + gap,
            _ => length,
        };
        let machine = Machine::Turns {
            same: length,
            opposed: [opposed(back.borders.len()), opposed(forth.borders.len())],
        };
        let mut jobs = Vec::new();
        for &agent in &self.agents {
            let task = &self.problem.tasks[agent];
            let Some(goal) = goal_of(task) else { continue };
            let lies = |side: &Side, v: Vertex| side.steps[v as usize].is_some();
            let way = if lies(forth, task.start) && lies(back, goal) {
                Way::Forth
            } else if lies(back, task.start) && lies(forth, goal) {
                Way::Back
            } else {
                continue;
            };
            let (own, other) = match way {
                Way::Forth => (forth, back),
                Way::Back => (back, forth),
            };
            let is_beyond = |v: Vertex| lies(other, v);
            let rests = own.borders.iter().filter_map(|&entry| {
                rest(self.problem, agent, entry, (&own.to_entries, &is_beyond))
            });
            if let (Some(there), Some(tail)) = (own.steps[task.start as usize], rests.min()) {
                let held = task.delay().max(task.earliest_move);
                jobs.push(Job {
                    agent,
                    way,
                    release: there.saturating_add(held),
                    work: 1,
                    tail,
                });
            }
        }
        Ok(Some(self.bottleneck(machine, jobs)))
    }

    /// The two parts of the map beside the area; `None` where there are not two.
    fn sides(&self, budget: &dyn Budget) -> Result<Option<[Side; 2]>, Stop> {
        let terrain = self.terrain();
        let mut sides: Vec<Side> = Vec::new();
        for v in self.vertices() {
            for arc in terrain.arcs(v).iter().filter(|arc| !self.area.has(arc.to)) {
                let known = sides
                    .iter_mut()
                    .find(|side| side.part[arc.to as usize].is_some());
                if let Some(side) = known {
                    side.borders.push(v);
                    continue;
                }
                if sides.len() == 2 {
                    return Ok(None);
                }
                sides.push(Side {
                    part: steps_from(terrain, [arc.to], |v| !self.area.has(v), budget)?,
                    borders: vec![v],
                    steps: Vec::new(),
                    to_entries: Vec::new(),
                });
            }
        }
        for side in &mut sides {
            let part = std::mem::take(&mut side.part);
            let may_be = |v: Vertex| part[v as usize].is_some();
            side.steps = steps_from(terrain, side.borders.iter().copied(), may_be, budget)?;
            // In the area it is on neither side.
            for &v in &side.borders {
                side.steps[v as usize] = None;
            }
            side.to_entries = steps_from(terrain, side.borders.iter().copied(), |_| true, budget)?;
        }
        Ok(sides.try_into().ok())
    }

    /// The least time points in the area on the way from one side to the other.
    fn length(&self, [forth, back]: &[Side; 2], budget: &dyn Budget) -> Result<Option<u32>, Stop> {
        let entries = forth.borders.iter().copied();
        let steps = steps_from(self.terrain(), entries, |v| self.area.has(v), budget)?;
        let ends = back.borders.iter().filter_map(|&v| steps[v as usize]);
        Ok(ends.min().map(|steps| steps + 1))
    }
}

/// A part of the map that only the area joins to the rest.
struct Side {
    /// Its vertices.
    part: Steps,
    /// The vertices of the area at its edge, once for each arc from there.
    borders: Vec<Vertex>,
    /// From its vertices to the area.
    steps: Steps,
    /// From all vertices to the border.
    to_entries: Steps,
}
