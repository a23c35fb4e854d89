//! Which rows a filter leaves, and in which order texts with numbers stand.

use std::cmp::Ordering;

use giveway_model::tr;

use super::{Column, Row};

/// Whether a row has all that a filter asks for: `start 37`, `waits > 0`, `no battery`, a name.
pub(super) fn fits(row: &Row, filter: &str) -> bool {
    let filter = filter.trim().to_lowercase();
    if filter.is_empty() {
        return true;
    }
    let (is_none, filter) = without_no(&filter);
    let Some((column, rest)) = named(filter) else {
        return row
            .text(Column::Name)
            .is_some_and(|name| name.to_lowercase().contains(filter));
    };
    let text = row.text(column).unwrap_or_default();
    if is_none {
        return text.is_empty();
    }
    if let Some((compares, number)) = comparison(rest) {
        let pair = number.parse::<u32>().ok().zip(text.parse::<u32>().ok());
        return pair.is_some_and(|(number, own)| compares(own.cmp(&number)));
    }
    match (super::read::numbers(rest), super::read::numbers(text)) {
        (Some(wanted), Some(own)) if !wanted.is_empty() => wanted.iter().all(|n| own.contains(n)),
        _ => !text.is_empty() && text.to_lowercase().contains(rest),
    }
}

/// Whether the order of a row's number and that of a filter is as the filter asks.
type Compares = fn(Ordering) -> bool;

/// How a filter compares, and with what: `>= 65`.
fn comparison(rest: &str) -> Option<(Compares, &str)> {
    const SIGNS: [(&str, Compares); 6] = [
        (">=", Ordering::is_ge),
        ("\u{2265}", Ordering::is_ge),
        ("<=", Ordering::is_le),
        ("\u{2264}", Ordering::is_le),
        (">", Ordering::is_gt),
        ("<", Ordering::is_lt),
    ];
    SIGNS.into_iter().find_map(|(sign, compares)| {
        let number = rest.strip_prefix(sign)?;
        Some((compares, number.trim()))
    })
}

/// The column that a filter asks about; `None` where it asks for a name.
pub(super) fn column(filter: &str) -> Option<Column> {
    let filter = filter.trim().to_lowercase();
    let (_, filter) = without_no(&filter);
    named(filter).map(|(column, _)| column)
}

/// Whether a filter asks for what has nothing there, and the rest of it.
fn without_no(filter: &str) -> (bool, &str) {
    let no = format!("{} ", tr!("in a filter: no battery" => "no"));
    match filter.strip_prefix(&no) {
        Some(rest) => (true, rest),
        None => (false, filter),
    }
}

/// The column at the beginning of a filter in small letters, and what is asked of it.
fn named(filter: &str) -> Option<(Column, &str)> {
    Column::ALL.into_iter().find_map(|column| {
        let rest = filter.strip_prefix(&column.name().to_lowercase())?;
        Some((column, rest.trim()))
    })
}

/// The order of texts in which numbers count as such: A2 before A10. What is empty is last.
pub(super) fn by_nature(one: &str, other: &str) -> Ordering {
    let parts = |text: &str| {
        let mut parts: Vec<(u64, String)> = Vec::new();
        for c in text.chars() {
            match (c.to_digit(10), parts.last_mut()) {
                (Some(digit), Some((number, word))) if word.is_empty() => {
                    *number = number.saturating_mul(10).saturating_add(digit.into());
                }
                (Some(digit), _) => parts.push((digit.into(), String::new())),
                (None, Some((_, word))) if !word.is_empty() => word.push(c),
                (None, _) => parts.push((0, c.to_string())),
            }
        }
        parts
    };
    (one.is_empty(), parts(one)).cmp(&(other.is_empty(), parts(other)))
}
