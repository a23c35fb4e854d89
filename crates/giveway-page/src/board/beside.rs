//! Where the number of each small robot stands: beside it, on a cell that is free.

use std::collections::BTreeMap;

use giveway_model::{Cell, Grid, Ground};

use super::Cast;

/// A side of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Right of it.
    Right,
    /// Left of it.
    Left,
    /// Above it.
    Above,
    /// Below it.
    Below,
}

impl Side {
    /// All, the best first.
    const ALL: [Self; 4] = [Self::Right, Self::Left, Self::Above, Self::Below];

    /// Its name in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
            Self::Above => "above",
            Self::Below => "below",
        }
    }

    /// The cell on this side of a cell; `None` left of the map and above it.
    fn of(self, cell: Cell) -> Option<Cell> {
        let (x, y) = match self {
            Self::Right => (cell.x.checked_add(1)?, cell.y),
            Self::Left => (cell.x.checked_sub(1)?, cell.y),
            Self::Above => (cell.x, cell.y.checked_sub(1)?),
            Self::Below => (cell.x, cell.y.checked_add(1)?),
        };
        Some(Cell::new(x, y))
    }
}

/// The side on which each robot's number stands from a time to the next one: a side whose cell is
/// no obstacle, and holds neither a robot nor the number of another one in that step. `None` where
/// no side is free, and for robots that are not there.
pub fn sides(cast: &Cast, grid: &Grid, time: u32) -> Vec<Option<Side>> {
    let cells = |agent: usize, time: u32| {
        let track = cast.tracks.get(agent);
        track.map_or_else(Vec::new, |track| track.cells_at(time))
    };
    let next = time.saturating_add(1);
    let agents = 0..cast.agents.len();
    // Whose each cell is in that step; nobody's alone where it holds two, or a number.
    let mut taken: BTreeMap<Cell, Option<usize>> = BTreeMap::new();
    for agent in agents.clone() {
        for cell in [cells(agent, time), cells(agent, next)].concat() {
            let owner = taken.entry(cell).or_insert(Some(agent));
            *owner = owner.filter(|&owner| owner == agent);
        }
    }
    let side = |agent: usize| {
        let (from, to) = (cells(agent, time), cells(agent, next));
        let ends: Vec<Cell> = from.into_iter().chain(to).collect();
        if ends.is_empty() {
            return None;
        }
        // The number goes along: its cell has to be free at both ends of a move.
        let is_free = |cell: &Cell| {
            let ground = grid.ground(*cell);
            let is_floor = ground.is_some_and(|ground| ground != Ground::Obstacle);
            is_floor && taken.get(cell).is_none_or(|owner| *owner == Some(agent))
        };
        let beside = |side: Side| ends.iter().map(|&cell| side.of(cell)).collect::<Vec<_>>();
        let fits = |side: &Side| {
            let beside = beside(*side);
            beside
                .iter()
                .all(|cell| cell.is_some_and(|cell| is_free(&cell)))
        };
        let side = Side::ALL.into_iter().find(fits)?;
        taken.extend(beside(side).into_iter().flatten().map(|cell| (cell, None)));
        Some(side)
    };
    agents.map(side).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::tests::planned;
    use super::*;

    /// A moves along the upper row, B stands still at the end of the lower one for a step.
    #[test]
    fn numbers_stand_on_free_cells() {
        let state = planned();
        let cast = Cast::of(&state);
        let grid = state.world().grid();
        for time in 0..8 {
            let sides = sides(&cast, grid, time);
            let mut numbers = BTreeSet::new();
            for (agent, side) in sides.iter().enumerate() {
                let ends = [time, time + 1].map(|time| cast.tracks[agent].cells_at(time));
                for cell in ends.concat() {
                    let Some(side) = side else { continue };
                    let beside = side.of(cell).unwrap();
                    assert_ne!(grid.ground(beside), Some(Ground::Obstacle));
                    assert!(grid.ground(beside).is_some(), "{beside} at {time}");
                    let others = (0..cast.agents.len()).filter(|&other| other != agent);
                    for other in others {
                        let at = [time, time + 1].map(|time| cast.tracks[other].cells_at(time));
                        assert!(!at.concat().contains(&beside), "{beside} at {time}");
                    }
                    numbers.insert((agent, beside));
                }
            }
            let cells: BTreeSet<Cell> = numbers.iter().map(|number| number.1).collect();
            assert_eq!(
                cells.len(),
                numbers.len(),
                "two numbers on one cell at {time}"
            );
        }
    }

    #[test]
    fn the_right_is_the_best_side() {
        let scene = |map: &str| giveway_model::Scene {
            map: map.split('/').map(str::to_owned).collect(),
            agents: vec![giveway_model::Agent {
                name: "A1".to_owned(),
                start: Cell::new(1, 1),
                goal: None,
                waypoints: Vec::new(),
                battery: None,
                heading: None,
            }],
            ..giveway_model::Scene::default()
        };
        let side = |map: &str| {
            let state = crate::State::new(crate::Draft::new(scene(map)).unwrap());
            sides(&Cast::of(&state), state.world().grid(), 0)[0]
        };
        assert_eq!(side(".../.../..."), Some(Side::Right));
        assert_eq!(side(".../..#/..."), Some(Side::Left));
        assert_eq!(side(".../#.#/..."), Some(Side::Above));
        assert_eq!(side(".#./#.#/..."), Some(Side::Below));
        assert_eq!(side(".#./#.#/.#."), None);
    }
}
