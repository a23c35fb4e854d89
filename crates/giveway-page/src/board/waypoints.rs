//! The waypoints of a robot in the order of its plan.

use giveway_model::Cell;
use giveway_model::sorting::sort_by_key;

use super::{Cast, MarkKind};

/// The waypoints of an agent with their numbers from 1, in the order in which its plan visits
/// them first, and with the time of that; those that it does not visit come last, in the order of
/// the scene.
pub fn waypoint_numbers(cast: &Cast, agent: usize) -> Vec<(Cell, u32, Option<u32>)> {
    let listed = cast.agents.get(agent).map_or(&[][..], |own| &own.waypoints);
    let own = |cell: Cell| {
        let mut marks = cast.marks.iter();
        let mark = marks.find(|mark| {
            mark.agent == agent && mark.kind == MarkKind::Waypoint && mark.cell == cell
        });
        mark.and_then(|mark| mark.visited)
            .filter(|_| cast.has_plan())
    };
    let mut cells: Vec<(Cell, Option<u32>)> =
        listed.iter().map(|&cell| (cell, own(cell))).collect();
    sort_by_key(&mut cells, |&(_, visited)| visited.unwrap_or(u32::MAX));
    let numbered = (1..).zip(cells);
    numbered
        .map(|(number, (cell, visited))| (cell, number, visited))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::planned;
    use super::*;

    #[test]
    fn waypoints_have_the_numbers_of_the_plan() {
        let mut cast = Cast::of(&planned());
        let first = cast.tracks[0].cells_at(1)[0];
        let later = cast.tracks[0].cells_at(cast.tracks[0].arrival())[0];
        cast.agents[0].waypoints = vec![later, first, Cell::new(90, 90)];
        cast.marks = super::super::marks(&cast.agents, &cast.tracks);
        let cells: Vec<_> = waypoint_numbers(&cast, 0)
            .into_iter()
            .map(|it| (it.0, it.1))
            .collect();
        assert_eq!(cells, [(first, 1), (later, 2), (Cell::new(90, 90), 3)]);
        assert_eq!(waypoint_numbers(&cast, 9), []);
    }
}
