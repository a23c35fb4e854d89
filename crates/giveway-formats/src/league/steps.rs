//! Letters, a step each: `F,R,F,W`.

use crate::limits::Steps;
use crate::{Action, Move};
use giveway_model::format::text::shorten;
use giveway_model::{Fault, tr};

/// A fault at a byte of a text, which is its place.
pub(super) fn unexpected(text: &str, offset: usize, expected: impl Into<String>) -> Fault {
    let next = text.get(offset..).and_then(|rest| rest.chars().next());
    let found = next.map_or_else(
        || tr!("the end of the path").to_owned(),
        |c| format!("\"{}\"", shorten(&c.to_string())),
    );
    Fault::at(format!("[{offset}]"), found, expected)
}

/// The meaning of a letter of the action model `MAPF_T`.
pub(super) const fn turning(letter: u8) -> Option<Action> {
    match letter {
        b'F' => Some(Action::Forward),
        b'R' => Some(Action::Clockwise),
        b'C' => Some(Action::Counterclockwise),
        b'W' | b'T' => Some(Action::Wait),
        _ => None,
    }
}

/// The meaning of a letter of the action model `MAPF`.
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

/// Reads letters with commas between them; one more comma may end the text.
pub(super) fn letters<T>(
    text: &str,
    (meaning, known): (fn(u8) -> Option<T>, &str),
    steps: &mut Steps,
) -> Result<Vec<T>, Fault> {
    steps.add(text.len().div_ceil(2))?;
    let mut read = Vec::with_capacity(text.len().div_ceil(2));
    for (offset, byte) in text.bytes().enumerate() {
        if offset % 2 == 0 {
            let step = meaning(byte);
            let expected = || tr!("one of {known}", known);
            read.push(step.ok_or_else(|| unexpected(text, offset, expected()))?);
        } else if byte != b',' {
            return Err(unexpected(text, offset, tr!("a comma")));
        }
    }
    Ok(read)
}
