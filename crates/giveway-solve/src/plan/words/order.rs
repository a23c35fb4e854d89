//! What came of an order of prioritised planning, in words.

use giveway_model::words::and;

use super::is_stuck;
use crate::plan::OrderTried;

/// Around whom the agent at a place of an order plans: those before it.
pub fn around(order: &OrderTried, place: usize) -> String {
    let before = order.order.get(..place).unwrap_or_default();
    let before: Vec<&str> = before.iter().map(String::as_str).collect();
    match before.as_slice() {
        [] => "plans freely".to_owned(),
        [one] => format!("plans around {one}"),
        [_, _] => format!("around {}", and(&before)),
        more => format!("around {} before it", more.len()),
    }
}

/// Why whoever is stuck is: whom it cannot get past, and how far it comes. Nothing
/// where the order works.
pub fn why_stuck(order: &OrderTried) -> Option<String> {
    let stuck = order.stuck.as_ref()?;
    let mut text = format!("{}.", is_stuck(stuck));
    if let Some(end) = order.furthest.last().copied().flatten() {
        let last = order.furthest.len() - 1;
        text += &if order.dead_end {
            format!(
                " At time {last} it stands at {end}, and has no free cell at time {}.",
                last + 1
            )
        } else {
            format!(" It comes as near as {end} at time {last}, and no further.")
        };
    }
    Some(text)
}
