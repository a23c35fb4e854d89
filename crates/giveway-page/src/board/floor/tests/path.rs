//! Path data read back: the lines of a path, its points, what is inside of it.

use std::collections::BTreeSet;

/// A straight line between two points, in units.
type Line = [(f64, f64); 2];

/// The lines of a path, arcs in short pieces.
fn pieces(path: &str) -> Vec<Line> {
    let mut pieces = Vec::new();
    let (mut at, mut begin) = ((0.0, 0.0), (0.0, 0.0));
    for part in path
        .split_inclusive(|c: char| "MHVaZ".contains(c))
        .scan('M', |kind, part| {
            let numbers = part.trim_end_matches(|c: char| "MHVaZ".contains(c));
            let this = (*kind, numbers.to_owned());
            *kind = part.chars().last().unwrap();
            Some(this)
        })
    {
        let (kind, numbers) = part;
        let numbers: Vec<f64> = numbers
            .split_whitespace()
            .map(|n| n.parse().unwrap())
            .collect();
        if numbers.is_empty() {
            continue;
        }
        let from = at;
        match kind {
            'M' => (at, begin) = ((numbers[0], numbers[1]), (numbers[0], numbers[1])),
            'H' => at.0 = numbers[0],
            'V' => at.1 = numbers[0],
            _ => {
                at = (from.0 + numbers[5], from.1 + numbers[6]);
                pieces.extend(arc(from, at, numbers[4] > 0.5));
                continue;
            }
        }
        if kind != 'M' {
            pieces.push([from, at]);
        }
    }
    assert!(begin.0.is_finite());
    pieces
}

/// A quarter of a circle, clockwise or not.
fn arc(from: (f64, f64), to: (f64, f64), is_clockwise: bool) -> Vec<Line> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    // Of the two other corners of the square around it one is its middle.
    let is_first = (dx * dy > 0.0) == is_clockwise;
    let middle = if is_first {
        (from.0, to.1)
    } else {
        (to.0, from.1)
    };
    let point = |step: i32| {
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(step) / 8.0;
        let (a, b) = (angle.cos(), angle.sin());
        let (u, v) = (
            (from.0 - middle.0, from.1 - middle.1),
            (to.0 - middle.0, to.1 - middle.1),
        );
        (middle.0 + a * u.0 + b * v.0, middle.1 + a * u.1 + b * v.1)
    };
    (0..8).map(|step| [point(step), point(step + 1)]).collect()
}

/// The points of a path, to a unit: each line by the units that it goes over.
pub(super) fn points(path: &str) -> BTreeSet<(i32, i32)> {
    let mut points = BTreeSet::new();
    for [from, to] in pieces(path) {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let count = length.ceil() as i32;
        for step in 0..=count {
            let part = f64::from(step) / f64::from(count.max(1));
            let at = |a: f64, b: f64| (a + (b - a) * part).round() as i32;
            points.insert((at(from.0, to.0), at(from.1, to.1)));
        }
    }
    points
}

/// The lines of a path by which a horizontal line can tell what is inside of it.
pub(super) fn crossings(path: &str) -> Vec<Line> {
    let pieces = pieces(path).into_iter();
    pieces
        .filter(|[from, to]| (from.1 - to.1).abs() > 1e-9)
        .collect()
}

/// Whether a path goes around a point: nonzero, as SVG fills.
pub(super) fn is_inside(crossings: &[Line], (x, y): (f64, f64)) -> bool {
    let crosses = |[from, to]: &Line| {
        let is_down = from.1 < y && y <= to.1;
        let is_up = to.1 < y && y <= from.1;
        let at = from.0 + (y - from.1) / (to.1 - from.1) * (to.0 - from.0);
        match (at > x, is_down, is_up) {
            (true, true, _) => 1,
            (true, _, true) => -1,
            _ => 0,
        }
    };
    crossings.iter().map(crosses).sum::<i32>() != 0
}
