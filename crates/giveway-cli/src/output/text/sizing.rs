//! The answer of `sizing` as text.

use std::fmt::Write as _;

use giveway_model::Instance;
use giveway_solve::Status;
use giveway_solve::sizing::{SizingAnswer, SizingPoint, findings, words};

use super::{bold, solve::work, status_word, title};
use crate::output::plain;

/// A line for each number of robots, and what follows from the figures.
pub(crate) fn sizing(instance: &Instance, answer: &SizingAnswer) -> String {
    let mut text = format!("{}\n{}\n", title(instance), bold("How many robots?"));
    let _ = writeln!(
        text,
        "  robots  last arrival  sum of costs  mean delay  still open"
    );
    for (place, point) in answer.points.iter().enumerate() {
        let _ = writeln!(text, "{}", row(answer, point, ""));
        if let Some(other) = answer.beside.get(place) {
            let _ = writeln!(text, "{}", row(answer, other, " beside"));
        }
    }
    if answer.pending > 0 {
        let _ = writeln!(text, "  {} more were not begun.", answer.pending);
    }
    let found = findings(answer);
    if !found.is_empty() {
        text.push('\n');
    }
    for it in &found {
        let sentence = words::finding(it, "the other floor");
        let _ = writeln!(text, "{}", plain::text(&sentence));
    }
    text.push('\n');
    text + &work(&answer.stats)
}

fn row(answer: &SizingAnswer, point: &SizingPoint, floor: &str) -> String {
    let number = |n: Option<u32>| n.map_or_else(|| "-".to_owned(), |n| n.to_string());
    let costs = point.costs;
    let delay = point.mean_delay(&answer.objective);
    let open = point.open_share(&answer.objective);
    let word = match point.status {
        Status::Optimal => "proved",
        Status::Feasible => "best so far",
        Status::Impossible => "no plan",
        Status::Unknown => "not solved in time",
    };
    format!(
        "  {:>6}  {:>12}  {:>12}  {:>10}  {:>10}  {}{floor}",
        point.robots,
        number(costs.map(|costs| costs.makespan)),
        number(costs.map(|costs| costs.sum_of_costs)),
        delay.map_or_else(|| "-".to_owned(), |(mean, _)| format!("{mean:.1}")),
        open.map_or_else(|| "-".to_owned(), percent),
        status_word(point.status, word),
    )
}

/// A share in per cent, rounded up to a tenth.
fn percent(share: f64) -> String {
    format!("{:.1} %", (share * 1000.0).ceil() / 10.0)
}
