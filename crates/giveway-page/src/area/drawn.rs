//! An area as SVG path data, in units of the map.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use giveway_model::{Cell, Ground};
use giveway_picture::{Area as Part, Pen, Region};

use super::{Area, Clip, frame};

/// How a ghost is drawn: a little inside of its cells, so that its line is whole.
const PEN: Pen = Pen {
    inset: 3,
    radius: 12,
    overlap: 0,
};

/// What is on an area: its ground but for free cells, neighbouring ones as one shape, and discs
/// where robots start.
pub(super) fn content(clip: &Clip) -> String {
    let [x0, y0, x1, y1] = frame(&clip.cells);
    let part = Part {
        first: Cell::new(x0, y0),
        size: (x1 - x0 + 1, y1 - y0 + 1),
    };
    let ground = clip.ground.iter();
    let drawn: BTreeSet<Cell> = ground
        .filter(|(_, ground)| *ground != Ground::Free)
        .map(|&(cell, _)| cell)
        .collect();
    let mut path = Region::new(part, |cell| drawn.contains(&cell)).fill(PEN);
    for agent in &clip.agents {
        let Cell { x, y } = agent.start;
        let _ = write!(
            path,
            "M{} {}a35 35 0 1 0 70 0a35 35 0 1 0-70 0z",
            100 * x + 15,
            100 * y + 50
        );
    }
    path
}

/// The sides of an area that are not sides of two of its cells.
pub(super) fn outline(area: &Area) -> String {
    if area.is_rectangle() {
        let [x0, y0, x1, y1] = area.frame();
        let (width, height) = (100 * (x1 - x0 + 1), 100 * (y1 - y0 + 1));
        return format!("M{} {}h{width}v{height}h-{width}z", 100 * x0, 100 * y0);
    }
    let [x0, y0, ..] = frame(&area.cells);
    let [dx, dy, ..] = area.frame();
    let has = |x: Option<u32>, y: Option<u32>| {
        x.zip(y)
            .is_some_and(|(x, y)| area.cells.contains(&Cell::new(x, y)))
    };
    let mut path = String::new();
    for &Cell { x, y } in area.cells.iter() {
        let (left, top) = (100 * (x - x0 + dx), 100 * (y - y0 + dy));
        let sides = [
            (has(x.checked_sub(1), Some(y)), (0, 0), "v100"),
            (has(x.checked_add(1), Some(y)), (100, 0), "v100"),
            (has(Some(x), y.checked_sub(1)), (0, 0), "h100"),
            (has(Some(x), y.checked_add(1)), (0, 100), "h100"),
        ];
        for (_, (right, down), side) in sides.into_iter().filter(|(is_within, ..)| !is_within) {
            let _ = write!(path, "M{} {}{side}", left + right, top + down);
        }
    }
    path
}
