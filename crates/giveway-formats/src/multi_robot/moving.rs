//! Reads `dynamic_obstacles`: obstacles that move, each with its states over time.
//!
//! ```text
//! dynamic_obstacles:
//!   forklift:
//!     - {t: 0, x: 6, y: 1}
//! ```
//!
//! Source: `single_agent_planner/sipp` and `centralized/sipp` of
//! `atb033/multi_agent_path_planning`. An obstacle is nowhere before its first state, stays
//! where it is between two states, and stays at the last one. In the scene, rules close its
//! cells at these times. No rule forbids an exchange of cells at a time, so where one is
//! possible the scene assumes the obstacle, too.

use super::schedule::{Track, states};
use std::collections::BTreeSet;

use crate::limits::Steps;
use crate::unknown_keys::UnknownKeys;
use crate::yaml::{Kind, Yaml};
use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, MAX_CONSTRAINTS, MAX_NUMBER, MAX_ZONES};
use giveway_model::words::and;
use giveway_model::{Assumption, Cell, Constraint, Fault, Grid, Scene, Zone, tr, tr_later};

/// An obstacle that moves.
pub(super) struct Moving {
    name: String,
    /// Its cell at each time from 0.
    path: Vec<Cell>,
}

/// The key of the obstacles.
const WAY: &str = "dynamic_obstacles";

/// A cell that is on no map.
pub(super) const NOWHERE: Cell = Cell::new(u32::MAX, u32::MAX);

/// The obstacles, in the order of the file.
pub(super) fn obstacles(
    y: &mut Yaml<'_>,
    (steps, unknown): (&mut Steps, &mut UnknownKeys),
) -> Result<Vec<Moving>, Fault> {
    let mut obstacles = Vec::new();
    let expected = tr_later!("an object with a list of states for each obstacle");
    match y.kind()? {
        Kind::Scalar => {
            if let Some(text) = y.optional(expected)? {
                return Err(y.unlike(&text, expected));
            }
        }
        Kind::List => y.list(expected, |y, index| {
            let name = format!("obstacle{}", index + 1);
            obstacles.extend(moving(name, states(y, (steps, unknown, WAY))?));
            Ok(())
        })?,
        Kind::Object => y.object(expected, |y, name| {
            obstacles.extend(moving(name.to_owned(), states(y, (steps, unknown, WAY))?));
            Ok(())
        })?,
    }
    Ok(obstacles)
}

/// Nothing where there is no state.
fn moving(name: String, track: Track) -> Option<Moving> {
    let (begins, cells) = track.timed();
    let cell = |(time, pair): (usize, crate::Pair)| {
        if time < begins {
            NOWHERE
        } else {
            Cell::new(pair.first.cast_unsigned(), pair.second.cast_unsigned())
        }
    };
    let path: Vec<Cell> = cells.into_iter().enumerate().map(cell).collect();
    (!path.is_empty()).then_some(Moving { name, path })
}

/// Makes the obstacles rules and assumptions of a scene; the remark on it, a sentence.
pub(super) fn close(scene: &mut Scene, obstacles: Vec<Moving>) -> Option<String> {
    let Ok(grid) = Grid::from_rows(&scene.map) else {
        return None; // the scene is refused anyway
    };
    let (mut names, mut closed_by_rules) = (BTreeSet::new(), Vec::new());
    for Moving { name, path } in obstacles {
        let (zones, rules) = rules(&name, &path, &grid);
        let closed = scene.zones.len() + zones.len() <= MAX_ZONES
            && scene.constraints.len() + rules.len() <= MAX_CONSTRAINTS
            && path.len() < MAX_NUMBER as usize
            && names.insert(name.clone());
        if closed && !rules.is_empty() {
            scene.zones.extend(zones);
            scene.constraints.extend(rules);
            closed_by_rules.push(name.clone());
        }
        if !closed || may_swap(&path, &grid) {
            let moving = Assumption::MovingObstacle { name, path, closed };
            scene.assumptions.push(moving);
        }
    }
    (!closed_by_rules.is_empty()).then(|| {
        tr!(
            "Rules of the scene close the cells where {names} is, at the times at which it is there."
                | "Rules of the scene close the cells where {names} are, at the times at which they are there."
                % closed_by_rules.len(),
            names = and(&closed_by_rules)
        )
    })
}

/// A zone for each free cell where an obstacle is, and a rule for each stay there.
pub(super) fn rules(name: &str, path: &[Cell], grid: &Grid) -> (Vec<Zone>, Vec<Constraint>) {
    let mut cells = BTreeSet::new();
    let (mut zones, mut rules): (Vec<Zone>, Vec<Constraint>) = Default::default();
    let mut begin = 0;
    for stay in path.chunk_by(|a, b| a == b) {
        let (from, end) = (begin, begin + stay.len());
        begin = end;
        let Some(&cell) = stay.first().filter(|&&cell| grid.is_vertex(cell)) else {
            continue;
        };
        let zone = format!("{name} {cell}");
        if cells.insert(cell) {
            zones.push(Zone::of(zone.clone(), vec![cell]));
        }
        let time = |time: usize| u32::try_from(time).ok();
        rules.push(Constraint {
            kind: ConstraintKind::Closed {
                zone,
                times: Times {
                    from: time(from).filter(|&from| from > 0),
                    // At the last one it stays.
                    to: time(end - 1).filter(|_| end < path.len()),
                },
            },
            agents: None,
            name: Some(format!("{name} {}", rules.len() + 1)),
            off: false,
        });
    }
    (zones, rules)
}

/// Whether an agent could exchange cells with an obstacle.
fn may_swap(path: &[Cell], grid: &Grid) -> bool {
    path.windows(2).any(|pair| match *pair {
        [from, to] => {
            let apart = from.x.abs_diff(to.x).saturating_add(from.y.abs_diff(to.y));
            apart == 1 && grid.is_vertex(from) && grid.is_vertex(to)
        }
        _ => false,
    })
}
