//! Passages of one cell's width that part the map, and who has to go through.

use std::collections::BTreeSet;

use giveway_model::sorting::sort_by_key;

use super::{Bottleneck, Gate, Job, Machine, Way, cuts::Cuts, reach::steps_from};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    rules::SharedKind,
    single::Task,
    terrain::{Arc, Terrain, Vertex},
};

/// As many passages are looked at, those with most agents.
const MOST_PASSAGES: usize = 8;

/// The passages with most agents.
pub(super) fn find(
    problem: &Problem,
    fewest: usize,
    budget: &dyn Budget,
) -> Result<Vec<Bottleneck>, Stop> {
    let terrain = &problem.terrain;
    let cuts = Cuts::of(terrain, budget)?;
    let crossing = |cut: Vertex| -> Vec<AgentId> {
        let agents = problem.tasks.iter().enumerate();
        let parted = agents.filter(|(_, task)| {
            let goal = goal_of(task);
            goal.is_some_and(|goal| cuts.parts(cut, task.start, goal))
        });
        parted.map(|(agent, _)| agent).collect()
    };
    let mut busy: Vec<(Vertex, Vec<AgentId>)> = Vec::new();
    for cut in cuts.all() {
        budget.spend(problem.agents() as u64)?;
        let agents = crossing(cut);
        if agents.len() >= fewest {
            busy.push((cut, agents));
        }
    }
    sort_by_key(&mut busy, |(cut, agents)| (usize::MAX - agents.len(), *cut));
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    let mut taken = 0;
    for (cut, agents) in busy {
        if taken == MOST_PASSAGES {
            break;
        }
        if seen.contains(&cut) {
            continue;
        }
        let cells = corridor(terrain, cut, |v| cuts.is_cut(v) && crossing(v) == agents);
        seen.extend(cells.iter().copied());
        taken += 1;
        let bottleneck = of_cells(problem, cells, &agents, budget)?;
        found.extend(bottleneck.filter(|found| found.jobs.len() >= fewest));
    }
    Ok(found)
}

/// The vertices in a row around one with two neighbours each, which `belongs` allows.
fn corridor(terrain: &Terrain, middle: Vertex, belongs: impl Fn(Vertex) -> bool) -> Vec<Vertex> {
    let mut cells = vec![middle];
    if terrain.arcs(middle).len() != 2 {
        return cells;
    }
    for turn in 0..2 {
        // On at one end, then at the other.
        cells.reverse();
        while let Some(&end) = cells.last() {
            let before = cells.len().checked_sub(2).and_then(|i| cells.get(i));
            let mut next = terrain.arcs(end).iter().map(|arc| arc.to);
            let next = match before {
                Some(before) => next.find(|v| v != before),
                None => next.nth(turn),
            };
            match next {
                Some(v) if terrain.arcs(v).len() == 2 && !cells.contains(&v) && belongs(v) => {
                    cells.push(v);
                }
                _ => break,
            }
        }
    }
    cells
}

/// The bottleneck of the agents that go through some vertices in a row.
fn of_cells(
    problem: &Problem,
    cells: Vec<Vertex>,
    agents: &[AgentId],
    budget: &dyn Budget,
) -> Result<Option<Bottleneck>, Stop> {
    let terrain = &problem.terrain;
    let (Some(&first), Some(&last)) = (cells.first(), cells.last()) else {
        return Ok(None);
    };
    let is_inside = |v: Vertex| cells.contains(&v);
    // The sides are told by how far it is to their end of the passage.
    let outside = |end: Vertex| terrain.arcs(end).iter().filter(|arc| !is_inside(arc.to));
    let Some(forth_from) = outside(first).next().map(|arc| arc.to) else {
        return Ok(None);
    };
    let before = steps_from(terrain, [forth_from], |v| !is_inside(v), budget)?;
    let exits = |is_before: bool, end: Vertex| -> Vec<Arc> {
        let exits = outside(end);
        let exits = exits.filter(|arc| before[arc.to as usize].is_some() == is_before);
        exits.copied().collect()
    };
    let (entries, exits) = (exits(true, first), exits(false, last));
    let Some(beyond) = exits.first().map(|arc| arc.to) else {
        return Ok(None);
    };
    let after = steps_from(terrain, [beyond], |v| !is_inside(v), budget)?;
    let has_two_sides = outside(first)
        .chain(outside(last))
        .all(|arc| before[arc.to as usize].is_some() || after[arc.to as usize].is_some());
    let gap = gap_of(problem, agents);
    let same = 1 + gap;
    let length = cells.len() as u32;
    let is_fast = cells
        .iter()
        .all(|&v| terrain.arcs(v).iter().all(|arc| !arc.slow));
    // Who comes out of the only way out is met there by who goes in.
    let opposed = |ways: &[Arc]| {
        let alone = has_two_sides && is_fast && ways.len() == 1;
        if alone {
            length + 2 + if problem.stays { gap } else { 0 }
        } else {
            same
        }
    };
    let machine = Machine::Turns {
        same,
        opposed: [opposed(&exits).max(same), opposed(&entries).max(same)],
    };
    let to_first = steps_from(terrain, [first], |_| true, budget)?;
    let to_last = steps_from(terrain, [last], |_| true, budget)?;
    let mut jobs = Vec::new();
    for &agent in agents {
        let task = &problem.tasks[agent];
        let is_before = before[task.start as usize].is_some();
        let (way, entry, steps) = if is_before || !has_two_sides {
            (Way::Forth, first, &to_first)
        } else {
            (Way::Back, last, &to_last)
        };
        let is_beyond = |v: Vertex| {
            let is_there = before[v as usize].is_some() != is_before;
            has_two_sides && is_there && !is_inside(v)
        };
        let tail = rest(problem, agent, entry, (steps, &is_beyond));
        if let (Some(there), Some(tail)) = (steps[task.start as usize], tail) {
            let release = there.saturating_add(task.delay().max(task.earliest_move));
            let work = 1;
            jobs.push(Job {
                agent,
                way,
                release,
                work,
                tail,
            });
        }
    }
    Ok(Some(Bottleneck {
        gate: Gate::Passage(cells),
        machine,
        jobs,
    }))
}

/// The steps behind an agent for which no other one may be at a vertex, where a rule says so
/// of all of these agents.
pub(super) fn gap_of(problem: &Problem, agents: &[AgentId]) -> u32 {
    let gaps = problem.between.rules.iter().map(|rule| match rule.kind {
        SharedKind::Gap { steps } if agents.iter().all(|&agent| rule.binds(agent)) => steps,
        SharedKind::Gap { .. } | SharedKind::Capacity { .. } | SharedKind::Apart { .. } => 0,
    });
    gaps.max().unwrap_or(0)
}

/// The least steps of an agent from a vertex, from which so many `steps` lead to others, to its
/// arrival; it has seen no vertex that `is_beyond` holds of.
pub(super) fn rest(
    problem: &Problem,
    agent: AgentId,
    from: Vertex,
    (steps, is_beyond): (&[Option<u32>], &dyn Fn(Vertex) -> bool),
) -> Option<u32> {
    let task = &problem.tasks[agent];
    let goal = task.goal?;
    if task.conditions.counters.is_empty() {
        let ahead = task.waypoints.iter().filter(|&&v| is_beyond(v));
        let ahead = ahead.fold(0, |ahead, &v| ahead | task.bit(v));
        let mask = task.all() & !ahead;
        let full = task
            .reserve
            .map_or(0, |reserve| reserve.full.max(reserve.initial));
        return problem.cost_to_go[agent].from(from, mask, full);
    }
    // Of what is counted on the way nothing is known here.
    let least = steps[goal as usize]?;
    let by_way = task.waypoints.iter().filter(|&&v| is_beyond(v));
    let by_way = by_way.filter_map(|&v| {
        let (at, goal) = (problem.terrain.cell(v), problem.terrain.cell(goal));
        let on = at.x.abs_diff(goal.x) + at.y.abs_diff(goal.y);
        Some(steps[v as usize]?.saturating_add(on))
    });
    Some(by_way.fold(least, u32::max))
}

/// The goal of an agent that may go to it on any way.
pub(super) fn goal_of(task: &Task) -> Option<Vertex> {
    task.goal.filter(|_| task.along().is_none())
}
