//! An order of prioritised planning in words.

use giveway_model::tr;
use giveway_model::words::and;

use super::is_stuck;
use crate::plan::OrderTried;

/// Around whom the agent at a place of an order plans: those before it.
pub fn around(order: &OrderTried, place: usize) -> String {
    let before = order.order.get(..place).unwrap_or_default();
    let before: Vec<&str> = before.iter().map(String::as_str).collect();
    match before.as_slice() {
        [] => tr!("plans freely").to_owned(),
        [one] => tr!("plans around {one}", one),
        [_, _] => tr!("around {others}", others = and(&before)),
        more => tr!("around {more} before it", more = more.len()),
    }
}

/// Why whoever is stuck is: whom it cannot get past, and how far it comes. Nothing
/// where the order works.
pub fn why_stuck(order: &OrderTried) -> Option<String> {
    let stuck = order.stuck.as_ref()?;
    let stuck = is_stuck(stuck);
    let Some(end) = order.furthest.last().copied().flatten() else {
        return Some(format!("{stuck}."));
    };
    let last = order.furthest.len() - 1;
    Some(if order.dead_end {
        let next = last + 1;
        tr!(
            "{stuck}. At time {last} it stands at {end}, and has no free cell at time {next}.",
            stuck,
            last,
            end,
            next
        )
    } else {
        tr!(
            "{stuck}. It comes as near as {end} at time {last}, and no further.",
            stuck,
            end,
            last
        )
    })
}
