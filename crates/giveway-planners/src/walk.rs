//! A walk: where one agent is at each time, as the search sees it.

use giveway_model::{Cell, Costs, Plan, Version};

use crate::{
    problem::Problem,
    single::{Place, Task},
    terrain::{Arc, Terrain},
};

/// The places of an agent at each time from 0 to its arrival.
pub type Walk = Vec<Place>;

/// The arrival of a walk.
pub fn arrival(walk: &[Place]) -> u32 {
    (walk.len() as u32).saturating_sub(1)
}

/// The arc crossed in the step that begins at a time, if one is.
pub fn crossed(terrain: &Terrain, walk: &[Place], time: usize) -> Option<Arc> {
    let by_id = |id: u32| {
        let (from, _) = terrain.ends(id);
        terrain.arcs(from).iter().find(|arc| arc.id == id).copied()
    };
    match (*walk.get(time)?, *walk.get(time + 1)?) {
        (_, Place::Along(id)) | (Place::Along(id), _) => by_id(id),
        (Place::At(u), Place::At(v)) => terrain.arcs(u).iter().find(|arc| arc.to == v).copied(),
    }
}

/// The fewest charges with which a walk can be made, each as late as it can be;
/// `None` where the battery does not last.
pub fn charges(task: &Task, terrain: &Terrain, walk: &[Place]) -> Option<Vec<u32>> {
    match task.reserve {
        Some(_) => with_charges(task, terrain, walk, &mut Vec::new()),
        None => Some(Vec::new()),
    }
}

/// The same where it charges at some times, in order, and at the chargers at which it
/// must: at any of the times at which it is there, what is before and after it as it is
/// best.
fn with_charges(
    task: &Task,
    terrain: &Terrain,
    walk: &[Place],
    fixed: &mut Vec<u32>,
) -> Option<Vec<u32>> {
    let free = fewest(task, terrain, walk, fixed)?;
    let is_at = |time: u32, v| walk.get(time as usize) == Some(&Place::At(v));
    let mut required = task.conditions.charges();
    let Some((_, v)) = required.find(|&(_, v)| !free.iter().any(|&time| is_at(time, v))) else {
        return Some(free);
    };
    let mut best: Option<Vec<u32>> = None;
    let times = 0..arrival(walk);
    for time in times.filter(|&time| is_at(time, v) && task.may_charge(terrain, v, Some(time))) {
        let place = fixed.partition_point(|&other| other < time);
        fixed.insert(place, time);
        if let Some(charges) = with_charges(task, terrain, walk, fixed)
            && best.as_ref().is_none_or(|best| charges.len() <= best.len())
        {
            best = Some(charges);
        }
        fixed.remove(place);
    }
    best
}

/// Whether the battery lasts for a walk with these charges, which are allowed.
pub fn lasts(task: &Task, walk: &[Place], charges: &[u32]) -> bool {
    let Some(reserve) = task.reserve else {
        return charges.is_empty();
    };
    let mut level = Some(reserve.initial);
    for time in 0..arrival(walk) {
        level = match level {
            Some(_) if charges.contains(&time) => Some(reserve.full),
            Some(level) => level.checked_sub(1),
            None => None,
        };
    }
    level.is_some()
}

/// The fewest charges, among them those at some times, in order.
fn fewest(task: &Task, terrain: &Terrain, walk: &[Place], fixed: &[u32]) -> Option<Vec<u32>> {
    let reserve = task.reserve?;
    // The battery lasts up to and including this time.
    let mut until = reserve.initial;
    let mut charges = Vec::new();
    let mut last_charger = None;
    for (time, place) in walk.iter().enumerate() {
        let time = time as u32;
        if time > until {
            let charge: u32 = last_charger.take()?;
            charges.push(charge);
            until = charge + 1 + reserve.full;
            if time > until {
                return None;
            }
        }
        if fixed.contains(&time) {
            charges.push(time);
            until = time + 1 + reserve.full;
            last_charger = None;
        } else if matches!(place, Place::At(v) if task.may_charge(terrain, *v, Some(time))) {
            last_charger = Some(time);
        }
    }
    Some(charges)
}

/// The costs of one agent's walk.
pub fn costs_of(problem: &Problem, agent: usize, walk: &[Place]) -> Costs {
    let arrival = arrival(walk);
    let task = &problem.tasks[agent];
    let charges = charges(task, &problem.terrain, walk);
    let goes_on = u32::from(arrival > 0);
    let mut costs = Costs {
        makespan: arrival,
        sum_of_costs: arrival + goes_on * task.cost_if_it_leaves_goal,
        charges: charges.map_or(0, |c| c.len() as u32),
        waits: goes_on * task.waits_if_it_leaves_goal,
        ..Costs::default()
    };
    for (pair, now) in walk.windows(2).zip(0..) {
        let penalty = task.penalty_at(&problem.terrain, pair[0], now);
        costs.penalty = costs.penalty.saturating_add(penalty);
        match (pair[0], pair[1]) {
            (Place::At(u), Place::At(v)) if u == v => costs.waits += 1,
            (Place::Along(_), _) => {}
            _ => costs.moves += 1,
        }
    }
    costs
}

/// The costs of walks, one an agent.
pub fn costs(problem: &Problem, walks: &[Walk]) -> Costs {
    let mut costs = Costs::default();
    for (agent, walk) in walks.iter().enumerate() {
        let own = costs_of(problem, agent, walk);
        costs.makespan = costs.makespan.max(own.makespan);
        costs.sum_of_costs += own.sum_of_costs;
        costs.charges += own.charges;
        costs.moves += own.moves;
        costs.waits += own.waits;
        costs.penalty = costs.penalty.saturating_add(own.penalty);
    }
    costs
}

/// The walks of a plan that the judge passes, in the order of the names; `None`
/// where it is not one over this problem.
pub fn walks_of_plan(problem: &Problem, names: &[String], plan: &Plan) -> Option<Vec<Walk>> {
    let agents = names.iter().zip(&problem.tasks);
    let walk = |(name, task): (&String, &Task)| of_path(task, &problem.terrain, plan.path(name));
    agents.map(walk).collect()
}

/// The path of an agent as a walk; `None` where it is none over this terrain.
pub fn of_path(task: &Task, terrain: &Terrain, path: &[Option<Cell>]) -> Option<Walk> {
    let mut walk = Walk::with_capacity(path.len());
    for (time, entry) in path.iter().enumerate() {
        walk.push(match (entry, time.checked_sub(1)) {
            (Some(cell), _) => Place::At(terrain.vertex(*cell)?),
            (None, None) => task.first_place(),
            (None, Some(before)) => {
                let from = terrain.vertex((*path.get(before)?)?)?;
                let to = terrain.vertex((*path.get(time + 1)?)?)?;
                let arc = terrain.arcs(from).iter().find(|arc| arc.to == to)?;
                Place::Along(arc.id)
            }
        });
    }
    Some(walk)
}

/// Walks as a plan.
pub fn to_plan(problem: &Problem, names: &[String], walks: &[Walk]) -> Plan {
    let mut plan = Plan {
        giveway: Version,
        ..Plan::default()
    };
    for ((name, task), walk) in names.iter().zip(&problem.tasks).zip(walks) {
        let cell = |place: &Place| match *place {
            Place::At(v) => Some(problem.terrain.cell(v)),
            Place::Along(_) => None,
        };
        plan.paths
            .insert(name.clone(), walk.iter().map(cell).collect());
        let charges = charges(task, &problem.terrain, walk).unwrap_or_default();
        if !charges.is_empty() {
            plan.charges.insert(name.clone(), charges);
        }
    }
    plan
}
