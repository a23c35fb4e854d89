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
//! where it is between two states, and stays at the last one.

use super::schedule::{Track, states};
use crate::limits::Steps;
use crate::unknown_keys::UnknownKeys;
use crate::yaml::{Kind, Yaml};
use giveway_model::{Assumption, Cell, Fault, tr_later};

/// The key of the obstacles.
const WAY: &str = "dynamic_obstacles";

/// A cell that is on no map.
pub(super) const NOWHERE: Cell = Cell::new(u32::MAX, u32::MAX);

/// The obstacles, in the order of the file.
pub(super) fn obstacles(
    y: &mut Yaml<'_>,
    (steps, unknown): (&mut Steps, &mut UnknownKeys),
) -> Result<Vec<Assumption>, Fault> {
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
fn moving(name: String, track: Track) -> Option<Assumption> {
    let (begins, cells) = track.timed();
    let cell = |(time, pair): (usize, crate::Pair)| {
        if time < begins {
            NOWHERE
        } else {
            Cell::new(pair.first.cast_unsigned(), pair.second.cast_unsigned())
        }
    };
    let path: Vec<Cell> = cells.into_iter().enumerate().map(cell).collect();
    (!path.is_empty()).then_some(Assumption::MovingObstacle { name, path })
}
