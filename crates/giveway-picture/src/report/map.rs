//! The map of a report: starts are full discs, goals squares, busy cells letters, so that nothing
//! needs colour.

use std::collections::BTreeSet;
use std::fmt::{Arguments, Write as _};

use giveway_model::{Cell, Grid, Ground, tr};

use super::{BusyCell, RobotRow, Sign, Subject, marks};
use crate::outline::around;
use crate::xml::Escaped;
use crate::{CELL, lines};

/// Of larger maps no lines are drawn between cells.
const LINED: u32 = 64;
/// The side of a cell where there is room, in pixels.
const CELL_PX: f64 = 38.0;
/// The room for the numbers of columns and rows, as a part of the longer side.
const RIM: f64 = 0.028;

/// The map as SVG, and its signs.
pub(super) fn map(
    subject: &Subject<'_>,
    robots: &[RobotRow],
    busiest: &[BusyCell],
) -> (String, Vec<Sign>) {
    let grid = subject.grid();
    let mut svg = sheet(grid);
    let ground = ground(&mut svg, grid);
    marks::marks(&mut svg, robots);
    for busy in busiest {
        let place = if is_taken(busy.cell, robots) {
            Place::Corner
        } else if grid.is_charger(busy.cell) {
            Place::Right
        } else {
            Place::Middle
        };
        letter(&mut svg, busy, place);
    }
    let broken = breakdowns(subject);
    for &cell in &broken {
        let (x, y) = middle(cell);
        push(
            &mut svg,
            format_args!(
                "<path d=\"M{} {}l56 56m0-56-56 56\" fill=\"none\" stroke=\"#000\" stroke-width=\"14\"/>",
                x - 28,
                y - 28
            ),
        );
    }
    let (across, down) = (100 * grid.width(), 100 * grid.height());
    push(
        &mut svg,
        format_args!(
            "<rect width=\"{across}\" height=\"{down}\" fill=\"none\" stroke=\"#000\" stroke-width=\"10\"/></svg>"
        ),
    );
    let has_goals = robots.iter().any(|robot| robot.goal.is_some());
    let signs = [
        (Sign::Start, true),
        (Sign::Goal, has_goals),
        (Sign::Busy, !busiest.is_empty()),
        (Sign::Breakdown, !broken.is_empty()),
    ];
    let signs = signs.into_iter().chain(ground);
    (
        svg,
        signs.filter(|(_, is)| *is).map(|(sign, _)| sign).collect(),
    )
}

/// The empty sheet with the lines between cells and the numbers of columns and rows.
fn sheet(grid: &Grid) -> String {
    let (width, height) = (grid.width(), grid.height());
    let longest = width.max(height);
    let rim = (f64::from(longest) * CELL * RIM).max(70.0);
    let (across, down) = (100 * width, 100 * height);
    // The numbers of rows stand left of the map: all of their digits have room.
    let digits = f64::from(height.saturating_sub(1).max(1).ilog10() + 1);
    let left = rim * (0.42 * digits + 0.4).max(1.0);
    let wide = f64::from(across) + 0.1 * rim + left;
    let mut svg = String::new();
    push(
        &mut svg,
        format_args!(
            "<svg class=\"report-map\" width=\"{:.0}\" viewBox=\"{:.0} {:.0} {:.0} {:.0}\" role=\"img\" aria-label=\"{}\">",
            wide * CELL_PX / CELL,
            -left,
            -rim,
            wide,
            f64::from(down) + 1.1 * rim,
            Escaped(tr!("The floor: starts, goals, busiest cells"))
        ),
    );
    svg.push_str("<defs><pattern id=\"report-hatch\" width=\"34\" height=\"34\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path d=\"M17 0V34\" stroke=\"#777\" stroke-width=\"6\"/></pattern></defs>");
    push(
        &mut svg,
        format_args!("<rect width=\"{across}\" height=\"{down}\" fill=\"#fff\"/>"),
    );
    if longest <= LINED {
        let lines = lines(width, height, 1);
        push(
            &mut svg,
            format_args!("<path d=\"{lines}\" stroke=\"#ddd\" stroke-width=\"4\"/>"),
        );
    }
    numbers(&mut svg, (width, height), rim);
    svg
}

/// Slow cells, obstacles and chargers; which of them there are.
fn ground(svg: &mut String, grid: &Grid) -> [(Sign, bool); 3] {
    let all = |is: fn(Ground) -> bool| -> BTreeSet<Cell> {
        let cells = grid.cells().filter(|&(_, ground)| is(ground));
        cells.map(|(cell, _)| cell).collect()
    };
    let slow = all(Ground::is_slow);
    push(
        svg,
        format_args!(
            "<path d=\"{}\" fill=\"url(#report-hatch)\" stroke=\"#555\" stroke-width=\"6\"/>",
            around(&slow, 0)
        ),
    );
    let obstacles = all(|ground| ground == Ground::Obstacle);
    push(
        svg,
        format_args!("<path d=\"{}\" fill=\"#3a3a3a\"/>", around(&obstacles, 4)),
    );
    let chargers = all(Ground::is_charger);
    for &cell in &chargers {
        let (x, y) = middle(cell);
        push(
            svg,
            format_args!(
                "<g transform=\"translate({x} {y})\"><rect x=\"-42\" y=\"-42\" width=\"84\" height=\"84\" rx=\"14\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"7\"/><path d=\"M6-32-20 6H0L-6 32 20-8H0Z\"/></g>"
            ),
        );
    }
    [
        (Sign::Obstacle, !obstacles.is_empty()),
        (Sign::Slow, !slow.is_empty()),
        (Sign::Charger, !chargers.is_empty()),
    ]
}

/// Every fifth number of columns and rows; of large maps fewer.
fn numbers(svg: &mut String, (width, height): (u32, u32), rim: f64) {
    let longest = width.max(height);
    let every = match longest {
        0..12 => 1,
        12..100 => 5,
        100..400 => 20,
        _ => 100,
    };
    let size = rim * 0.62;
    let mut number = |n: u32, x: f64, y: f64, anchor: &str| {
        push(
            svg,
            format_args!(
                "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\" font-size=\"{size:.0}\" fill=\"#444\">{n}</text>"
            ),
        );
    };
    let at = |index: u32| f64::from(index) * CELL + CELL / 2.0;
    for x in (0..width).step_by(every) {
        number(x, at(x), -rim * 0.28, "middle");
    }
    for y in (0..height).step_by(every) {
        number(y, -rim * 0.28, at(y) + size * 0.36, "end");
    }
}

/// Where the letter of a busy cell stands.
#[derive(Clone, Copy)]
enum Place {
    /// In the middle.
    Middle,
    /// On the right of a charger's bolt.
    Right,
    /// In the corner, beside a start or a goal.
    Corner,
}

/// The letter of a busy cell.
fn letter(svg: &mut String, busy: &BusyCell, place: Place) {
    let Cell { x, y } = busy.cell;
    push(
        svg,
        format_args!(
            "<rect x=\"{}\" y=\"{}\" width=\"88\" height=\"88\" fill=\"none\" stroke=\"#000\" stroke-width=\"6\" stroke-dasharray=\"16 10\"/>",
            100 * x + 6,
            100 * y + 6
        ),
    );
    let ((right, down), size) = match place {
        Place::Middle => ((50, 70), 60),
        Place::Right => ((64, 80), 56),
        Place::Corner => ((24, 34), 40),
    };
    let at = (100 * x + right, 100 * y + down);
    push(
        svg,
        format_args!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{size}\" font-weight=\"700\" fill=\"#000\" stroke=\"#fff\" stroke-width=\"12\" paint-order=\"stroke\">{}</text>",
            at.0, at.1, busy.letter
        ),
    );
}

/// Whether a start or a goal is on a cell.
fn is_taken(cell: Cell, robots: &[RobotRow]) -> bool {
    let mut robots = robots.iter();
    robots.any(|robot| robot.start == cell || robot.goal == Some(cell))
}

/// Where robots break down.
fn breakdowns(subject: &Subject<'_>) -> BTreeSet<Cell> {
    let robots = subject.robots.iter();
    let cells = robots.flat_map(|robot| {
        let way = subject.way(robot);
        let at = move |&(from, _): &(u32, u32)| {
            let before = way.iter().rev().find(|&&(time, _)| time <= from);
            before.map(|&(_, cell)| cell)
        };
        robot.held.iter().filter_map(at).collect::<Vec<_>>()
    });
    cells.collect()
}

/// The middle of a cell, in units.
pub(super) const fn middle(cell: Cell) -> (u32, u32) {
    (100 * cell.x + 50, 100 * cell.y + 50)
}

pub(super) fn push(svg: &mut String, text: Arguments<'_>) {
    // A string takes everything.
    let _ = svg.write_fmt(text);
}
