//! Where one agent can be at each time, in plans that arrive in time.
//!
//! Unlike the MDDs of the search, which leave out what no better plan needs, the
//! layers hold *every* way from the start to the goal that ends by the cap: also over
//! the goal and back, where agents vanish. Batteries are left to the clauses.

use std::collections::BTreeSet;

use crate::{
    budget::{Budget, Stop},
    problem::Problem,
    single::{Mask, Place, Task},
};

/// A place with the waypoints visited.
pub(super) type Spot = (Place, Mask);

/// The spots of an agent at each time from 0 to its cap.
pub(super) fn layers(
    problem: &Problem,
    agent: usize,
    cap: u32,
    budget: &Budget,
) -> Result<Vec<BTreeSet<Spot>>, Stop> {
    let task = &problem.tasks[agent];
    let mut reached = vec![BTreeSet::from([(task.first_place(), task.first_mask())])];
    for time in 0..cap as usize {
        let mut next = BTreeSet::new();
        for &spot in &reached[time] {
            budget.tick()?;
            next.extend(onward(problem, task, spot));
        }
        reached.push(next);
    }
    let mut later = BTreeSet::new();
    for time in (0..=cap).rev() {
        let may_end = !problem.rests(agent) || time == cap;
        let Some(layer) = reached.get_mut(time as usize) else {
            continue;
        };
        for spot in std::mem::take(layer) {
            budget.tick()?;
            let ends = may_end && is_end(task, spot);
            let mut ways = onward(problem, task, spot).into_iter();
            if ends || ways.any(|to| later.contains(&to)) {
                layer.insert(spot);
            }
        }
        later.clone_from(layer);
    }
    Ok(reached)
}

/// Whether an agent may have arrived at a spot.
pub(super) fn is_end(task: &Task, (place, mask): Spot) -> bool {
    matches!(place, Place::At(v) if task.is_end(v, mask))
}

/// The spots one step after a spot.
pub(super) fn onward(problem: &Problem, task: &Task, (place, mask): Spot) -> Vec<Spot> {
    let terrain = &problem.terrain;
    match place {
        Place::Along(arc) => {
            let (_, to) = terrain.ends(arc);
            vec![(Place::At(to), mask | task.bit(to))]
        }
        Place::At(u) => {
            let mut spots = vec![(place, mask)];
            for arc in terrain.arcs(u) {
                spots.push(if arc.slow {
                    (Place::Along(arc.id), mask)
                } else {
                    (Place::At(arc.to), mask | task.bit(arc.to))
                });
            }
            spots
        }
    }
}
