//! How much each cell is used: where a plan is crowded.

use std::collections::BTreeMap;
use std::fmt::Write;

use giveway_model::Cell;

use super::{CELL, Cast, whole};
use crate::MAX_SIDE;

/// Shades of use, from the least used cells to the most used ones.
pub const SHADES: usize = 4;

/// The `d` of a path for each shade, the least used cells first: those that
/// agents stand on for some time steps until they arrive. Steps of the most
/// used cell are divided into equal shares.
pub fn heat(cast: &Cast) -> [String; SHADES] {
    let mut paths: [String; SHADES] = Default::default();
    let uses = uses(cast);
    let most = uses.values().copied().max().unwrap_or(1);
    let side = whole(CELL);
    // A plan of elsewhere may lead off the map.
    let on_page = |(cell, _): &(Cell, usize)| cell.x < MAX_SIDE && cell.y < MAX_SIDE;
    for (cell, steps) in uses.into_iter().filter(on_page) {
        let shade = (steps * SHADES - 1) / most;
        let path = &mut paths[shade.min(SHADES - 1)];
        let (x, y) = (side * cell.x, side * cell.y);
        // (a string takes all that is written to it)
        let _ = write!(path, "M{x} {y}h{side}v{side}h-{side}z");
    }
    paths
}

/// For how many time steps each cell is used by an agent that moves.
fn uses(cast: &Cast) -> BTreeMap<Cell, usize> {
    let mut uses = BTreeMap::new();
    for track in cast.tracks.iter().filter(|track| track.arrival() > 0) {
        for time in 0..=track.arrival() {
            for cell in track.cells_at(time) {
                *uses.entry(cell).or_insert(0) += 1;
            }
        }
    }
    uses
}

#[cfg(test)]
mod tests {
    use super::super::tests::planned;
    use super::*;

    #[test]
    fn cells_are_counted_until_their_agents_arrive() {
        let uses = uses(&Cast::of(&planned()));
        let used = |x, y| uses.get(&Cell::new(x, y)).copied().unwrap_or(0);
        // A is in transit between (2, 0) and (3, 0) at time 3; B waits once at (3, 1).
        assert_eq!([used(0, 0), used(2, 0), used(3, 0)], [1, 2, 2]);
        assert_eq!([used(3, 1), used(2, 1), used(1, 1)], [2, 1, 0]);
    }

    #[test]
    fn the_most_used_cells_have_the_last_shade() {
        let shades = heat(&Cast::of(&planned()));
        assert!(shades[SHADES - 1].contains("M200 0h100"), "{shades:?}");
        assert!(shades[1].contains("M0 0h100"), "{shades:?}");
        assert_eq!([&shades[0], &shades[2]], ["", ""]);
    }

    #[test]
    fn without_a_plan_nothing_is_used() {
        let mut state = planned();
        state.document.answer = None;
        assert!(heat(&Cast::of(&state)).iter().all(String::is_empty));
    }
}
