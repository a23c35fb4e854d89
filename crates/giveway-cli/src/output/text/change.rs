//! The answer of `change` as text.

use std::fmt::Write as _;

use giveway_model::{
    Cost, Costs, Instance,
    change::{Changes, History},
    words::name,
};
use giveway_solve::{
    Status,
    change::{ChangeAnswer, Method, MethodAnswer, Methods, names, notes},
    words::reason as reason_in_words,
};

use super::{bold, status_word, title};
use crate::output::{map, plain, table, words};

/// Columns of the names of rows.
const LABEL: usize = 16;
/// Columns of a method.
const COLUMN: usize = 12;
/// A number of agents in an answer.
type Count = fn(&MethodAnswer) -> usize;

/// Each time with its methods side by side; then the plan adopted last.
pub(crate) fn change(
    instance: &Instance,
    changes: &Changes,
    answer: &ChangeAnswer,
    columns: usize,
) -> String {
    let mut parts = vec![title(instance)];
    for step in &answer.history {
        parts.push(time(
            step.at,
            step.before.as_ref(),
            &step.methods,
            step.adopted,
        ));
    }
    match answer.at {
        Some(at) => {
            let before = answer.before.as_ref();
            parts.push(time(at, before, &answer.methods, answer.adopted));
        }
        None => parts.push("The plan already knows all of these changes.\n".to_owned()),
    }
    if let Some(plan) = answer
        .adopted()
        .and_then(|method| method.result.plan.as_ref())
    {
        let mut changes = changes.clone();
        changes
            .changes
            .retain(|change| Some(change.at) <= answer.at);
        if let Ok(history) = History::of(instance, &changes, plan) {
            parts.push(map::draw_over_time(instance, &history, columns));
            parts.push(table::draw_over_time(&history, plan, columns));
        }
    }
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

/// One time: the table of methods, their causes, the method adopted.
fn time(at: u32, before: Option<&Costs>, methods: &Methods, adopted: Option<Method>) -> String {
    let mut text = format!("{}\n", bold(&format!("Changes at time {at}")));
    text += &compared(before, methods);
    for (method, answer) in &methods.0 {
        text += &remarks(*method, answer);
    }
    match adopted {
        Some(method) => {
            let _ = writeln!(text, "Used: {method}.");
        }
        None => text += "No method has a plan, so later changes are not looked at.\n",
    }
    text
}

/// A column for the old plan, and one for each method.
fn compared(before: Option<&Costs>, methods: &Methods) -> String {
    let methods = &methods.0;
    let mut text = row(
        "",
        &mut ["before".to_owned()]
            .into_iter()
            .chain(methods.iter().map(|(method, _)| method.to_string())),
    );
    let status = methods.iter().map(|(_, answer)| {
        let word = match answer.result.status {
            Status::Optimal => "optimal",
            Status::Feasible => "feasible",
            Status::Impossible => "impossible",
            Status::Unknown => "unknown",
        };
        // Colour has no width, so it comes after the padding.
        status_word(answer.result.status, &plain::pad_left(word, COLUMN))
    });
    let _ = writeln!(
        text,
        "{}{}{}",
        plain::pad_right("plan", LABEL),
        plain::pad_left("", COLUMN),
        status.collect::<String>()
    );
    for cost in Cost::USUAL {
        let value = |costs: Option<&Costs>| {
            costs.map_or("-".to_owned(), |costs| costs.get(cost).to_string())
        };
        let values = methods
            .iter()
            .map(|(_, answer)| value(answer.result.costs.as_ref()));
        text += &row(name(cost), &mut [value(before)].into_iter().chain(values));
    }
    let groups: [(&str, Count); 5] = [
        ("kept", |answer| answer.kept.len()),
        ("re-timed", |answer| answer.retimed.len()),
        ("re-routed", |answer| answer.rerouted.len()),
        ("added", |answer| answer.added.len()),
        ("freed", |answer| answer.freed.len()),
    ];
    for (label, count) in groups {
        let counts = methods.iter().map(|(_, answer)| match answer.result.plan {
            Some(_) => count(answer).to_string(),
            None => "-".to_owned(),
        });
        text += &row(label, &mut [String::new()].into_iter().chain(counts));
    }
    let seconds = methods
        .iter()
        .map(|(_, it)| format!("{:.2}", it.result.stats.cpu_seconds));
    text += &row(
        "CPU seconds",
        &mut [String::new()].into_iter().chain(seconds),
    );
    let conflicts = methods
        .iter()
        .map(|(_, it)| it.result.stats.conflicts.to_string());
    text += &row(
        "conflicts",
        &mut [String::new()].into_iter().chain(conflicts),
    );
    text
}

fn row(label: &str, entries: &mut dyn Iterator<Item = String>) -> String {
    let mut line = plain::pad_right(label, LABEL);
    for entry in entries {
        // A long one still stands apart from the one before it.
        line.push(' ');
        line += &plain::pad_left(&entry, COLUMN - 1);
    }
    line.trim_end().to_owned() + "\n"
}

/// Why agents were freed, why there is no plan, what is not proved.
fn remarks(method: Method, answer: &MethodAnswer) -> String {
    let mut text = String::new();
    let reason = answer.result.reason.clone();
    let early = reason.filter(|_| answer.cause.is_none() && answer.result.plan.is_some());
    let early = early.as_ref().map(reason_in_words);
    for note in notes(answer).into_iter().chain(early) {
        let _ = writeln!(text, "{method}: {}", words::sentence(&note));
    }
    let disturbed = [&answer.retimed, &answer.rerouted];
    for (what, agents) in ["re-timed", "re-routed"].into_iter().zip(disturbed) {
        if !agents.is_empty() {
            let _ = writeln!(text, "{method}: {what} {}.", plain::text(&names(agents)));
        }
    }
    if answer.result.plan.is_some() && !answer.closest {
        let _ = writeln!(
            text,
            "{method}: an equally good plan might change the plans of fewer robots."
        );
    }
    text
}
