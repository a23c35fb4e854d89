//! Rows of a grid, a mark a cell: `.` free, `@` and `#` obstacles, or `0` free, `1` an
//! obstacle, with or without blanks between them; `~`, `+` and `*` as in this project's maps.

use crate::lines::Line;
use giveway_model::MAX_SIDE;
use giveway_model::{Fault, tr, tr_later};

/// A mark of a row, and the part of the line that it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark<'a> {
    pub(super) letter: char,
    pub(super) part: &'a str,
}

impl Mark<'_> {
    /// Whether it says what the ground is, and is no letter for a robot.
    pub(super) const fn is_ground(self) -> bool {
        matches!(self.letter, '.' | '@' | '#' | '0' | '1') || self.is_own()
    }

    /// Whether it is a ground that only this project has.
    pub(super) const fn is_own(self) -> bool {
        matches!(self.letter, '~' | '+' | '*')
    }
}

/// The marks of a line; `None` where it is no row: it is empty, holds other
/// characters than marks and letters, or has words of several letters.
pub(super) fn row(text: &str) -> Option<Vec<Mark<'_>>> {
    let is_gap = |c: char| matches!(c, ' ' | '\t' | ',' | ';');
    let mut words = text.split(is_gap).filter(|word| !word.is_empty());
    let (first, second) = (words.next()?, words.next());
    let is_spaced = second.is_some();
    if is_spaced
        && (first.len() > 1
            || second.is_some_and(|it| it.len() > 1)
            || words.any(|it| it.len() > 1))
    {
        return None;
    }
    let letters = text.char_indices().filter(|&(_, c)| !is_gap(c));
    let marks = letters.map(|(at, letter)| {
        let part = text.get(at..at + letter.len_utf8())?;
        let mark = Mark { letter, part };
        (mark.is_ground() || letter.is_ascii_alphabetic()).then_some(mark)
    });
    marks.collect()
}

/// The two ways of writing free and obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Signs {
    Points,
    Digits,
}

/// Rows that are read one after the other.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// In the project's own characters; the cells of letters are free.
    pub(super) rows: Vec<String>,
    pub(super) signs: Option<Signs>,
}

impl Rows {
    /// Adds a row.
    ///
    /// # Errors
    /// When it has another width than `width` or is too long, or when digits and
    /// points stand in one grid.
    pub(super) fn push(
        &mut self,
        line: Line<'_>,
        marks: &[Mark<'_>],
        width: (usize, impl FnOnce() -> String),
    ) -> Result<(), Fault> {
        if marks.len() != width.0 {
            let part = marks
                .get(width.0)
                .map_or_else(|| line.end(), |mark| mark.part);
            let found = tr!("a row of {n} cells", n = marks.len());
            return Err(line.fault_saying(part, found, (width.1)()));
        }
        let most = MAX_SIDE as usize;
        if marks.len() > most || self.rows.len() >= most {
            let expected = tr!("at most {most} rows and columns", most);
            return Err(line.fault_saying(line.text, tr_later!("a larger map"), expected));
        }
        let mut row = String::with_capacity(marks.len());
        for mark in marks {
            let signs = match mark.letter {
                '0' | '1' => Some(Signs::Digits),
                '.' | '@' | '#' | '~' | '+' | '*' => Some(Signs::Points),
                _ => None,
            };
            if signs.is_some() && self.signs.is_some() && signs != self.signs {
                let expected = tr_later!("0 and 1 in every row, or . and @ (or #), not both");
                return Err(line.fault(mark.part, expected));
            }
            self.signs = self.signs.or(signs);
            row.push(match mark.letter {
                '@' | '#' | '1' => '#',
                own if mark.is_own() => own,
                _ => '.',
            });
        }
        self.rows.push(row);
        Ok(())
    }
}
