//! Letters and figures as lines, for pictures that must look the same everywhere.

use std::fmt::Write as _;

use crate::glyphs::GLYPHS;
use crate::xml::Number;

/// How high a capital letter is in the units of the table below, and what part of the
/// size of a font that is.
const CAPITAL: (f64, f64) = (7.0, 0.72);
/// The room between two letters, in the same units, and the width of a blank.
const GAP: f64 = 1.7;
const BLANK: f64 = 1.8;

/// How a word stands at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

impl Anchor {
    /// What SVG calls it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }

    /// The part of a word that is left of its place.
    const fn share(self) -> f64 {
        match self {
            Self::Start => 0.0,
            Self::Middle => 0.5,
            Self::End => 1.0,
        }
    }
}

/// Whether a letter is in the table.
pub(crate) fn is_drawn(letter: char) -> bool {
    GLYPHS.iter().any(|(name, ..)| *name == letter)
}

/// A word in lines: shapes to be stroked, in the size of a font, at a place. Letters
/// that are not in the table are left out.
pub(crate) fn strokes(word: &str, (x, y): (f64, f64), size: f64, anchor: Anchor) -> String {
    let glyph = |letter: char| GLYPHS.iter().find(|(name, ..)| *name == letter);
    let advance = |letter: char| match letter {
        ' ' => BLANK + GAP,
        letter => glyph(letter).map_or(0.0, |(_, width, _)| width + GAP),
    };
    let width: f64 = word.chars().map(advance).sum::<f64>() - GAP;
    let scale = size * CAPITAL.1 / CAPITAL.0;
    let mut at = x - anchor.share() * width.max(0.0) * scale;
    let mut shapes = String::new();
    for letter in word.chars() {
        if let Some((.., d)) = glyph(letter) {
            // Writing to a string cannot fail.
            let _ = write!(
                shapes,
                "<path transform=\"translate({} {}) scale({})\" d=\"{d}\"/>",
                Number(at),
                Number(y),
                Scale(scale),
            );
        }
        at += advance(letter) * scale;
    }
    shapes
}

/// How thick strokes of a size of font are, in units of the table: `strong` for names.
pub(crate) const fn thickness(strong: bool) -> f64 {
    if strong { 1.35 } else { 1.0 }
}

/// How large a stroke of the table is drawn at a size of font.
pub(crate) fn scale(size: f64) -> f64 {
    size * CAPITAL.1 / CAPITAL.0
}

/// A factor, finer than other numbers.
struct Scale(f64);

impl std::fmt::Display for Scale {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.4}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_placed_by_their_anchor() {
        let first = |anchor| {
            let word = strokes("HH", (100.0, 0.0), 70.0, anchor);
            let number = word
                .split("translate(")
                .nth(1)
                .and_then(|it| it.split(' ').next());
            number.and_then(|it| it.parse::<f64>().ok()).unwrap()
        };
        let [start, middle, end] = [Anchor::Start, Anchor::Middle, Anchor::End].map(first);
        assert!((start - 100.0).abs() < 0.01);
        // Two letters and a gap, 7.2 units each.
        let width = (4.2 + 1.7 + 4.2) * 7.2;
        assert!((middle - (100.0 - width / 2.0)).abs() < 0.01, "{middle}");
        assert!((end - (100.0 - width)).abs() < 0.01, "{end}");
    }

    #[test]
    fn every_letter_stands_once_and_others_are_left_out() {
        let mut letters: Vec<char> = GLYPHS.iter().map(|(letter, ..)| *letter).collect();
        letters.sort_unstable();
        assert!(letters.windows(2).all(|pair| pair[0] != pair[1]));
        for letter in ('a'..='z').chain('A'..='Z').chain('0'..='9') {
            assert!(letters.contains(&letter), "{letter}");
        }
        let shapes = |word| strokes(word, (0.0, 0.0), 10.0, Anchor::Middle);
        assert_eq!(shapes("漢字"), "");
        assert_eq!(shapes("A漢1"), shapes("A1"));
    }
}
