//! Letters and figures as lines, for pictures that must look the same everywhere.

use std::fmt::Write as _;

use crate::xml::Number;

/// How high a capital letter is in the units of the table below, and what part of the
/// size of a font that is.
const CAPITAL: (f64, f64) = (7.0, 0.72);
/// The room between two letters, in the same units, and the width of a blank.
const GAP: f64 = 1.7;
const BLANK: f64 = 1.8;

/// Each letter: how wide it is, and the `d` of its lines. The baseline is at 0, capital
/// letters reach up to -7, small ones to -4.9.
const GLYPHS: &[(char, f64, &str)] = &[
    ('0', 4.0, "M2-7Q0-7 0-3.5Q0 0 2 0Q4 0 4-3.5Q4-7 2-7Z"),
    ('1', 2.2, "M.4-5.6L2-7V0"),
    (
        '2',
        4.0,
        "M.2-5.4Q.4-7 2-7Q3.8-7 3.8-5.2Q3.8-4 2.4-2.6L0 0H4",
    ),
    (
        '3',
        4.0,
        "M.2-6Q.8-7 2-7Q3.7-7 3.7-5.4Q3.7-3.8 1.7-3.8Q4-3.8 4-2Q4 0 2 0Q.6 0 0-1.2",
    ),
    ('4', 4.0, "M3 0V-7L0-2.2H4"),
    (
        '5',
        4.0,
        "M3.6-7H.6L.3-4Q1-4.6 2-4.6Q4-4.6 4-2.3Q4 0 2 0Q.6 0 0-1.1",
    ),
    (
        '6',
        4.0,
        "M3.4-7Q0-5.6 0-2.2Q0 0 2 0Q4 0 4-2.2Q4-4.3 2-4.3Q.4-4.3 0-2.4",
    ),
    ('7', 4.0, "M0-7H4L1.4 0"),
    (
        '8',
        4.0,
        "M2-3.8Q.3-4 .3-5.4Q.3-7 2-7Q3.7-7 3.7-5.4Q3.7-4 2-3.8Q0-3.6 0-1.9Q0 0 2 0Q4 0 4-1.9Q4-3.6 2-3.8Z",
    ),
    (
        '9',
        4.0,
        "M.6 0Q4-1.4 4-4.8Q4-7 2-7Q0-7 0-4.8Q0-2.7 2-2.7Q3.6-2.7 4-4.6",
    ),
    ('A', 4.4, "M0 0L2.2-7L4.4 0M.8-2.4H3.6"),
    (
        'B',
        4.0,
        "M0-3.7H2.2Q4-3.7 4-1.9Q4 0 2.2 0H0V-7H2Q3.6-7 3.6-5.4Q3.6-3.7 2-3.7",
    ),
    (
        'C',
        4.2,
        "M4.2-1.4Q3.6 0 2.2 0Q0 0 0-3.5Q0-7 2.2-7Q3.6-7 4.2-5.6",
    ),
    ('D', 4.2, "M0 0V-7H1.6Q4.2-7 4.2-3.5Q4.2 0 1.6 0Z"),
    ('E', 3.6, "M3.6-7H0V0H3.6M0-3.7H3"),
    ('F', 3.6, "M3.6-7H0V0M0-3.6H3"),
    (
        'G',
        4.2,
        "M4.2-5.6Q3.6-7 2.2-7Q0-7 0-3.5Q0 0 2.2 0Q4.2 0 4.2-2.6V-3.2H2.4",
    ),
    ('H', 4.2, "M0 0V-7M4.2 0V-7M0-3.6H4.2"),
    ('I', 0.8, "M.4 0V-7"),
    ('J', 2.8, "M2.8-7V-2Q2.8 0 1.3 0Q.2 0 0-1.4"),
    ('K', 4.2, "M0 0V-7M4-7L0-2.8M1.4-4.1L4.2 0"),
    ('L', 3.4, "M0-7V0H3.4"),
    ('M', 5.0, "M0 0V-7L2.5-2L5-7V0"),
    ('N', 4.2, "M0 0V-7L4.2 0V-7"),
    (
        'O',
        4.6,
        "M2.3-7Q0-7 0-3.5Q0 0 2.3 0Q4.6 0 4.6-3.5Q4.6-7 2.3-7Z",
    ),
    ('P', 4.0, "M0 0V-7H2.1Q4-7 4-5.1Q4-3.2 2.1-3.2H0"),
    (
        'Q',
        4.6,
        "M2.3-7Q0-7 0-3.5Q0 0 2.3 0Q4.6 0 4.6-3.5Q4.6-7 2.3-7ZM2.8-1.8L4.6 .6",
    ),
    (
        'R',
        4.2,
        "M0 0V-7H2.1Q4-7 4-5.1Q4-3.2 2.1-3.2H0M2.1-3.2L4.2 0",
    ),
    (
        'S',
        4.0,
        "M3.8-5.7Q3.4-7 2-7Q.2-7 .2-5.3Q.2-4.1 2-3.6Q4-3.1 4-1.8Q4 0 2 0Q.4 0 0-1.4",
    ),
    ('T', 4.4, "M0-7H4.4M2.2-7V0"),
    ('U', 4.2, "M0-7V-2.4Q0 0 2.1 0Q4.2 0 4.2-2.4V-7"),
    ('V', 4.4, "M0-7L2.2 0L4.4-7"),
    ('W', 6.0, "M0-7L1.5 0L3-5.6L4.5 0L6-7"),
    ('X', 4.2, "M0 0L4.2-7M0-7L4.2 0"),
    ('Y', 4.4, "M0-7L2.2-3.4L4.4-7M2.2-3.4V0"),
    ('Z', 4.2, "M.2-7H4L0 0H4.2"),
    (
        'a',
        3.6,
        "M.4-4.3Q1-4.9 1.9-4.9Q3.6-4.9 3.6-3.1V0M3.6-2.9H1.9Q0-2.9 0-1.4Q0 0 1.6 0Q3.6 0 3.6-2",
    ),
    (
        'b',
        3.8,
        "M0-7V0M0-2.45Q0-4.9 1.9-4.9Q3.8-4.9 3.8-2.45Q3.8 0 1.9 0Q0 0 0-2.45",
    ),
    (
        'c',
        3.5,
        "M3.5-3.9Q3-4.9 1.9-4.9Q0-4.9 0-2.45Q0 0 1.9 0Q3 0 3.5-1",
    ),
    (
        'd',
        3.8,
        "M3.8-7V0M3.8-2.45Q3.8-4.9 1.9-4.9Q0-4.9 0-2.45Q0 0 1.9 0Q3.8 0 3.8-2.45",
    ),
    (
        'e',
        3.7,
        "M0-2.6H3.7Q3.7-4.9 1.9-4.9Q0-4.9 0-2.45Q0 0 2 0Q3 0 3.5-.9",
    ),
    ('f', 2.8, "M2.8-6.9Q1.2-7.3 1.2-5.4V0M0-4.8H2.5"),
    (
        'g',
        3.8,
        "M3.8-2.45Q3.8-4.9 1.9-4.9Q0-4.9 0-2.45Q0 0 1.9 0Q3.8 0 3.8-2.45M3.8-4.9V.4Q3.8 2 1.9 2Q.8 2 .2 1.4",
    ),
    ('h', 3.5, "M0-7V0M0-2.8Q0-4.9 1.8-4.9Q3.5-4.9 3.5-2.9V0"),
    ('i', 0.8, "M.4-4.9V0M.4-6.8V-6.7"),
    ('j', 1.2, "M1.2-4.9V.7Q1.2 2 0 1.9M1.2-6.8V-6.7"),
    ('k', 3.5, "M0-7V0M3.3-4.9L0-1.9M1.2-3L3.5 0"),
    ('l', 0.8, "M.4-7V0"),
    (
        'm',
        5.6,
        "M0-4.9V0M0-3Q0-4.9 1.4-4.9Q2.8-4.9 2.8-3V0M2.8-3Q2.8-4.9 4.2-4.9Q5.6-4.9 5.6-3V0",
    ),
    ('n', 3.5, "M0-4.9V0M0-2.8Q0-4.9 1.8-4.9Q3.5-4.9 3.5-2.9V0"),
    (
        'o',
        3.8,
        "M1.9-4.9Q0-4.9 0-2.45Q0 0 1.9 0Q3.8 0 3.8-2.45Q3.8-4.9 1.9-4.9Z",
    ),
    (
        'p',
        3.8,
        "M0-4.9V2M0-2.45Q0-4.9 1.9-4.9Q3.8-4.9 3.8-2.45Q3.8 0 1.9 0Q0 0 0-2.45",
    ),
    (
        'q',
        3.8,
        "M3.8-4.9V2M3.8-2.45Q3.8-4.9 1.9-4.9Q0-4.9 0-2.45Q0 0 1.9 0Q3.8 0 3.8-2.45",
    ),
    ('r', 2.4, "M0-4.9V0M0-2.8Q.2-4.9 2.3-4.8"),
    (
        's',
        3.3,
        "M3.1-4.1Q2.7-4.9 1.7-4.9Q.2-4.9 .2-3.7Q.2-2.7 1.7-2.5Q3.3-2.2 3.3-1.2Q3.3 0 1.7 0Q.4 0 0-.9",
    ),
    ('t', 2.6, "M1.2-6.4V-1.4Q1.2 0 2.6-.1M0-4.8H2.5"),
    ('u', 3.5, "M0-4.9V-2.1Q0 0 1.7 0Q3.5 0 3.5-2.1M3.5-4.9V0"),
    ('v', 3.6, "M0-4.9L1.8 0L3.6-4.9"),
    ('w', 5.0, "M0-4.9L1.3 0L2.5-4L3.7 0L5-4.9"),
    ('x', 3.4, "M0-4.9L3.4 0M3.4-4.9L0 0"),
    ('y', 3.6, "M0-4.9L1.8 0M3.6-4.9L1.6 .9Q1.2 2 .1 1.9"),
    ('z', 3.4, "M.1-4.9H3.3L0 0H3.4"),
    ('-', 2.8, "M.2-2.6H2.6"),
    ('_', 3.6, "M0 .8H3.6"),
    ('.', 0.8, "M.4-.2V-.1"),
    (',', 0.8, "M.5-.2L.2 1"),
    (':', 0.8, "M.4-.2V-.1M.4-4V-3.9"),
    ('+', 3.6, "M.1-3H3.5M1.8-4.7V-1.3"),
    ('/', 2.8, "M0 .6L2.8-7.4"),
    ('(', 1.5, "M1.5-7.6Q-1-3.2 1.5 1.2"),
    (')', 1.5, "M0-7.6Q2.5-3.2 0 1.2"),
    (
        '#',
        4.4,
        "M1.2-6.4L.8-.4M3.6-6.4L3.2-.4M0-4.6H4.4M0-2.2H4.4",
    ),
    ('=', 3.6, "M.1-4H3.5M.1-2H3.5"),
];

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
