//! Distances from some vertices, over the whole map or a part of it.

use crate::{
    budget::{Budget, Stop},
    single::Area,
    terrain::{Terrain, Vertex},
};

/// Steps to each vertex; `None` where none lead there.
pub(super) type Steps = Vec<Option<u32>>;

/// The steps from the nearest of some vertices over vertices that `may_be` allows. What an
/// agent may not do, and for how long, is left out, so that they are never too many.
pub(super) fn steps_from(
    terrain: &Terrain,
    starts: impl IntoIterator<Item = Vertex>,
    may_be: impl Fn(Vertex) -> bool,
    budget: &dyn Budget,
) -> Result<Steps, Stop> {
    costs_from(
        terrain,
        starts,
        may_be,
        |slow, _, _| 1 + u32::from(slow),
        budget,
    )
}

/// The least time points in an area on the way from a vertex to each other one, both included.
pub(super) fn times_inside(
    terrain: &Terrain,
    start: Vertex,
    area: &Area,
    budget: &dyn Budget,
) -> Result<Steps, Stop> {
    let inside = |slow: bool, from: Vertex, to: Vertex| {
        let half_way = slow && (area.has(from) || area.has(to));
        u32::from(half_way) + u32::from(area.has(to))
    };
    let mut times = costs_from(terrain, [start], |_| true, inside, budget)?;
    let first = u32::from(area.has(start));
    times.iter_mut().flatten().for_each(|time| *time += first);
    Ok(times)
}

/// The least cost from the nearest of some vertices, each move at most 2 (Dial 1969).
fn costs_from(
    terrain: &Terrain,
    starts: impl IntoIterator<Item = Vertex>,
    may_be: impl Fn(Vertex) -> bool,
    of_move: impl Fn(bool, Vertex, Vertex) -> u32,
    budget: &dyn Budget,
) -> Result<Steps, Stop> {
    let mut costs: Steps = vec![None; terrain.size()];
    let mut layers = [starts.into_iter().collect(), Vec::new(), Vec::new()];
    let mut cost = 0;
    while layers.iter().any(|layer: &Vec<Vertex>| !layer.is_empty()) {
        while let Some(v) = layers[0].pop() {
            let known = &mut costs[v as usize];
            if known.is_some() {
                continue;
            }
            *known = Some(cost);
            budget.tick()?;
            for arc in terrain.arcs(v) {
                if costs[arc.to as usize].is_none() && may_be(arc.to) {
                    let more = of_move(arc.slow, v, arc.to).min(2);
                    layers[more as usize].push(arc.to);
                }
            }
        }
        layers.rotate_left(1);
        cost += 1;
    }
    Ok(costs)
}
