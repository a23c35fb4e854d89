//! The answer of a planner of the textbook as text.

use std::fmt::Write as _;

use giveway_model::{Cost, Instance, words::name};
use giveway_solve::Status;
use giveway_solve::plan::{PlanAnswer, PlanEnd, words};

use super::{drawings, status_word, title};
use crate::output::plain;

/// The whole answer: how it ended, the costs, the map, the plan, the work.
pub(crate) fn planned(instance: &Instance, answer: &PlanAnswer, columns: usize) -> String {
    let mut parts = vec![title(instance), ended(answer)];
    if answer.costs.is_some() {
        parts.push(costs(answer));
    }
    parts.push(drawings(instance, answer.plan.as_ref(), columns));
    parts.push(work(answer));
    parts.join("\n")
}

/// How it ended, and what is to be said beside.
fn ended(answer: &PlanAnswer) -> String {
    let headline = words::headline(answer);
    let colour = match answer.ended {
        PlanEnd::Best { .. } => Status::Optimal,
        PlanEnd::Alone { .. } => Status::Impossible,
        _ => Status::Feasible,
    };
    let word = status_word(colour, &plain::text(&headline.word));
    let mut text = format!("{word}{}\n", plain::text(&headline.rest));
    for note in words::notes(answer) {
        text += &plain::text(&note);
        text.push('\n');
    }
    text
}

/// All five costs, those of the objective first.
fn costs(answer: &PlanAnswer) -> String {
    let costs = answer.costs.unwrap_or_default();
    let first = answer.objective.costs();
    let others = Cost::USUAL.iter().filter(|cost| !first.contains(cost));
    let mut text = format!("{:<14}{:>8}{:>18}\n", "cost", "value", "proved at least");
    for &cost in first.iter().chain(others) {
        let bound = answer.bounds.get(&cost);
        let at_least = bound.map_or_else(|| "-".to_owned(), u32::to_string);
        let (name, n) = (plain::pad_right(name(cost), 14), costs.get(cost));
        let _ = writeln!(text, "{name}{n:>8}{at_least:>18}");
    }
    text
}

/// How much work it took.
fn work(answer: &PlanAnswer) -> String {
    let planner = answer.planner;
    format!(
        "{}: {:.2} s CPU, {} {}\n",
        planner.title(),
        answer.stats.cpu_seconds,
        answer.stats.steps,
        planner.steps(answer.stats.steps)
    )
}
