//! Agents that meet: one at a vertex at a time, no swaps, no slow swaps.

use giveway_model::{Cell, Instance};

use super::agent::Walker;
use super::{Cnf, Lit, Name};

/// At each cell there is at most one agent at each time.
pub(super) fn vertices(cnf: &mut Cnf, instance: &Instance, last: u32, walkers: &[Walker<'_>]) {
    for (cell, _) in instance.grid().cells() {
        for time in 0..=last {
            let here: Vec<Lit> = walkers.iter().filter_map(|w| w.at(cell, time)).collect();
            cnf.at_most_one(&here);
        }
    }
}

/// Each edge has one direction in each step.
///
/// A slow move takes two steps, so two of opposite directions share a step
/// exactly where they begin less than two steps apart.
pub(super) fn edges(cnf: &mut Cnf, instance: &Instance, last: u32, walkers: &[Walker<'_>]) {
    let grid = instance.grid();
    for (u, ground) in grid.cells() {
        if !ground.is_vertex() {
            continue;
        }
        for v in grid.neighbours(u).filter(|&v| v > u) {
            for time in 0..last {
                let forth = crossings(instance, walkers, u, v, time);
                let back = crossings(instance, walkers, v, u, time);
                if forth.is_empty() || back.is_empty() {
                    continue;
                }
                let direction = cnf.variable(Name::Direction(u, v, time));
                for crossing in forth {
                    cnf.implies(&crossing, [direction]);
                }
                for crossing in back {
                    cnf.implies(&crossing, [-direction]);
                }
            }
        }
    }
}

/// The literals of agents on the edge from u to v in the step that begins at the time; all literals of an
/// entry hold together.
fn crossings(
    instance: &Instance,
    walkers: &[Walker<'_>],
    u: Cell,
    v: Cell,
    time: u32,
) -> Vec<Vec<Lit>> {
    let mut crossings = Vec::new();
    for walker in walkers {
        if instance.grid().is_slow_edge(u, v) {
            let halves = [walker.transit(u, v, time), walker.transit(u, v, time + 1)];
            crossings.extend(halves.into_iter().flatten().map(|half| vec![half]));
        } else if let (Some(here), Some(there)) = (walker.at(u, time), walker.at(v, time + 1)) {
            crossings.push(vec![here, there]);
        }
    }
    crossings
}
