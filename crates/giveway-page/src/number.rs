//! Whole numbers that a person types: which are possible, and what becomes of others.

use giveway_model::tr;

/// The number that was typed; `None` where it is not between two, both included.
///
/// ```
/// use giveway_page::number::{possible, read, taken};
/// assert_eq!(read(" 12 ", (1, 512)), Some(12));
/// assert_eq!(read("99999999999", (1, 512)), None);
/// assert_eq!(possible((1, 512)), "Possible: 1 to 512.");
/// // A field keeps what it had: another number than the one typed would be a surprise.
/// assert_eq!(taken("99999999999", Some(5), (1, 512)), Some(5));
/// assert_eq!(taken("999", Some(5), (1, 512)), Some(5));
/// assert_eq!(taken("512", Some(5), (1, 512)), Some(512));
/// ```
pub fn read(typed: &str, (least, most): (u32, u32)) -> Option<u32> {
    let number = typed.trim().parse().ok()?;
    (least..=most).contains(&number).then_some(number)
}

/// What a field with a value holds after something was typed in it: that number where it is
/// possible, else what it held before.
pub fn taken(typed: &str, value: Option<u32>, range: (u32, u32)) -> Option<u32> {
    read(typed, range).or(value)
}

/// Which numbers are possible, as a sentence.
pub fn possible((least, most): (u32, u32)) -> String {
    tr!("Possible: {least} to {most}.", least, most)
}
