//! Letters, a step each: `F,R,F,W`.

use crate::format::foreign::{Action, Move};
use crate::tr;

/// A character of a text that is none of those that may stand there.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Unknown {
    /// Its byte.
    pub(super) offset: usize,
    pub(super) expected: String,
}

/// What a letter of the action model `MAPF_T` means.
pub(super) const fn turning(letter: u8) -> Option<Action> {
    match letter {
        b'F' => Some(Action::Forward),
        b'R' => Some(Action::Clockwise),
        b'C' => Some(Action::Counterclockwise),
        b'W' | b'T' => Some(Action::Wait),
        _ => None,
    }
}

/// What a letter of the action model `MAPF` means.
pub(super) const fn plain(letter: u8) -> Option<Move> {
    match letter {
        b'U' => Some(Move::Up),
        b'D' => Some(Move::Down),
        b'L' => Some(Move::Left),
        b'R' => Some(Move::Right),
        b'W' | b'T' => Some(Move::Wait),
        _ => None,
    }
}

/// How many steps a text can have at most.
pub(super) const fn most(text: &str) -> usize {
    text.len().div_ceil(2)
}

/// Reads letters with commas between them; one more comma may end the text.
pub(super) fn letters<T>(
    text: &str,
    meaning: impl Fn(u8) -> Option<T>,
    known: &str,
) -> Result<Vec<T>, Unknown> {
    let mut steps = Vec::with_capacity(most(text));
    for (offset, byte) in text.bytes().enumerate() {
        if offset % 2 == 0 {
            let step = meaning(byte).ok_or_else(|| Unknown {
                offset,
                expected: tr!("one of {known}", known),
            })?;
            steps.push(step);
        } else if byte != b',' {
            return Err(Unknown {
                offset,
                expected: tr!("a comma").to_owned(),
            });
        }
    }
    Ok(steps)
}
