//! Words in a picture, as text or as lines.

use std::fmt::Write as _;

use crate::ink::Ink;
use crate::letters::{Anchor, scale, strokes, thickness};
use crate::look::Letters;
use crate::xml::{Escaped, Number};

/// The fonts of the page, the system's own.
const FONT: &str = "system-ui,-apple-system,Segoe UI,Roboto,Noto Sans,Helvetica Neue,sans-serif";

/// A word to be drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Label<'a> {
    pub(super) word: &'a str,
    pub(super) at: (f64, f64),
    /// The size of the font, in units.
    pub(super) size: f64,
    pub(super) anchor: Anchor,
    pub(super) ink: Ink,
    pub(super) is_strong: bool,
    /// The colour around it, where it stands on other things, and how far that goes.
    pub(super) halo: Option<(Ink, f64)>,
    /// What moves it.
    pub(super) class: &'a str,
}

impl Label<'_> {
    pub(super) fn draw(&self, letters: Letters, svg: &mut String) {
        // Writing to a string cannot fail.
        let _ = match letters {
            Letters::Text => self.text(svg),
            Letters::Strokes => self.strokes(svg),
        };
    }

    /// The numbers from this one, 0, up to another one, each so far below the one before.
    pub(super) fn column(&self, letters: Letters, last: u32, apart: f64, svg: &mut String) {
        let (x, y) = self.at;
        if letters == Letters::Text {
            let mut lines = String::new();
            for number in 0..=last {
                let y = Number(y + apart * f64::from(number));
                // Writing to a string cannot fail.
                let _ = write!(
                    lines,
                    "<tspan x=\"{}\" y=\"{y}\">{number}</tspan>",
                    Number(x)
                );
            }
            let _ = self.text_of(svg, &lines);
            return;
        }
        for number in 0..=last {
            let word = number.to_string();
            let at = (x, y + apart * f64::from(number));
            let label = Label {
                word: &word,
                at,
                ..*self
            };
            label.draw(letters, svg);
        }
    }

    fn text(&self, svg: &mut String) -> std::fmt::Result {
        self.text_of(svg, &Escaped(self.word).to_string())
    }

    /// A text with something in it that is XML already.
    fn text_of(&self, svg: &mut String, inner: &str) -> std::fmt::Result {
        let (x, y) = self.at;
        write!(
            svg,
            "<text{} x=\"{}\" y=\"{}\" font-family=\"{FONT}\" font-size=\"{}\" font-weight=\"{}\" text-anchor=\"{}\" fill=\"{}\"",
            self.class,
            Number(x),
            Number(y),
            Number(self.size),
            if self.is_strong { 700 } else { 500 },
            self.anchor.name(),
            self.ink,
        )?;
        if let Some((ink, width)) = self.halo {
            let width = Number(width);
            write!(
                svg,
                " stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linejoin=\"round\" paint-order=\"stroke\""
            )?;
        }
        write!(svg, ">{inner}</text>")
    }

    fn strokes(&self, svg: &mut String) -> std::fmt::Result {
        let shapes = strokes(self.word, self.at, self.size, self.anchor);
        let width = thickness(self.is_strong);
        write!(
            svg,
            "<g{} fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">",
            self.class
        )?;
        if let Some((ink, halo)) = self.halo {
            let width = Number(width + halo / scale(self.size));
            write!(
                svg,
                "<g stroke=\"{ink}\" stroke-width=\"{width}\">{shapes}</g>"
            )?;
        }
        let (ink, width) = (self.ink, Number(width));
        write!(
            svg,
            "<g stroke=\"{ink}\" stroke-width=\"{width}\">{shapes}</g></g>"
        )
    }
}
