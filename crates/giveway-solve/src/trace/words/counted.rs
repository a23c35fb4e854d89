//! What counting at a bottleneck shows, in a sentence.

use giveway_model::words::value;
use giveway_model::{Cell, Cost, tr};

use super::names::who;
use crate::trace::Bottleneck;

/// What counting shows.
pub(super) fn counted((cost, at_least): (Cost, u32), agents: &[String], at: &Bottleneck) -> String {
    let robots = who(agents);
    let cost = value(cost, at_least);
    match at {
        Bottleneck::Passage(cells) => {
            let (first, last) = (cells.first(), cells.last());
            let at = |cell: Option<&Cell>| cell.map_or_else(String::new, Cell::to_string);
            if first == last {
                tr!(
                    "{robots} have to pass {cell}, one after the other: no plan has less than {cost}.",
                    robots,
                    cell = at(first),
                    cost
                )
            } else {
                tr!(
                    "{robots} have to pass from {first} to {last}, one after the other: no plan has less than {cost}.",
                    robots,
                    first = at(first),
                    last = at(last),
                    cost
                )
            }
        }
        Bottleneck::Zone { rule, most } => tr!(
            "{robots} have to pass the zone of rule {number}, at most {most} at a time: no plan has less than {cost}.",
            robots,
            number = rule + 1,
            most,
            cost
        ),
    }
}
