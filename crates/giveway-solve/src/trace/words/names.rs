//! Robots in a row: by their names, or by how many there are.

use giveway_model::tr;
use giveway_model::words::{and, capital};

/// More robots are counted instead of named.
pub(super) const MOST_NAMES: usize = 4;

/// Names, or how many there are, at the beginning of a sentence.
pub(super) fn who<S: AsRef<str>>(names: &[S]) -> String {
    if names.len() <= MOST_NAMES {
        and(names)
    } else {
        capital(&in_a_row(names))
    }
}

/// The same in the middle of a sentence.
pub(super) fn in_a_row<S: AsRef<str>>(names: &[S]) -> String {
    if names.len() <= MOST_NAMES {
        return and(names);
    }
    let number = match names.len() {
        5 => tr!("five robots"),
        6 => tr!("six robots"),
        7 => tr!("seven robots"),
        8 => tr!("eight robots"),
        9 => tr!("nine robots"),
        10 => tr!("ten robots"),
        11 => tr!("eleven robots"),
        12 => tr!("twelve robots"),
        n => return tr!("{n} robot" | "{n} robots" % n),
    };
    number.to_owned()
}
