//! Starts and goals on the map, each readable where they share a cell.

use std::collections::BTreeMap;

use giveway_model::Cell;

use super::RobotRow;
use super::map::{middle, push};
use crate::xml::Escaped;

/// The sizes of letters in a cell, in units, by how many there are: of one or two, and of three.
const TEXT: [u32; 2] = [56, 42];
/// The same where the cell is shared by two.
const TEXT_OF_TWO: [u32; 2] = [40, 28];
/// And by more.
const TEXT_OF_MORE: [u32; 2] = [30, 22];

/// What stands on a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark<'a> {
    /// A robot starts, by its number.
    Start(&'a str),
    /// Its goal.
    Goal(&'a str),
}

/// Draws all starts and goals.
pub(super) fn marks(svg: &mut String, robots: &[RobotRow]) {
    let mut cells: BTreeMap<(u32, u32), Vec<Mark<'_>>> = BTreeMap::new();
    for robot in robots {
        if let Some(goal) = robot.goal {
            let marks = cells.entry((goal.y, goal.x)).or_default();
            marks.push(Mark::Goal(&robot.number));
        }
    }
    for robot in robots {
        let marks = cells.entry((robot.start.y, robot.start.x)).or_default();
        marks.push(Mark::Start(&robot.number));
    }
    for ((y, x), marks) in cells {
        let middle = middle(Cell::new(x, y));
        // The corner at the left above is left to the letter of a busy cell.
        let (corners, half, text): (&[(i32, i32)], u32, [u32; 2]) = match marks.len() {
            0 | 1 => (&[(0, 0)], 42, TEXT),
            2 => (&[(-20, 20), (18, -18)], 28, TEXT_OF_TWO),
            _ => (
                &[(-24, 24), (24, -24), (24, 24), (-24, -24)],
                22,
                TEXT_OF_MORE,
            ),
        };
        for (mark, &(right, down)) in marks.into_iter().zip(corners) {
            let at = (
                middle.0.saturating_add_signed(right),
                middle.1.saturating_add_signed(down),
            );
            draw(svg, mark, at, half, text);
        }
    }
}

fn draw(svg: &mut String, mark: Mark<'_>, (x, y): (u32, u32), half: u32, text: [u32; 2]) {
    let (number, ink) = match mark {
        Mark::Start(number) => {
            push(
                svg,
                format_args!(
                    "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" stroke=\"#fff\" stroke-width=\"4\"/>",
                    half + 4
                ),
            );
            (number, "#fff")
        }
        Mark::Goal(number) => {
            push(
                svg,
                format_args!(
                    "<rect x=\"{}\" y=\"{}\" width=\"{side}\" height=\"{side}\" rx=\"8\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"{}\"/>",
                    i64::from(x) - i64::from(half),
                    i64::from(y) - i64::from(half),
                    half / 6,
                    side = 2 * half,
                ),
            );
            (number, "#000")
        }
    };
    let size = text[usize::from(number.chars().count() > 2)];
    push(
        svg,
        format_args!(
            "<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{size}\" font-weight=\"700\" fill=\"{ink}\">{}</text>",
            y + size * 36 / 100,
            Escaped(number)
        ),
    );
}
