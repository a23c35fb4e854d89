//! How a planner looks in table and plots: a dash and a mark, black on white.

use std::fmt::Write as _;

use super::scale::number;

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Circle,
    Square,
    Triangle,
    Diamond,
}

/// A dash and a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Look {
    dash: &'static str,
    shape: Shape,
    is_filled: bool,
}

const fn look(dash: &'static str, shape: Shape, is_filled: bool) -> Look {
    Look {
        dash,
        shape,
        is_filled,
    }
}

/// The looks, in the order of planners.
const LOOKS: [Look; 12] = [
    look("", Shape::Circle, true),
    look("9 4", Shape::Square, true),
    look("2 4", Shape::Triangle, true),
    look("", Shape::Circle, false),
    look("12 4 2 4", Shape::Square, false),
    look("5 3", Shape::Triangle, false),
    look("9 4", Shape::Diamond, true),
    look("2 4", Shape::Diamond, false),
    look("12 4 2 4", Shape::Circle, true),
    look("5 3", Shape::Square, true),
    look("", Shape::Triangle, true),
    look("9 4", Shape::Circle, false),
];

/// The look of a planner by its number; after twelve they begin again.
pub(super) fn look_of(index: usize) -> Look {
    LOOKS[index % LOOKS.len()]
}

/// The width of lines; that of the reference is wider.
pub(super) const fn width(is_reference: bool) -> f64 {
    if is_reference { 2.8 } else { 1.6 }
}

impl Look {
    /// A curve through points.
    pub(super) fn path(self, svg: &mut String, points: &[(f64, f64)], width: f64) {
        let mut path = String::new();
        for (index, (x, y)) in points.iter().enumerate() {
            let letter = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{letter}{} {}", number(*x), number(*y));
        }
        let dash = match self.dash {
            "" => String::new(),
            dash => format!(" stroke-dasharray=\"{dash}\""),
        };
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"#111\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dash}/>"
        );
    }

    /// Its mark, with a size of half its width.
    pub(super) fn mark(self, svg: &mut String, (x, y): (f64, f64), size: f64) {
        let fill = if self.is_filled { "#111" } else { "#fff" };
        let style = format!(
            "fill=\"{fill}\" stroke=\"#111\" stroke-width=\"1.5\" stroke-linejoin=\"round\""
        );
        let [left, right, up, down] = [x - size, x + size, y - size, y + size].map(number);
        let (cx, cy) = (number(x), number(y));
        let _ = match self.shape {
            Shape::Circle => writeln!(
                svg,
                "<circle cx=\"{cx}\" cy=\"{cy}\" r=\"{size}\" {style}/>"
            ),
            Shape::Square => {
                let side = 2.0 * size;
                writeln!(
                    svg,
                    "<rect x=\"{left}\" y=\"{up}\" width=\"{side}\" height=\"{side}\" {style}/>"
                )
            }
            Shape::Triangle => {
                let (top, left, right) = (
                    number(y - 1.25 * size),
                    number(x - 1.15 * size),
                    number(x + 1.15 * size),
                );
                let foot = number(y + 0.8 * size);
                writeln!(
                    svg,
                    "<path d=\"M{cx} {top}L{right} {foot}H{left}Z\" {style}/>"
                )
            }
            Shape::Diamond => {
                writeln!(
                    svg,
                    "<path d=\"M{cx} {up}L{right} {cy}L{cx} {down}L{left} {cy}Z\" {style}/>"
                )
            }
        };
    }

    /// A piece of its curve with its mark, for a table.
    pub(super) fn piece(self, is_reference: bool) -> String {
        let mut svg =
            "<svg class=\"mk\" viewBox=\"-8 -8 48 16\" aria-hidden=\"true\">\n".to_owned();
        self.path(&mut svg, &[(-6.0, 0.0), (38.0, 0.0)], width(is_reference));
        self.mark(&mut svg, (16.0, 0.0), 4.4);
        svg + "</svg>"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twelve_planners_look_different() {
        for index in 1..LOOKS.len() {
            assert!(
                (0..index).all(|other| look_of(other) != look_of(index)),
                "{index}"
            );
        }
    }
}
