//! The numbers of columns and rows, in the margin of a picture for paper.

use super::label::Label;
use super::stage::Stage;
use crate::CELL;
use crate::letters::Anchor;

/// The size of the numbers, in pixels, and how far they are from the map.
const FONT: f64 = 8.0;
const GAP: f64 = 3.0;
/// Where cells are smaller, only every fifth number stands there, in pixels.
const LEAST_CELL: f64 = 16.0;

impl Stage {
    /// The numbers beside the map.
    pub(crate) fn numbers(&self) -> String {
        let mut svg = String::new();
        let px = self.sheet.px;
        let every = if CELL / px < LEAST_CELL { 5 } else { 1 };
        let mut number = |index: u32, at: (f64, f64), anchor: Anchor| {
            let word = index.to_string();
            let label = Label {
                word: &word,
                at,
                size: FONT * px,
                anchor,
                ink: self.inks.soft,
                is_strong: false,
                halo: None,
                class: "",
            };
            label.draw(self.look.letters, &mut svg);
        };
        let middle = |index: u32| (f64::from(index) + 0.5) * CELL;
        for column in (0..self.instance.grid().width()).step_by(every) {
            number(column, (middle(column), -GAP * px), Anchor::Middle);
        }
        for row in (0..self.instance.grid().height()).step_by(every) {
            let y = middle(row) + 0.36 * FONT * px;
            number(row, (-GAP * px, y), Anchor::End);
        }
        svg
    }
}
