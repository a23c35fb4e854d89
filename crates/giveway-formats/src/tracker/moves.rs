//! A path as letters with run lengths before them.

use crate::Move;
use crate::limits::Steps;
use giveway_model::{Fault, tr};

/// Reads a path.
///
/// # Errors
/// The byte that is wrong, with a fault that has no place yet: a letter that is no
/// move, a run length without a letter, or more steps than are read.
pub(super) fn read(path: &str, steps: &mut Steps) -> Result<Vec<Move>, (usize, Fault)> {
    let mut moves = Vec::with_capacity(path.len());
    let mut run: Option<(usize, u32)> = None;
    for (at, byte) in path.bytes().enumerate() {
        let step = match byte {
            b'u' => Move::Up,
            b'd' => Move::Down,
            b'l' => Move::Left,
            b'r' => Move::Right,
            b'w' => Move::Wait,
            b'0'..=b'9' => {
                let (from, before) = run.unwrap_or((at, 0));
                run = Some((from, longer(before, byte).ok_or_else(|| long(from))?));
                continue;
            }
            _ => return Err((at, letter(path, at))),
        };
        match run.take() {
            None => {
                steps.add(1).map_err(|fault| (at, fault))?;
                moves.push(step);
            }
            Some((from, 0)) => {
                let fault = Fault::at("", tr!("a run of 0 steps"), tr!("at least 1"));
                return Err((from, fault));
            }
            Some((from, length)) => {
                let length = length as usize;
                steps.add(length).map_err(|fault| (from, fault))?;
                moves.resize(moves.len() + length, step);
            }
        }
    }
    if run.is_some() {
        let fault = Fault::at("", tr!("the end of the path"), tr!("u, d, l, r or w"));
        return Err((path.len(), fault));
    }
    moves.shrink_to_fit();
    Ok(moves)
}

fn longer(run: u32, digit: u8) -> Option<u32> {
    let run = run.checked_mul(10)?.checked_add(u32::from(digit - b'0'))?;
    i32::try_from(run).is_ok().then_some(run)
}

fn long(from: usize) -> (usize, Fault) {
    let found = tr!("a run of over 2147483647 steps");
    (from, Fault::at("", found, tr!("at most 2147483647")))
}

fn letter(path: &str, at: usize) -> Fault {
    let letter = path.get(at..).and_then(|rest| rest.chars().next());
    let found = match letter {
        Some(letter) if !letter.is_control() => format!("\"{letter}\""),
        _ => tr!("a control character").to_owned(),
    };
    Fault::at("", found, tr!("u, d, l, r, w or a run length"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_walked_as_long_as_it_says() {
        let mut steps = Steps::default();
        let moves = read("2rud12w", &mut steps).map_err(|(at, _)| at);
        assert_eq!(moves.map(|moves| moves.len()), Ok(16));
    }

    #[test]
    fn what_is_wrong_has_its_byte() {
        for (path, at) in [("rux", 2), ("r3", 2), ("r0w", 1), ("rd999999999999w", 2)] {
            let read = read(path, &mut Steps::default()).map_err(|(at, _)| at);
            assert_eq!(read, Err(at), "{path}");
        }
        // Two billion steps are refused before there is room for them.
        let read = read("uu2000000000r", &mut Steps::default());
        assert_eq!(read.map_err(|(at, _)| at), Err(2));
    }
}
