//! The agents that have to pass a gate: when each can be there, and what it needs afterwards.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Cost, Instance};

use super::{Counted, Gate, Pace};
use crate::Budget;
use crate::exhaust::{Exhausted, least};

/// An agent that has to pass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Job {
    pub(super) agent: usize,
    /// Which of the two ways it goes.
    pub(super) way: usize,
    /// The first time at which it can be in the gate.
    pub(super) release: u32,
    /// The time points that it needs there.
    pub(super) work: u32,
    /// What it needs at least after its start there, or after its work.
    pub(super) tail: u32,
}

/// What each agent costs at least alone.
pub(super) fn alone(instance: &Instance, budget: &Budget<'_>) -> Option<Vec<u32>> {
    let mut all = Vec::new();
    for agent in 0..instance.agents().len() {
        match least(instance, agent, Cost::SumOfCosts, budget) {
            Exhausted::Plan(n) => all.push(n),
            // It costs more than anything, so whatever is said of it is true.
            Exhausted::NoPlan => all.push(0),
            Exhausted::Stopped => return None,
        }
    }
    Some(all)
}

/// What there is to count at a gate; `None` where the budget ran out.
pub(super) fn jobs(instance: &Instance, gate: &Gate, budget: &Budget<'_>) -> Option<Vec<Counted>> {
    let mut counted = Vec::new();
    if !gate.is_row {
        counted.push(by_places(instance, gate)?);
    }
    if gate.most == 1 {
        counted.extend(by_turns(instance, gate, budget)?);
    }
    Some(counted)
}

/// Steps from the nearest of some cells, over those that are allowed.
fn steps(
    instance: &Instance,
    from: impl IntoIterator<Item = Cell>,
    allowed: &dyn Fn(Cell) -> bool,
) -> BTreeMap<Cell, u32> {
    let grid = instance.grid();
    let mut steps = BTreeMap::new();
    let mut open: BTreeMap<u32, Vec<Cell>> = BTreeMap::from([(0, from.into_iter().collect())]);
    while let Some((now, cells)) = open.pop_first() {
        for cell in cells {
            if steps.contains_key(&cell) {
                continue;
            }
            steps.insert(cell, now);
            for next in grid.neighbours(cell).filter(|&next| allowed(next)) {
                let then = now + 1 + u32::from(grid.is_slow_edge(cell, next));
                open.entry(then).or_default().push(next);
            }
        }
    }
    steps
}

/// The least time points in a gate on the way from a cell, to each other one.
fn inside(instance: &Instance, start: Cell, gate: &BTreeSet<Cell>) -> BTreeMap<Cell, u32> {
    let grid = instance.grid();
    let at = |cell: Cell| u32::from(gate.contains(&cell));
    let mut known: BTreeMap<Cell, u32> = BTreeMap::new();
    let mut open: BTreeMap<u32, Vec<Cell>> = BTreeMap::from([(at(start), vec![start])]);
    while let Some(mut entry) = open.first_entry() {
        let spent = *entry.key();
        let Some(cell) = entry.get_mut().pop() else {
            entry.remove();
            continue;
        };
        if known.contains_key(&cell) {
            continue;
        }
        known.insert(cell, spent);
        for next in grid.neighbours(cell) {
            // Half way it is at both ends.
            let half = grid.is_slow_edge(cell, next) && (at(cell) > 0 || at(next) > 0);
            let then = spent + u32::from(half) + at(next);
            open.entry(then).or_default().push(next);
        }
    }
    known
}

fn by_places(instance: &Instance, gate: &Gate) -> Option<Counted> {
    let grid = instance.grid();
    let cells: BTreeSet<Cell> = gate.cells.iter().copied().collect();
    let near = steps(instance, gate.cells.iter().copied(), &|_| true);
    let is_slow = |&cell: &Cell| {
        grid.neighbours(cell)
            .any(|next| grid.is_slow_edge(cell, next))
    };
    let early = u32::from(gate.cells.iter().any(is_slow));
    let mut jobs = Vec::new();
    for &agent in &gate.agents {
        let it = instance.agents().get(agent)?;
        let Some(goal) = it.goal else { continue };
        let from = inside(instance, it.start, &cells);
        let Some(&through) = from.get(&goal) else {
            continue;
        };
        let to = inside(instance, goal, &cells);
        let by = it.waypoints.iter().filter_map(|cell| {
            let both = from.get(cell)? + to.get(cell)?;
            Some(both - u32::from(cells.contains(cell)))
        });
        let work = by.fold(through, u32::max);
        let steps = |cell: Cell| near.get(&cell).map(|steps| steps.saturating_sub(early));
        if work > 0
            && let (Some(release), Some(tail)) = (steps(it.start), steps(goal))
        {
            let held = if cells.contains(&it.start) {
                0
            } else {
                held(instance, agent)
            };
            jobs.push(Job {
                agent,
                way: 0,
                release: release + held,
                work,
                tail,
            });
        }
    }
    let pace = Pace::Places(gate.most);
    Some(Counted { jobs, pace })
}

/// The parts of the map beside a gate, each by its cells, and the cells of the gate that it touches, once for
/// each edge.
fn parts(instance: &Instance, gate: &BTreeSet<Cell>) -> Vec<(BTreeSet<Cell>, Vec<Cell>)> {
    let grid = instance.grid();
    let mut parts: Vec<(BTreeSet<Cell>, Vec<Cell>)> = Vec::new();
    for &cell in gate {
        for next in grid.neighbours(cell).filter(|next| !gate.contains(next)) {
            if let Some((_, edges)) = parts.iter_mut().find(|(part, _)| part.contains(&next)) {
                edges.push(cell);
                continue;
            }
            let mut part = BTreeSet::from([next]);
            let mut open = VecDeque::from([next]);
            while let Some(here) = open.pop_front() {
                for there in grid.neighbours(here) {
                    if !gate.contains(&there) && part.insert(there) {
                        open.push_back(there);
                    }
                }
            }
            parts.push((part, vec![cell]));
        }
    }
    parts
}

fn by_turns(instance: &Instance, gate: &Gate, budget: &Budget<'_>) -> Option<Vec<Counted>> {
    let grid = instance.grid();
    let cells: BTreeSet<Cell> = gate.cells.iter().copied().collect();
    let parts = parts(instance, &cells);
    let is_slow = |&cell: &Cell| {
        grid.neighbours(cell)
            .any(|next| grid.is_slow_edge(cell, next))
    };
    let is_fast = !gate.cells.iter().any(is_slow);
    let has_two = parts.len() == 2;
    // A zone is passed by turns only where it has two sides; a cell may have more.
    if parts.len() < 2 || !(gate.is_row || has_two && is_fast) {
        return Some(Vec::new());
    }
    let entries = |part: usize| {
        parts
            .get(part)
            .map_or(&[][..], |(_, edges)| edges.as_slice())
    };
    let within = |cell: Cell| cells.contains(&cell);
    let across = steps(instance, entries(0).iter().copied(), &within);
    let ends = entries(1).iter().filter_map(|cell| across.get(cell));
    let length = ends.min().map_or(1, |steps| steps + 1);
    let mut jobs = Vec::new();
    for &agent in &gate.agents {
        let it = instance.agents().get(agent)?;
        let Some(goal) = it.goal else { continue };
        let side = |cell: Cell| parts.iter().position(|(part, _)| part.contains(&cell));
        let (Some(from), Some(to)) = (side(it.start), side(goal)) else {
            continue;
        };
        if from == to {
            continue;
        }
        let own = &parts[from].0;
        let way = steps(instance, entries(from).iter().copied(), &|cell| {
            own.contains(&cell)
        });
        let beyond = |cell: &Cell| has_two && parts[to].0.contains(cell);
        let mut tail = u32::MAX;
        for entry in entries(from).iter().collect::<BTreeSet<_>>() {
            tail = tail.min(rest(instance, it, *entry, &beyond, budget)?);
        }
        if let Some(&release) = way.get(&it.start) {
            jobs.push(Job {
                agent,
                way: if has_two { from } else { 0 },
                release: release + held(instance, agent),
                work: 1,
                tail,
            });
        }
    }
    let of: Vec<usize> = jobs.iter().map(|job| job.agent).collect();
    let gap = gap(instance, if gate.is_row { &of } else { &gate.agents });
    let same = if gate.is_row { 1 + gap } else { length };
    let out = if instance.stays() { gap } else { 0 };
    // Who comes out by the only edge meets there who goes in.
    let towards = |exits: &[Cell]| match exits {
        [_] if has_two && is_fast => length + 2 + out,
        _ => same,
    };
    let towards = [towards(entries(1)).max(same), towards(entries(0)).max(same)];
    let pace = Pace::Apart { same, towards };
    Some(vec![Counted { jobs, pace }])
}

/// The steps for which a rule keeps an agent where it starts.
fn held(instance: &Instance, agent: usize) -> u32 {
    let held = instance.constraints_in_force().filter_map(|rule| {
        let is_bound = rule.agents.contains(&agent);
        match rule.constraint.kind {
            ConstraintKind::Depart { from } if is_bound => Some(from),
            _ => None,
        }
    });
    held.max().unwrap_or(0)
}

/// The gap that a rule demands of all of these agents.
fn gap(instance: &Instance, agents: &[usize]) -> u32 {
    let gaps = instance.constraints_in_force().filter_map(|rule| {
        let binds = agents.iter().all(|agent| rule.agents.contains(agent));
        match rule.constraint.kind {
            ConstraintKind::Gap { steps } if binds => Some(steps),
            _ => None,
        }
    });
    gaps.max().unwrap_or(0)
}

/// The least steps of an agent from a cell on with a full battery, when it has seen all
/// waypoints but some; rules of the scene's own are left out.
fn rest(
    instance: &Instance,
    agent: &Agent,
    from: Cell,
    is_left: &dyn Fn(&Cell) -> bool,
    budget: &Budget<'_>,
) -> Option<u32> {
    let mut scene = instance.to_scene();
    let mut agent = agent.clone();
    agent.start = from;
    agent.waypoints.retain(is_left);
    if let Some(battery) = &mut agent.battery {
        battery.initial = battery.capacity;
    }
    scene.agents = vec![agent];
    scene.constraints.clear();
    scene.zones.clear();
    scene.assumptions.clear();
    let Ok(alone) = Instance::new(scene) else {
        return Some(0);
    };
    match least(&alone, 0, Cost::Makespan, budget) {
        Exhausted::Plan(steps) => Some(steps),
        Exhausted::NoPlan => Some(0),
        Exhausted::Stopped => None,
    }
}
