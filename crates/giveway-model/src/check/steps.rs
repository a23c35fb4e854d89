//! A path as a sequence of steps.

use crate::{Cell, Grid};

/// The step of an agent from one listed cell to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// It waits a step.
    Wait,
    /// It crosses a normal edge in a step.
    Move { from: Cell, to: Cell },
    /// It crosses a slow edge in two steps.
    SlowMove { from: Cell, to: Cell },
    /// It does what no agent can.
    Broken { from: Cell, to: Cell, why: Broken },
}

/// Why a step is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Broken {
    /// The cells do not share a side.
    Jump,
    /// A slow edge in one step.
    TooFast,
    /// A normal edge in two steps.
    TooSlow,
    /// In transit, then back where it was.
    TurnBack,
    /// In transit for more than one step.
    LongTransit,
}

/// The steps of a path, each with the time at which it begins. Entries in
/// transit at the very beginning and end belong to no step.
pub(crate) fn steps<'a>(
    grid: &'a Grid,
    path: &'a [Option<Cell>],
) -> impl Iterator<Item = (usize, Step)> + 'a {
    let mut stops = path
        .iter()
        .enumerate()
        .filter_map(|(time, cell)| cell.map(|cell| (time, cell)));
    let mut last = stops.next();
    stops.filter_map(move |(time, to)| {
        let (begin, from) = last.replace((time, to))?;
        Some((begin, step(grid, from, to, time - begin)))
    })
}

/// The step from a cell to another that takes some time.
pub(crate) fn step(grid: &Grid, from: Cell, to: Cell, duration: usize) -> Step {
    let why = match duration {
        1 if from == to => return Step::Wait,
        2 if from == to => Broken::TurnBack,
        1 | 2 if !from.touches(to) => Broken::Jump,
        1 if grid.is_slow_edge(from, to) => Broken::TooFast,
        1 => return Step::Move { from, to },
        2 if grid.is_slow_edge(from, to) => return Step::SlowMove { from, to },
        2 => Broken::TooSlow,
        _ => Broken::LongTransit,
    };
    Step::Broken { from, to, why }
}
