//! A battery as it was typed: how much it holds, and the level that it begins with.

use giveway_model::{Battery, tr};

use super::fault::fault;
use super::{Column, Fault};

/// The largest battery, in steps.
pub const CAPACITY: u32 = 100_000;

/// A battery as it was given; empty is unlimited.
pub(super) fn battery(
    capacity: Option<&str>,
    level: Option<&str>,
    old: Option<Battery>,
) -> Result<Option<Battery>, Fault> {
    let read = |text: &str| crate::number::read(text, (0, CAPACITY));
    let possible = crate::number::possible((0, CAPACITY));
    let is_none = |text: &str| matches!(text, "" | "-" | "\u{2013}" | "\u{2014}" | "\u{221e}");
    let capacity = match capacity {
        Some(text) if is_none(text) => None,
        Some(text) => Some(read(text).ok_or_else(|| fault(Column::Battery, &possible, None))?),
        None => old.map(|battery| battery.capacity),
    };
    let level = match level.filter(|text| !is_none(text)) {
        Some(text) => Some(read(text).ok_or_else(|| fault(Column::Level, &possible, None))?),
        None => None,
    };
    match (capacity, level) {
        (None, None) => Ok(None),
        (None, Some(level)) => Err(Fault {
            column: Column::Level,
            why: tr!("It has no battery that could begin with {level}.", level),
            remedy: Some((tr!("Leave it empty").to_owned(), String::new())),
            place: None,
        }),
        (Some(capacity), Some(level)) if level > capacity => Err(Fault {
            column: Column::Level,
            why: tr!("The battery holds {capacity}.", capacity),
            remedy: Some((tr!("Use {capacity}", capacity), capacity.to_string())),
            place: None,
        }),
        (Some(capacity), level) => Ok(Some(Battery {
            capacity,
            initial: level.unwrap_or_else(|| old.map_or(capacity, |old| old.initial.min(capacity))),
        })),
    }
}
